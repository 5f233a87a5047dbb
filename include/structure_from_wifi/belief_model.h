#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "structure_from_wifi/cell_features.h"

namespace sfw {

/// How likely a cell is free, from its features: two logistic models, one for robots that follow
/// walls and one for all others, and what tells the two apart. Immutable.
class BeliefModel {
 public:
  /// Rim share, axis share and logarithm of winding + 0.01: nearly normal over many drives.
  using Style = Eigen::Vector3d;
  static Style styleVector(const PathStyle& style);

  /// A logistic model.
  struct Weights {
    double intercept = 0.0;
    std::array<double, kCellFeatures> features{};
  };

  /// Models for one style, and the normal distribution of the styles that they were fitted to.
  struct Expert {
    Style style_mean = Style::Zero();
    Eigen::Matrix3d style_covariance = Eigen::Matrix3d::Identity();
    Weights with_radio;
    Weights without_radio;  ///< fitted to the same cells; weighs no feature that usesRadio
  };

  /// @throw std::invalid_argument if a number is not finite or a covariance not positive definite.
  BeliefModel(const Expert& follows_walls, const Expert& any_path);

  const Expert& followsWalls() const { return follows_walls_; }
  const Expert& anyPath() const { return any_path_; }

  /// How far the model for wall followers applies to a path, 0 to 1: all or nothing unless its
  /// style fits both.
  double followsWalls(const PathStyle& style) const;

  /// Probability that a cell is free.
  /// @param follows_walls  as from followsWalls(style)
  /// @param radio          false: as far as path and rays tell without any signal strength
  double free(const std::array<float, kCellFeatures>& cell, double follows_walls, bool radio) const;

 private:
  Expert follows_walls_;
  Expert any_path_;
};

/// Reads a model as toYaml writes it.
/// @param name  of the file, for messages
/// @throw InputError naming the file and what is missing or malformed.
BeliefModel parseBeliefModel(const std::string& yaml, const std::string& name);

std::string toYaml(const BeliefModel& model);

/// The model that the package ships, config/belief_model.yaml as it was when the package was built.
BeliefModel shippedBeliefModel();

}  // namespace sfw
