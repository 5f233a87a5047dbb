#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "cli/building_options.h"
#include "cli/commands.h"
#include "files/atomic_file.h"
#include "files/canvas.h"
#include "files/map_server.h"
#include "grid/for_each_cell.h"
#include "output/wall_files.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/exploration.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

struct NextOptions {
  std::string map;
  std::string from;
  double yaw_deg = 0.0;
  std::int64_t count = 5;
  std::string output;
  ExplorationConfig robot;
};

constexpr Colour kWall{0.55, 0.00, 0.00};
constexpr Colour kWay{0.20, 0.50, 0.90};
constexpr Colour kGoal{0.10, 0.60, 0.20};

/// Reads a map, and of the recording beside it what is there: way, touches and access points.
ExplorationView readView(const std::string& directory) {
  ExplorationView view{readMap(directory + "/map.yaml"),
                       readProbabilities(directory + "/probability.yaml"),
                       readWalls(directory + "/walls.yaml")};
  if (view.states.geometry != view.occupied.geometry) {
    throw InputError(directory +
                     ": map.yaml and probability.yaml are of different maps; make the "
                     "map again with sfw map");
  }
  // A probability of exactly one half stands for unknown.
  for (float& p : view.occupied.cells) {
    p = p == 0.5F ? std::nanf("") : p;
  }
  const std::string table = directory + "/access_points.yaml";
  if (std::filesystem::exists(table)) {
    for (const AccessPoint& access_point : readAccessPoints(table).access_points) {
      if (access_point.position_known) {
        view.access_points.push_back(access_point.position);
      }
    }
  }
  const std::string readings = directory + "/readings.csv";
  if (std::filesystem::exists(readings)) {
    std::vector<PathPose> path;
    for (const Reading& row : readReadings(readings).readings) {
      path.push_back({row.stamp_ns, row.antenna_in_map});
    }
    std::stable_sort(path.begin(), path.end(),
                     [](const PathPose& a, const PathPose& b) { return a.stamp_ns < b.stamp_ns; });
    for (const PathPose& pose : path) {
      view.way.push_back(pose.antenna_in_map);
    }
    const std::string contacts = directory + "/contacts.csv";
    if (std::filesystem::exists(contacts)) {
      view.touches = touchesOf(readContacts(contacts), path);
    }
  }
  return view;
}

RobotPose startOf(const NextOptions& options, const ExplorationView& view) {
  RobotPose pose;
  pose.yaw_rad = options.yaw_deg * kPi / 180.0;
  if (!options.from.empty()) {
    pose.position = parsePosition("--from", options.from);
  } else if (!view.way.empty()) {
    pose.position = view.way.back();
  } else {
    throw InputError(options.map +
                     " has no readings.csv that tells where the robot is; give --from");
  }
  return pose;
}

std::string picture(const ExplorationView& view, const RobotPose& robot,
                    const std::vector<ExplorationGoal>& goals) {
  Box area{robot.position};
  forEachCell(view.states.geometry, [&](Cell c) {
    if (view.states[c] != CellState::kUnknown) {
      area.extend(view.states.geometry.centre(c));
    }
  });
  for (const ExplorationGoal& goal : goals) {
    area.extend(goal.position);
  }
  const Position air(0.5, 0.5);
  Canvas canvas(Box(area.min() - air, area.max() + air));
  const auto fill = [&](CellState state, const Colour& colour) {
    canvas.fillCells(view.states.geometry, colour, [&](Cell c) { return view.states[c] == state; });
  };
  fill(CellState::kFree, Canvas::kFree);
  fill(CellState::kOccupied, Canvas::kOccupied);
  for (const WallSegment& wall : view.walls) {
    canvas.drawLine(wall.from, wall.to, kWall, 1.0 + 4.0 * wall.confidence);
  }
  canvas.drawAxes();
  for (const Position& access_point : view.access_points) {
    canvas.drawAccessPoint(access_point, "");
  }
  std::vector<std::pair<Position, Colour>> dots{{robot.position, kWay}};
  for (auto goal = goals.rbegin(); goal != goals.rend(); ++goal) {
    const bool best = &*goal == &goals.front();
    for (std::size_t i = 1; i < goal->way.size(); ++i) {
      canvas.drawLine(goal->way[i - 1], goal->way[i], kWay, best ? 3.0 : 1.0);
    }
    dots.emplace_back(goal->position, kGoal);
  }
  canvas.drawDots(dots);
  canvas.drawFooter("the best drive is the thick line",
                    {{kGoal, "goal", true}, {kWay, "robot and ways", true}, {kWall, "wall"}});
  return canvas.png();
}

void run(const NextOptions& options) {
  const ExplorationView view = readView(options.map);
  const RobotPose robot = startOf(options, view);
  const std::vector<ExplorationGoal> goals =
      rankGoals(view, robot, options.robot, static_cast<std::size_t>(options.count));
  std::printf("rank,x,y,gain_m2_s,travel_s,area_m2,walls_m2,arrival\n");
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const ExplorationGoal& goal = goals[i];
    std::printf("%zu,%.2f,%.2f,%.3f,%.1f,%.2f,%.2f,%.2f\n", i + 1, goal.position.x(),
                goal.position.y(), goal.rate_m2_s, goal.travel_s, goal.area_m2, goal.walls_m2,
                goal.arrival);
  }
  std::fflush(stdout);
  for (const ExplorationGoal& goal : goals) {
    std::cerr << "sfw: (" << goal.position.x() << ", " << goal.position.y()
              << "): " << goal.reason() << '\n';
  }
  if (goals.empty()) {
    std::cerr << "sfw: nothing more is worth a drive\n";
  }
  const std::string file = options.output.empty() ? options.map + "/next.png" : options.output;
  writeAtomically(file, picture(view, robot, goals));
  std::cerr << "sfw: drew the goals in " << file << '\n';
}

}  // namespace

void runNext(Options& options) {
  NextOptions next;
  options.addRequired("map", "DIRECTORY", next.map,
                      "map of sfw map or ~save_map; readings.csv, contacts.csv and "
                      "access_points.yaml beside it count too");
  options.add("from", "X,Y", next.from,
              "where the robot is [m]; by default at the last one of readings.csv");
  options.add("yaw", "DEGREES", next.yaw_deg, "its heading, counter-clockwise from x");
  options.addInRange("count", next.count, 1, 100, "number of goals");
  options.add("robot-radius", "METRES", next.robot.robot_radius_m, "radius of the robot [m]");
  options.add("speed", "METRES", next.robot.speed_m_s, "its speed [m/s]");
  options.add("output", "FILE", next.output, "PNG of the goals; by default next.png in the map");
  if (options.parse()) {
    run(next);
  }
}

}  // namespace sfw
