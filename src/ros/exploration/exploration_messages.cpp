#include "ros/exploration/exploration_messages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "files/text.h"
#include "ros/conversion/markers.h"
#include "ros/conversion/message_conversion.h"

namespace sfw {
namespace {

constexpr Colour kGreen{0.10, 0.60, 0.20};

GridGeometry geometryOf(const nav_msgs::MapMetaData& info) {
  return GridGeometry(static_cast<double>(info.resolution),
                      Position(info.origin.position.x, info.origin.position.y), info.width,
                      info.height);
}

}  // namespace

std::string problemOf(const nav_msgs::OccupancyGrid& grid, const std::string& map_frame) {
  constexpr double kFarthest = 1e5;                   // of the origin [m]
  constexpr float kFinest = 0.01F, kCoarsest = 1.0F;  // cells [m]
  const auto& info = grid.info;
  const auto& origin = info.origin;
  const auto cells = static_cast<std::size_t>(info.width) * info.height;
  if (grid.header.frame_id != map_frame) {
    return "its frame is '" + grid.header.frame_id + "', and not ~map_frame, '" + map_frame + "'";
  }
  if (cells == 0 || cells != grid.data.size()) {
    return "its data do not fit its width and height";
  }
  if (!(info.resolution >= kFinest) || !(info.resolution <= kCoarsest) ||
      !(origin.position.x * origin.position.x + origin.position.y * origin.position.y <
        kFarthest * kFarthest)) {
    return "its resolution or origin is out of range: cells have 0.01 to 1 m, and the origin lies "
           "within 100 km";
  }
  if (std::abs(origin.orientation.z) > 1e-6 || std::abs(origin.orientation.x) > 1e-6 ||
      std::abs(origin.orientation.y) > 1e-6) {
    return "it is turned against its frame";
  }
  return {};
}

std::optional<ExplorationView> viewOf(const MapMessages& messages) {
  if (!messages.map || !messages.probability ||
      !haveSameGeometry(messages.map->info, messages.probability->info)) {
    return std::nullopt;
  }
  const GridGeometry geometry = geometryOf(messages.map->info);
  ExplorationView view{Grid<CellState>(geometry), Grid<float>(geometry), {}};
  constexpr int kHalf = 50;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const int state = messages.map->data[i];
    const int percent = messages.probability->data[i];
    view.states.cells[i] = state < 0       ? CellState::kUnknown
                           : state < kHalf ? CellState::kFree
                                           : CellState::kOccupied;
    view.occupied.cells[i] = percent < 0 ? std::numeric_limits<float>::quiet_NaN()
                                         : static_cast<float>(percent) / 100.0F;
  }
  constexpr double kFar = 100.0;  // beyond the map nothing belongs to it [m]
  Box near = geometry.box();
  near.extend(Position(near.min().array() - kFar)).extend(Position(near.max().array() + kFar));
  if (messages.walls) {
    for (const auto& wall : messages.walls->walls) {
      if (!near.contains(Position(wall.start.x, wall.start.y)) ||
          !near.contains(Position(wall.end.x, wall.end.y)) || !(wall.confidence > 0.0F) ||
          !(wall.confidence < 1.0F)) {
        continue;
      }
      view.walls.push_back({Position(wall.start.x, wall.start.y), Position(wall.end.x, wall.end.y),
                            static_cast<double>(wall.confidence), wall.outer != 0});
    }
  }
  if (messages.access_points) {
    for (const auto& access_point : messages.access_points->access_points) {
      const Position at(access_point.position.x, access_point.position.y);
      if (at.allFinite()) {
        view.access_points.push_back(at);
      }
    }
  }
  return view;
}

visualization_msgs::MarkerArray toMarkers(const std::vector<ExplorationGoal>& goals,
                                          const std::optional<ExplorationGoal>& goal,
                                          const std_msgs::Header& header) {
  using visualization_msgs::Marker;
  constexpr double kHeight = 0.2;  // above the map [m]
  constexpr double kAside = 0.3;   // of texts from their goals [m]
  constexpr double kLetterHeight = 0.25;
  constexpr double kWidth = 0.06;  // of the way [m]
  visualization_msgs::MarkerArray array;
  array.markers.push_back(marker(header, "goals", 0, Marker::SPHERE, 0.0, kGreen));
  array.markers.back().action = Marker::DELETEALL;
  int id = 0;
  for (const ExplorationGoal& one : goals) {
    const double share = one.rate_m2_s / std::max(goals.front().rate_m2_s, 1e-9);
    array.markers.push_back(marker(header, "goals", id, Marker::SPHERE, 0.1 + 0.2 * share, kGreen));
    array.markers.back().pose.position = toPoint(one.position, kHeight);
    const std::string text =
        formatted("%.1f m2 in %.0f s", one.area_m2 + one.walls_m2, one.travel_s);
    const Position beside = one.position + Position(0.0, kAside);
    array.markers.push_back(
        label(header, "gains", id, text, toPoint(beside, kHeight), kGreen, kLetterHeight));
    ++id;
  }
  if (goal && goal->way.size() > 1) {
    Marker way = marker(header, "way", 0, Marker::LINE_STRIP, kWidth, kGreen);
    way.scale.y = way.scale.z = 0.0;  // a line has a width alone
    for (const Position& at : goal->way) {
      way.points.push_back(toPoint(at, kHeight));
    }
    array.markers.push_back(way);
  }
  return array;
}

}  // namespace sfw
