#include "belief/belief_model.h"

#include <yaml-cpp/yaml.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "base/log_odds.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Log density of a normal distribution, without the constant.
double logDensity(const BeliefModel::Expert& expert, const BeliefModel::Style& style) {
  const Eigen::LLT<Eigen::Matrix3d> factor(expert.style_covariance);
  const BeliefModel::Style white = factor.matrixL().solve(style - expert.style_mean);
  return -0.5 * white.squaredNorm() - factor.matrixLLT().diagonal().array().log().sum();
}

double score(const BeliefModel::Weights& weights, const FeatureVector& cell) {
  double sum = weights.intercept;
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    sum += weights.features[i] * static_cast<double>(cell[i]);
  }
  return sum;
}

bool isFinite(const BeliefModel::Weights& weights) {
  return std::isfinite(weights.intercept) &&
         std::all_of(weights.features.begin(), weights.features.end(),
                     [](double weight) { return std::isfinite(weight); });
}

void requireUsable(const BeliefModel::Expert& expert) {
  const Eigen::LLT<Eigen::Matrix3d> factor(expert.style_covariance);
  const bool finite = expert.style_mean.allFinite() && expert.style_covariance.allFinite() &&
                      isFinite(expert.with_radio) && isFinite(expert.without_radio);
  if (!finite || factor.info() != Eigen::Success) {
    throw std::invalid_argument(
        "a belief model's numbers must be finite and its covariances positive definite");
  }
}

void requireFormat(const YAML::Node& node) {
  const std::string remedy =
      "; fit the model again with sfw fit, or use the shipped one by leaving "
      "belief/model empty";
  const std::string readable = std::to_string(kBeliefModelFormat);
  if (!node["format"]) {
    throw std::invalid_argument(
        "the belief model has no key format, so it was made by another "
        "version; this version reads format " +
        readable + remedy);
  }
  if (node["format"].as<int>(0) != kBeliefModelFormat) {
    throw std::invalid_argument("the belief model has format " +
                                node["format"].as<std::string>("?") +
                                ", but this version reads format " + readable + remedy);
  }
}

BeliefModel::Weights parseWeights(const YAML::Node& node) {
  BeliefModel::Weights weights;
  weights.intercept = node["intercept"].as<double>();
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    const char* name = kCellFeatureTable[i].name;
    if (!node[name]) {
      throw std::invalid_argument(std::string("a model lacks the feature ") + name);
    }
    weights.features[i] = node[name].as<double>();
  }
  if (node.size() != kCellFeatures + 1) {
    throw std::invalid_argument("a model must weigh the intercept and each of the " +
                                std::to_string(kCellFeatures) + " features once, and nothing else");
  }
  return weights;
}

BeliefModel::Expert parseExpert(const YAML::Node& node) {
  BeliefModel::Expert expert;
  for (int i = 0; i < 3; ++i) {
    expert.style_mean[i] = node["style"]["mean"][i].as<double>();
    for (int j = 0; j < 3; ++j) {
      expert.style_covariance(i, j) = node["style"]["covariance"][i][j].as<double>();
    }
  }
  expert.with_radio = parseWeights(node["with_radio"]);
  expert.without_radio = parseWeights(node["without_radio"]);
  return expert;
}

void write(std::ostream& out, const char* name, const BeliefModel::Weights& weights) {
  out << "  " << name << ":\n    intercept: " << weights.intercept << '\n';
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    out << "    " << kCellFeatureTable[i].name << ": " << weights.features[i] << '\n';
  }
}

void write(std::ostream& out, const char* name, const BeliefModel::Expert& expert) {
  const auto row = [&](auto&& values) {
    out << '[' << values[0] << ", " << values[1] << ", " << values[2] << ']';
  };
  out << name << ":\n  style:\n    mean: ";
  row(expert.style_mean);
  out << "\n    covariance:\n";
  for (int i = 0; i < 3; ++i) {
    out << "      - ";
    row(expert.style_covariance.row(i));
    out << '\n';
  }
  write(out, "with_radio", expert.with_radio);
  write(out, "without_radio", expert.without_radio);
}

}  // namespace

BeliefModel::BeliefModel(const std::array<Expert, kDrivingStyles>& experts) : experts_(experts) {
  std::for_each(experts_.begin(), experts_.end(), requireUsable);
}

BeliefModel::Style BeliefModel::styleVector(const PathStyle& style) {
  return {style.rim_share, style.axis_share, std::log(style.winding + 0.01)};
}

StyleShares BeliefModel::shares(const PathStyle& style) const {
  // A mixture of experts fits no style, so one expert is chosen. A short transition between two
  // experts lets a growing path change the map gradually.
  constexpr double kIgnored = 0.25;
  StyleShares densities{};
  std::transform(experts_.begin(), experts_.end(), densities.begin(),
                 [&](const Expert& expert) { return logDensity(expert, styleVector(style)); });
  const double highest = *std::max_element(densities.begin(), densities.end());
  const auto normalise = [](StyleShares& shares) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) {
      share /= sum;
    }
  };
  StyleShares shares{};
  std::transform(densities.begin(), densities.end(), shares.begin(),
                 [&](double density) { return std::exp(density - highest); });
  normalise(shares);
  for (double& share : shares) {
    share = std::clamp(share - kIgnored, 0.0, 1.0 - 2.0 * kIgnored);
  }
  normalise(shares);
  return shares;
}

double BeliefModel::free(const FeatureVector& cell, const StyleShares& shares,
                         UseRadio use_radio) const {
  const auto weights = use_radio == UseRadio::kYes ? &Expert::with_radio : &Expert::without_radio;
  double free = 0.0;
  for (std::size_t i = 0; i < kDrivingStyles; ++i) {
    if (shares[i] > 0.0) {
      free += shares[i] * logistic(score(experts_[i].*weights, cell));
    }
  }
  return free;
}

BeliefModel parseBeliefModel(const std::string& yaml, const std::string& name) {
  try {
    const YAML::Node node = YAML::Load(yaml);
    requireFormat(node);
    std::array<BeliefModel::Expert, kDrivingStyles> experts;
    std::transform(kDrivingStyleNames.begin(), kDrivingStyleNames.end(), experts.begin(),
                   [&](const char* style) { return parseExpert(node[style]); });
    return BeliefModel(experts);
  } catch (const YAML::Exception& error) {
    throw InputError(name + ": line " + std::to_string(error.mark.line + 1) +
                     ": not a belief model as sfw fit writes it: " + error.msg);
  } catch (const std::invalid_argument& error) {
    throw InputError(name + ": " + error.what());
  }
}

BeliefModel configuredBeliefModel(const Config::Belief& config) {
  if (config.model.empty()) {
    return shippedBeliefModel();
  }
  try {
    return parseBeliefModel(readFile(config.model), config.model);
  } catch (const InputError& error) {
    const bool relative = config.model.front() != '/';
    throw InputError(
        "belief/model: " + std::string(error.what()) +
        (relative ? " (looked for in the working directory; give its full path)" : ""));
  }
}

std::string toYaml(const BeliefModel& model) {
  std::ostringstream out;
  out.precision(5);
  out << "format: " << kBeliefModelFormat << '\n';
  for (std::size_t i = 0; i < kDrivingStyles; ++i) {
    write(out, kDrivingStyleNames[i], model.expert(static_cast<DrivingStyle>(i)));
  }
  return out.str();
}

}  // namespace sfw
