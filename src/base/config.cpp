#include "structure_from_wifi/config.h"

#include <cmath>

#include "base/validation.h"

namespace sfw {
namespace {

void check(const Config::Map& config, Problems& problems) {
  problems.positive("map/resolution", config.resolution_m);
  problems.positive("map/margin", config.margin_m);
  problems.positive("map/growth_step", config.growth_step_m);
  problems.atLeast("map/max_cells", config.max_cells, 1);
  problems.atLeast("map/max_readings", config.max_readings, 1);
}

void check(const Config::KVisibility& config, Problems& problems) {
  problems.oneOf("k_visibility/filter", config.filter, {"median", "mean"});
  problems.require(config.window >= 1 && config.window % 2 == 1, "k_visibility/window",
                   config.window, "odd and at least 1");
  problems.notNegative("k_visibility/path_loss_exponent", config.path_loss_exponent);
  problems.within("k_visibility/wall_count", static_cast<double>(config.wall_count), 0.0, 20.0);
  problems.within("k_visibility/max_wall_count", static_cast<double>(config.max_wall_count), 1.0,
                  20.0);
  problems.positive("k_visibility/min_wall_loss", config.min_wall_loss_db);
  problems.positive("k_visibility/wall_thickness", config.wall_thickness_m);
  problems.probability("k_visibility/wall_prior", config.wall_prior);
}

void check(const Config::Tomography& config, Problems& problems) {
  problems.positive("tomography/bin_size", config.bin_size_m);
  const double limit_db = config.max_total_wall_loss_db;
  problems.require(limit_db == 0.0 || (std::isfinite(limit_db) && limit_db >= 1.0),
                   "tomography/max_total_wall_loss", limit_db, "0, or finite and at least 1 dB");
  problems.notNegative("tomography/l1_weight", config.l1_weight);
  problems.notNegative("tomography/smoothness_weight", config.smoothness_weight);
  problems.positive("tomography/nugget", config.nugget_db);
  problems.require(
      config.wall_directions >= 2 && config.wall_directions <= 8 && config.wall_directions % 2 == 0,
      "tomography/wall_directions", config.wall_directions, "2, 4, 6 or 8");
  problems.within("tomography/ensemble_size", static_cast<double>(config.ensemble_size), 1.0,
                  100.0);
}

void check(const Config::Path& config, Problems& problems) {
  problems.notNegative("path/footprint_radius", config.footprint_radius_m);
  problems.positive("path/max_gap", config.max_gap_m);
}

void check(const Config::Belief& config, Problems& problems) {
  problems.probability("belief/free_threshold", config.free_threshold);
  problems.probability("belief/occupied_threshold", config.occupied_threshold);
  // Probabilities are stored in steps of up to .016. With closer thresholds no cell could be
  // unknown.
  constexpr double kLeastApart = 0.05;
  problems.require(!(config.free_threshold > config.occupied_threshold - kLeastApart + 1e-9),
                   "belief/free_threshold", config.free_threshold,
                   "at least 0.05 lower than belief/occupied_threshold");
  problems.oneOf("belief/walls", config.walls, {"network", "none"});
  problems.oneOf("belief/rim", config.rim, {"unknown", "occupied"});
}

void check(const Config::Octomap& config, Problems& problems) {
  problems.positive("octomap/wall_height", config.wall_height_m);
  problems.positive("octomap/robot_height", config.robot_height_m);
}

}  // namespace

std::vector<std::string> validate(const Config& config) {
  Problems problems;
  problems.oneOf("method", config.method, {"tomography", "k_visibility"});
  check(config.map, problems);
  check(config.k_visibility, problems);
  check(config.tomography, problems);
  check(config.path, problems);
  check(config.belief, problems);
  check(config.octomap, problems);
  return problems.list();
}

}  // namespace sfw
