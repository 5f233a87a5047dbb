#include "structure_from_wifi/config.h"

#include <cmath>
#include <sstream>

namespace sfw {
namespace {

/// Collects one sentence for each rule that a setting breaks.
class Rules {
 public:
  template <class T>
  void require(bool holds, const char* name, const T& value, const char* rule) {
    if (!holds) {
      std::ostringstream text;
      text << name << " must be " << rule << "; it is " << value;
      problems_.push_back(text.str());
    }
  }
  void positive(const char* name, double value) {
    require(std::isfinite(value) && value > 0.0, name, value, "finite and positive");
  }
  void notNegative(const char* name, double value) {
    require(std::isfinite(value) && value >= 0.0, name, value, "finite and not negative");
  }
  void probability(const char* name, double value) {
    require(value > 0.0 && value < 1.0, name, value, "between 0 and 1, both excluded");
  }
  void atLeast(const char* name, std::int64_t value, std::int64_t least) {
    require(value >= least, name, value, ("at least " + std::to_string(least)).c_str());
  }
  void frame(const char* name, const std::string& value) {
    require(!value.empty() && value.front() != '/', name, "'" + value + "'",
            "a frame's name without a leading slash");
  }

  std::vector<std::string> problems() { return std::move(problems_); }

 private:
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> validate(const Config& config) {
  Rules rules;
  rules.require(config.method == "tomography" || config.method == "k_visibility", "method",
                "'" + config.method + "'", "'tomography' or 'k_visibility'");
  rules.positive("map/resolution", config.map.resolution_m);
  rules.positive("map/margin", config.map.margin_m);
  rules.positive("map/growth_step", config.map.growth_step_m);
  rules.atLeast("map/max_cells", config.map.max_cells, 1);
  rules.atLeast("map/max_readings", config.map.max_readings, 1);
  rules.require(config.k_visibility.filter == "median" || config.k_visibility.filter == "mean",
                "k_visibility/filter", "'" + config.k_visibility.filter + "'",
                "'median' or 'mean'");
  rules.require(config.k_visibility.window >= 1 && config.k_visibility.window % 2 == 1,
                "k_visibility/window", config.k_visibility.window, "odd and at least 1");
  rules.notNegative("k_visibility/path_loss_exponent", config.k_visibility.path_loss_exponent);
  rules.require(config.k_visibility.wall_count >= 0 && config.k_visibility.wall_count <= 20,
                "k_visibility/wall_count", config.k_visibility.wall_count, "in 0..20");
  rules.require(config.k_visibility.max_wall_count >= 1 && config.k_visibility.max_wall_count <= 20,
                "k_visibility/max_wall_count", config.k_visibility.max_wall_count, "in 1..20");
  rules.positive("k_visibility/min_wall_loss", config.k_visibility.min_wall_loss_db);
  rules.positive("tomography/bin_size", config.tomography.bin_size_m);
  const double saturation = config.tomography.max_total_wall_loss_db;
  rules.require(saturation == 0.0 || (std::isfinite(saturation) && saturation >= 1.0),
                "tomography/max_total_wall_loss", saturation, "0, or finite and at least 1 dB");
  rules.notNegative("tomography/l1_weight", config.tomography.l1_weight);
  rules.notNegative("tomography/smoothness_weight", config.tomography.smoothness_weight);
  rules.positive("tomography/nugget", config.tomography.nugget_db);
  rules.require(config.tomography.wall_directions >= 2 && config.tomography.wall_directions <= 8 &&
                    config.tomography.wall_directions % 2 == 0,
                "tomography/wall_directions", config.tomography.wall_directions, "2, 4, 6 or 8");
  rules.require(config.tomography.ensemble_size >= 1 && config.tomography.ensemble_size <= 100,
                "tomography/ensemble_size", config.tomography.ensemble_size, "in 1..100");
  rules.notNegative("path/footprint_radius", config.path.footprint_radius_m);
  rules.positive("path/max_gap", config.path.max_gap_m);
  rules.positive("k_visibility/wall_thickness", config.k_visibility.wall_thickness_m);
  rules.probability("k_visibility/wall_prior", config.k_visibility.wall_prior);
  rules.probability("belief/free_threshold", config.belief.free_threshold);
  rules.probability("belief/occupied_threshold", config.belief.occupied_threshold);
  // Cells are kept in steps of up to .016: thresholds that are closer let no cell be unknown.
  constexpr double kLeastApart = 0.05;
  rules.require(
      !(config.belief.free_threshold > config.belief.occupied_threshold - kLeastApart + 1e-9),
      "belief/free_threshold", config.belief.free_threshold,
      "at least 0.05 lower than belief/occupied_threshold");
  rules.positive("octomap/wall_height", config.octomap.wall_height_m);
  rules.positive("octomap/robot_height", config.octomap.robot_height_m);
  rules.frame("ros/map_frame", config.ros.map_frame);
  rules.frame("ros/antenna_frame", config.ros.antenna_frame);
  rules.frame("ros/odom_frame", config.ros.odom_frame);
  rules.positive("ros/jump_distance", config.ros.jump_distance_m);
  rules.positive("ros/jump_angle", config.ros.jump_angle_rad);
  rules.positive("ros/publish_rate", config.ros.publish_rate_hz);
  rules.notNegative("ros/transform_timeout", config.ros.transform_timeout_s);
  rules.positive("ros/tf_cache", config.ros.tf_cache_s);
  rules.atLeast("ros/max_waiting", config.ros.max_waiting, 1);
  rules.require(!config.ros.save_directory.empty(), "ros/save_directory",
                "'" + config.ros.save_directory + "'", "a directory");
  return rules.problems();
}

}  // namespace sfw
