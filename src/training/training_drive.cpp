#include "training/training_drive.h"

#include <algorithm>
#include <cmath>

#include "base/random_streams.h"
#include "grid/morphology.h"
#include "k_visibility/k_visibility.h"
#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/input_error.h"
#include "training/disturbance.h"
#include "training/training_world.h"

namespace sfw {
namespace {

bool happens(double probability, Random& random) { return random.uniform() <= probability; }

/// The building as the robot finds it: often with furniture, which blocks the robot alone.
FloorPlan withFurniture(const FloorPlan& walls, DrivingStyle style, Random& random) {
  const double share = style == DrivingStyle::kAlongWalls ? 0.7
                       : style == DrivingStyle::kPatrol   ? 0.5
                                                          : 0.0;
  FloorPlan furnished = walls;
  if (happens(share, random)) {
    furnish(furnished, random);
  }
  return furnished;
}

/// Changes the planned route as drivers of the style would.
void varyRoute(DrivingStyle style, double robot_radius_m, Scenario& scenario, Random& random) {
  if (style == DrivingStyle::kAlongWalls && happens(0.7, random)) {
    scenario.way_points =
        withHumanSteering(scenario.way_points, scenario.plan, robot_radius_m + 0.03, random);
  } else if (style == DrivingStyle::kStroll) {
    const double clearance_m = robot_radius_m + random.uniform(0.0, 0.6);
    scenario.way_points = withRandomWalks(scenario.way_points, scenario.plan, clearance_m, random);
  }
}

/// Keeps only a part of the drive, chosen at random.
void shorten(std::vector<Reading>& readings, Random& random) {
  const double share = random.uniform(0.2, 0.9);
  const double begin = random.uniform(0.0, 1.0 - share);
  const auto index = [&](double at) {
    return static_cast<std::ptrdiff_t>(at * static_cast<double>(readings.size()));
  };
  readings = {readings.begin() + index(begin), readings.begin() + index(begin + share)};
}

}  // namespace

NoiseLevel chooseNoise(Random& random) {
  const double draw = random.uniform();
  return noiseLevel(draw < 0.04   ? "none"
                    : draw < 0.14 ? "low"
                    : draw < 0.26 ? "moderate"
                    : draw < 0.82 ? "realistic"
                                  : "hard");
}

std::int64_t chooseCount(double most, Random& random) {
  return static_cast<std::int64_t>(std::pow(most + 1.0, random.uniform(0.0, 0.999)));
}

void varyRadio(RadioModel::Config& radio, Random& random) {
  // Measured losses of walls in homes range from 1.4 to 8.3 dB. The first fits of saturation,
  // shadowing and its reach differ as much.
  constexpr double kLittleShadowing = 2.0;  // [dB]
  radio.interior_wall_loss_db = random.uniform(2.0, 11.0);
  radio.outer_wall_loss_db = radio.interior_wall_loss_db * random.uniform(1.0, 2.0);
  if (radio.shadowing_db > kLittleShadowing) {
    radio.shadowing_db = random.uniform(2.0, 6.0);
    radio.shadowing_distance_m = random.uniform(0.4, 1.6);
  }
  if (radio.max_obstacle_loss_db > 0.0) {
    radio.max_obstacle_loss_db = random.uniform(8.0, 22.0);
  }
}

std::vector<Position> pathOf(const std::vector<Reading>& readings) {
  std::vector<Position> path;
  for (const Reading& reading : readings) {
    if (path.empty() || path.back() != reading.antenna_in_map) {
      path.push_back(reading.antenna_in_map);
    }
  }
  return path;
}

Grid<CellState> visibleStates(const std::vector<Position>& path, const Grid<CellState>& states) {
  constexpr double kSpacing = 0.8;    // [m], between the places that the lidar looks from
  constexpr double kWallDepth = 2.0;  // cells of a wall's face
  Mask seen(states.geometry);
  const Position* last = nullptr;
  for (const Position& position : path) {
    const Cell c = states.geometry.cellAt(position);
    if ((last != nullptr && (position - *last).norm() < kSpacing) || !states.geometry.contains(c) ||
        states[c] != CellState::kFree) {
      continue;
    }
    last = &position;
    const Grid<std::uint8_t> walls = forwardKVisibility(states, position);
    for (std::size_t i = 0; i < seen.cells.size(); ++i) {
      seen.cells[i] = seen.cells[i] != 0 || walls.cells[i] == 0 ? 1 : 0;
    }
  }
  const Mask near = dilated(seen, kWallDepth);
  Grid<CellState> truth(states.geometry, CellState::kUnknown);
  for (std::size_t i = 0; i < truth.cells.size(); ++i) {
    const bool visible =
        states.cells[i] == CellState::kFree ? seen.cells[i] != 0 : near.cells[i] != 0;
    truth.cells[i] = visible ? states.cells[i] : CellState::kUnknown;
  }
  return truth;
}

std::optional<TrainingDrive> simulateTrainingDrive(const FloorPlan& plan, DrivingStyle style,
                                                   const TrainingDriveSettings& settings,
                                                   Random& random) {
  ScenarioConfig config = settings.scenario;
  config.path = style == DrivingStyle::kAlongWalls ? "walls" : "sparse";
  const bool strolls = style == DrivingStyle::kStroll;
  const bool covers_all = settings.plain || !happens(strolls ? 0.25 : 0.6, random);
  FloorPlan walls = plan;
  if (!settings.plain && happens(strolls ? 0.3 : 0.7, random)) {
    cutOut(walls, random);
  }
  const FloorPlan furnished = settings.plain ? walls : withFurniture(walls, style, random);
  TrainingDrive drive{{}, {}, style, toStates(furnished), toStates(furnished)};
  try {
    Scenario scenario = makeScenario(furnished, {}, config);
    if (!settings.plain || strolls) {
      varyRoute(style, config.robot_radius_m, scenario, random);
    }
    if (settings.varies_radio) {
      varyRadio(scenario.recording.radio, random);
    }
    scenario.plan = walls;  // furniture weakens signals less than walls: the level has its own
    drive.readings = simulate(scenario).readings;
    drive.access_points = scenario.access_points;
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (!covers_all) {
    shorten(drive.readings, random);
  }
  if (drive.readings.empty()) {
    return std::nullopt;
  }
  drive.truth = visibleStates(pathOf(drive.readings), drive.building);
  return drive;
}

std::optional<TrainingDrive> makeTrainingDrive(const FloorPlan& plan, DrivingStyle style,
                                               std::int64_t seed) {
  Random random(seed, streamOf(Purpose::kTrainingDrive), 0);
  TrainingDriveSettings settings;
  settings.scenario.seed = seed;
  settings.scenario.noise = chooseNoise(random);
  settings.scenario.access_points = chooseCount(kMostAccessPoints, random);
  settings.scenario.robot_radius_m = random.uniform(0.01, 0.15);
  std::optional<TrainingDrive> drive = simulateTrainingDrive(plan, style, settings, random);
  if (drive) {
    disturb(*drive, settings.scenario.noise, seed);
  }
  return drive;
}

}  // namespace sfw
