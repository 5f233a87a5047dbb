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
  rules.positive("map/resolution", config.map.resolution);
  rules.positive("map/margin", config.map.margin);
  rules.positive("map/growth_step", config.map.growth_step);
  rules.atLeast("map/max_cells", config.map.max_cells, 1);
  rules.atLeast("map/max_readings", config.map.max_readings, 1);
  rules.require(config.rssi.filter == "median" || config.rssi.filter == "mean", "rssi/filter",
                "'" + config.rssi.filter + "'", "'median' or 'mean'");
  rules.require(config.rssi.window >= 1 && config.rssi.window % 2 == 1, "rssi/window",
                config.rssi.window, "odd and at least 1");
  rules.notNegative("rssi/path_loss_exponent", config.rssi.path_loss_exponent);
  rules.require(config.rssi.walls >= 0 && config.rssi.walls <= 20, "rssi/walls", config.rssi.walls,
                "in 0..20");
  rules.require(config.rssi.max_walls >= 1 && config.rssi.max_walls <= 20, "rssi/max_walls",
                config.rssi.max_walls, "in 1..20");
  rules.positive("rssi/min_wall_loss", config.rssi.min_wall_loss);
  rules.positive("tomography/bin", config.tomography.bin);
  const double saturation = config.tomography.saturation;
  rules.require(saturation == 0.0 || (std::isfinite(saturation) && saturation >= 1.0),
                "tomography/saturation", saturation, "0, or finite and at least 1 dB");
  rules.notNegative("tomography/sparsity", config.tomography.sparsity);
  rules.notNegative("tomography/straightness", config.tomography.straightness);
  rules.positive("tomography/unexplained", config.tomography.unexplained);
  rules.require(config.tomography.directions >= 2 && config.tomography.directions <= 8 &&
                    config.tomography.directions % 2 == 0,
                "tomography/directions", config.tomography.directions, "2, 4, 6 or 8");
  rules.require(config.tomography.members >= 1 && config.tomography.members <= 100,
                "tomography/members", config.tomography.members, "in 1..100");
  rules.notNegative("inference/footprint_radius", config.inference.footprint_radius);
  rules.positive("inference/max_gap", config.inference.max_gap);
  rules.positive("inference/wall_thickness", config.inference.wall_thickness);
  rules.probability("inference/wall_density", config.inference.wall_density);
  rules.probability("belief/free_threshold", config.belief.free_threshold);
  rules.probability("belief/occupied_threshold", config.belief.occupied_threshold);
  // Cells are kept in steps of up to .016: thresholds that are closer let no cell be unknown.
  constexpr double kLeastApart = 0.05;
  rules.require(
      !(config.belief.free_threshold > config.belief.occupied_threshold - kLeastApart + 1e-9),
      "belief/free_threshold", config.belief.free_threshold,
      "at least 0.05 lower than belief/occupied_threshold");
  rules.positive("octomap/wall_height", config.octomap.wall_height);
  rules.positive("octomap/robot_height", config.octomap.robot_height);
  rules.frame("ros/map_frame", config.ros.map_frame);
  rules.frame("ros/antenna_frame", config.ros.antenna_frame);
  rules.frame("ros/odom_frame", config.ros.odom_frame);
  rules.positive("ros/jump_distance", config.ros.jump_distance);
  rules.positive("ros/jump_angle", config.ros.jump_angle);
  rules.positive("ros/publish_rate", config.ros.publish_rate);
  rules.notNegative("ros/transform_timeout", config.ros.transform_timeout);
  rules.positive("ros/tf_cache", config.ros.tf_cache);
  rules.atLeast("ros/max_waiting", config.ros.max_waiting, 1);
  rules.require(!config.ros.save_directory.empty(), "ros/save_directory",
                "'" + config.ros.save_directory + "'", "a directory");
  return rules.problems();
}

}  // namespace sfw
