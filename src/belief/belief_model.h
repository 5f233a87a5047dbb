#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "base/use_radio.h"
#include "belief/feature_table.h"
#include "path/path_style.h"
#include "structure_from_wifi/config.h"

namespace sfw {

/// Calculates from the features of a cell the probability that it is free. It has one logistic
/// model for each driving style, and the distribution of paths in each style. Immutable.
class BeliefModel {
 public:
  /// Rim share, axis share and logarithm of winding + 0.01. Over many drives they are nearly
  /// normally distributed.
  using Style = Eigen::Vector3d;
  static Style styleVector(const PathStyle& style);

  /// A logistic model.
  struct Weights {
    double intercept = 0.0;
    std::array<double, kCellFeatures> features{};  ///< in the order of kCellFeatureTable
  };

  /// Two models for one style, and the normal distribution of the paths that they were fitted to.
  struct Expert {
    Style style_mean = Style::Zero();
    Eigen::Matrix3d style_covariance = Eigen::Matrix3d::Identity();
    Weights with_radio;
    Weights without_radio;  ///< fitted to the same cells without the features that use radio
  };

  /// @throw std::invalid_argument if a number is not finite or a covariance not positive definite.
  explicit BeliefModel(const std::array<Expert, kDrivingStyles>& experts);

  const Expert& expert(DrivingStyle style) const {
    return experts_[static_cast<std::size_t>(style)];
  }

  /// Share of each expert in the result for a path; they sum to 1. One expert has the whole share
  /// unless the path lies between two styles.
  StyleShares shares(const PathStyle& style) const;

  /// Probability that a cell is free.
  /// @param shares     of the experts
  /// @param use_radio  kNo: by the features of path and rays alone, without signal strength
  double free(const FeatureVector& cell, const StyleShares& shares, UseRadio use_radio) const;

 private:
  std::array<Expert, kDrivingStyles> experts_;
};

/// Number of the format that toYaml writes. A file of another format is refused, because weights of
/// other features would give a wrong map without any error.
constexpr int kBeliefModelFormat = 1;

/// Reads a model as toYaml writes it.
/// @param name  of the file, for messages
/// @throw InputError with the name of the file, the part that is missing or malformed, and a
/// remedy.
BeliefModel parseBeliefModel(const std::string& yaml, const std::string& name);

/// Writes a model in YAML, its format first.
std::string toYaml(const BeliefModel& model);

/// Returns the model that the package ships: config/belief_model.yaml at the time of the build.
BeliefModel shippedBeliefModel();

/// Reads the model that belief/model names; returns the shipped one if the setting is empty.
/// @throw as parseBeliefModel
BeliefModel configuredBeliefModel(const Config::Belief& config);

}  // namespace sfw
