#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "belief/cell_features.h"
#include "path/path_style.h"
#include "structure_from_wifi/config.h"

namespace sfw {

/// How likely a cell is free, from its features: a logistic model for each driving style,
/// and what tells the styles apart. Immutable.
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
  explicit BeliefModel(const std::array<Expert, kDrivingStyles>& experts);

  const Expert& expert(DrivingStyle style) const {
    return experts_[static_cast<std::size_t>(style)];
  }

  /// How far each expert applies to a path; they sum to 1. One does all unless the style fits more.
  StyleShares shares(const PathStyle& style) const;

  /// Probability that a cell is free.
  /// @param shares  of the experts
  /// @param radio   false: as far as path and rays tell without any signal strength
  double free(const std::array<float, kCellFeatures>& cell, const StyleShares& shares,
              bool radio) const;

 private:
  std::array<Expert, kDrivingStyles> experts_;
};

/// Reads a model as toYaml writes it.
/// @param name  of the file, for messages
/// @throw InputError naming the file and what is missing or malformed.
BeliefModel parseBeliefModel(const std::string& yaml, const std::string& name);

std::string toYaml(const BeliefModel& model);

/// The model that the package ships, config/belief_model.yaml as it was when the package was built.
BeliefModel shippedBeliefModel();

/// The model that belief/model names, or the one that is shipped.
/// @throw InputError naming its file and what is wrong with it.
BeliefModel configuredBeliefModel(const Config::Belief& config);

}  // namespace sfw
