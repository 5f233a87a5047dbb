#include "access_points/access_point_estimation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "access_points/access_point_likelihood.h"
#include "access_points/coarse_bins.h"

namespace sfw {
namespace {

constexpr std::size_t kFewestBins = 12;
constexpr double kLeastSpreadDb = 1.0;  // less is rounding, not distance

constexpr double kMarginM = 8.0;  // of the search beyond the path
constexpr double kCoarseCellM = 1.0;
constexpr double kMostCoarseCells = 625.0;
constexpr std::size_t kMostFineCells = 250;
constexpr int kRefinements = 3;  // to an eighth of a metre: finer than the accuracy of any path
constexpr double kLargestDeviationM = 5.0;

/// Cells are ignored if their log likelihood is this much below the best one.
constexpr double kNegligible = 12.0;

/// A mean lies between several likely positions if its log likelihood is this much below the best.
constexpr double kAmbiguous = 3.0;

/// In simulation, correct positions hardly ever pass both limits; most positions that are wrong by
/// 3 m or more do.
constexpr double kSuspectRatio = 6.0;
constexpr double kSuspectDistanceM = 1.5;

/// Standard deviation of the bins' signals [dB].
double signalSpread(const std::vector<RadioBin>& bins) {
  double mean = 0.0;
  double square = 0.0;
  for (const RadioBin& bin : bins) {
    mean += bin.rssi_dbm / static_cast<double>(bins.size());
  }
  for (const RadioBin& bin : bins) {
    square += (bin.rssi_dbm - mean) * (bin.rssi_dbm - mean);
  }
  return std::sqrt(square / static_cast<double>(bins.size()));
}

/// A square of the search and the log likelihood of its centre.
struct Patch {
  Position centre;
  double edge_m;
  double log_likelihood;
};

bool moreLikely(const Patch& a, const Patch& b) { return a.log_likelihood > b.log_likelihood; }

/// The area of the search [m].
Box searchedArea(const std::vector<RadioBin>& bins) {
  const Position margin(kMarginM, kMarginM);
  Box box;
  for (const RadioBin& bin : bins) {
    box.extend(bin.position);
  }
  return {box.min() - margin, box.max() + margin};
}

/// Centres of the patches between two coordinates [m].
std::vector<double> centresBetween(double low, double high, double edge_m) {
  std::vector<double> centres;
  double centre = low + 0.5 * edge_m;
  while (centre < high) {
    centres.push_back(centre);
    centre += edge_m;  // a product would round differently and change estimates in the last bit
  }
  return centres;
}

/// The part of an area, and of the margin around a given position, that a prior makes likely [m].
Box likelyArea(const Box& area, const PositionPrior& prior) {
  constexpr double kDeviations = 4.0;
  const auto around = [&](double half_m) {
    const Position half(half_m, half_m);
    return Box(prior.mean - half, prior.mean + half);
  };
  return around(kDeviations * prior.deviation_m).intersection(area.merged(around(kMarginM)));
}

/// The log likelihood of positions, and of a prior if there is one.
class LogPosterior {
 public:
  explicit LogPosterior(const AccessPointLikelihood& likelihood,
                        std::optional<PositionPrior> prior = std::nullopt)
      : likelihood_(likelihood), prior_(std::move(prior)) {}

  const std::vector<RadioBin>& bins() const { return likelihood_.accessPoint().bins; }
  bool hasPrior() const { return prior_.has_value(); }

  /// The area of the search [m].
  Box area() const {
    const Box area = searchedArea(bins());
    return prior_ ? likelyArea(area, *prior_) : area;
  }

  /// The edge of the largest patches [m].
  double coarseCell() const {
    return prior_ ? std::min(kCoarseCellM, 0.5 * prior_->deviation_m) : kCoarseCellM;
  }

  std::vector<double> at(const std::vector<Position>& positions) const {
    std::vector<double> rated = likelihood_.at(positions);
    for (std::size_t i = 0; prior_ && i < positions.size(); ++i) {
      const double away = (positions[i] - prior_->mean).norm() / prior_->deviation_m;
      rated[i] -= 0.5 * away * away;
    }
    return rated;
  }

  double at(const Position& position) const { return at(std::vector<Position>{position}).front(); }

 private:
  const AccessPointLikelihood& likelihood_;
  std::optional<PositionPrior> prior_;
};

/// Sets the log likelihoods of all patches.
void rate(const LogPosterior& posterior, std::vector<Patch>& patches) {
  std::vector<Position> centres;
  centres.reserve(patches.size());
  for (const Patch& patch : patches) {
    centres.push_back(patch.centre);
  }
  const std::vector<double> log_likelihoods = posterior.at(centres);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    patches[i].log_likelihood = log_likelihoods[i];
  }
}

std::vector<Patch> coarsePatches(const LogPosterior& posterior) {
  const Box box = posterior.area();
  const Position& low = box.min();
  const Position size = box.sizes();
  const double edge = std::max(posterior.coarseCell(), std::sqrt(size.prod() / kMostCoarseCells));
  std::vector<Patch> patches;
  for (const double y : centresBetween(low.y(), low.y() + size.y(), edge)) {
    for (const double x : centresBetween(low.x(), low.x() + size.x(), edge)) {
      patches.push_back({{x, y}, edge, 0.0});
    }
  }
  rate(posterior, patches);
  return patches;
}

/// Quarters the most likely patches.
void refine(const LogPosterior& posterior, std::vector<Patch>& patches) {
  std::stable_sort(patches.begin(), patches.end(), moreLikely);
  const double least = patches.front().log_likelihood - kNegligible;
  std::vector<Patch> quarters;
  std::size_t done = 0;
  for (; done < std::min(patches.size(), kMostFineCells); ++done) {
    const Patch& patch = patches[done];
    if (patch.log_likelihood < least) {
      break;
    }
    for (const double y : {-0.25, 0.25}) {
      for (const double x : {-0.25, 0.25}) {
        quarters.push_back({patch.centre + patch.edge_m * Position(x, y), 0.5 * patch.edge_m, 0.0});
      }
    }
  }
  rate(posterior, quarters);
  patches.erase(patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(done));
  patches.insert(patches.end(), quarters.begin(), quarters.end());
}

/// Mean [m] and covariance [m2] of a position.
struct Moments {
  Position mean = Position::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Mean of the likelihood over the patches, and covariance about the mean or about another centre.
/// @param best    largest log likelihood of all patches
/// @param centre  of the covariance; null: the mean
Moments momentsOf(const std::vector<Patch>& patches, double best, const Position* centre) {
  Moments moments;
  double sum = 0.0;
  for (const Patch& patch : patches) {
    const double weight = patch.edge_m * patch.edge_m * std::exp(patch.log_likelihood - best);
    sum += weight;
    moments.mean += weight * patch.centre;
  }
  moments.mean /= sum;
  const Position about = centre != nullptr ? *centre : moments.mean;
  for (const Patch& patch : patches) {
    const double weight = patch.edge_m * patch.edge_m * std::exp(patch.log_likelihood - best) / sum;
    const Position away = patch.centre - about;
    moments.covariance += weight * (away * away.transpose() + patch.edge_m * patch.edge_m / 12.0 *
                                                                  Eigen::Matrix2d::Identity());
  }
  return moments;
}

/// Largest standard deviation on any axis [m].
double largestDeviation(const Eigen::Matrix2d& covariance) {
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues().maxCoeff());
}

/// An estimate and the largest log likelihood of its search.
struct Found {
  AccessPointEstimate estimate;
  double log_likelihood;
};

std::optional<Found> search(const LogPosterior& posterior) {
  std::vector<Patch> patches = coarsePatches(posterior);
  for (int i = 0; i < kRefinements; ++i) {
    refine(posterior, patches);
  }
  const Patch best = *std::min_element(patches.begin(), patches.end(), moreLikely);
  const Moments moments = momentsOf(patches, best.log_likelihood, nullptr);
  AccessPointEstimate estimate;
  estimate.position = moments.mean;
  estimate.covariance = moments.covariance;
  if (posterior.at(moments.mean) < best.log_likelihood - kAmbiguous) {
    estimate.ambiguous = true;
    estimate.position = best.centre;
    estimate.covariance = momentsOf(patches, best.log_likelihood, &best.centre).covariance;
  } else if (!posterior.hasPrior() && largestDeviation(estimate.covariance) > kLargestDeviationM) {
    return std::nullopt;
  }
  estimate.bins = posterior.bins().size();
  for (const RadioBin& bin : posterior.bins()) {
    estimate.readings += static_cast<std::size_t>(bin.readings);
  }
  return Found{estimate, best.log_likelihood};
}

/// Ten by ten positions, evenly spread over an area.
std::vector<Position> evenlySpread(const Box& area) {
  constexpr int kEachWay = 10;
  std::vector<Position> positions;
  for (int y = 0; y < kEachWay; ++y) {
    for (int x = 0; x < kEachWay; ++x) {
      const Position share((x + 0.5) / kEachWay, (y + 0.5) / kEachWay);
      positions.emplace_back(area.min() + area.sizes().cwiseProduct(share));
    }
  }
  return positions;
}

/// The likeliest of some positions.
std::vector<Position> likeliest(const AccessPointLikelihood& likelihood,
                                const std::vector<Position>& positions) {
  constexpr std::size_t kMost = 12;
  std::vector<std::pair<double, std::size_t>> rated;  // the likeliest first
  for (const double log_likelihood : likelihood.at(positions)) {
    rated.emplace_back(-log_likelihood, rated.size());
  }
  std::sort(rated.begin(), rated.end());
  std::vector<Position> best;
  for (std::size_t i = 0; i < std::min(kMost, rated.size()); ++i) {
    best.push_back(positions[rated[i].second]);
  }
  return best;
}

/// The likelihood for the shadow fading that explains the signals best.
///
/// Strength and reach of shadow fading differ from building to building, and so does the accuracy
/// that signals allow. Each pair is rated by the best of some positions of the access point, which
/// are likely with the usual fading.
AccessPointLikelihood withBestShadowing(const AccessPointBins& access_point) {
  constexpr double kUsualDb = 5.0;
  constexpr double kFactor = 0.5;  // standard deviation of the deviation's logarithm
  constexpr double kUsualDistanceM = 1.5;
  const ShadowingWhitener::Neighbours neighbours(positionsOf(access_point));
  const std::vector<Position> positions =
      likeliest(AccessPointLikelihood(access_point, {kUsualDb, kUsualDistanceM}, neighbours),
                evenlySpread(searchedArea(access_point.bins)));
  std::optional<AccessPointLikelihood> best;
  double most = -std::numeric_limits<double>::infinity();
  for (const double distance_m : {1.5, 4.0}) {
    for (const double deviation_db : {1.0, 2.0, 3.0, 4.0, 5.5, 7.5}) {
      AccessPointLikelihood likelihood(access_point, {deviation_db, distance_m}, neighbours);
      const std::vector<double> rated = likelihood.at(positions);
      double evidence = *std::max_element(rated.begin(), rated.end());
      const double unusual = std::log(deviation_db / kUsualDb) / kFactor;
      evidence -= 0.5 * unusual * unusual;
      if (evidence > most) {
        most = evidence;
        best.emplace(std::move(likelihood));
      }
    }
  }
  return std::move(*best);
}

/// The likelihood, or nothing if the readings cannot determine a position.
std::optional<AccessPointLikelihood> likelihoodOf(const std::vector<Sample>& samples,
                                                  std::optional<double> height_m) {
  const AccessPointBins access_point = coarseBins(samples, height_m);
  if (access_point.bins.size() < kFewestBins || signalSpread(access_point.bins) < kLeastSpreadDb) {
    return std::nullopt;
  }
  return withBestShadowing(access_point);
}

}  // namespace

std::optional<AccessPointEstimate> estimateAccessPoint(const std::vector<Sample>& samples,
                                                       std::optional<double> height_m) {
  const std::optional<AccessPointLikelihood> likelihood = likelihoodOf(samples, height_m);
  const std::optional<Found> found = likelihood ? search(LogPosterior(*likelihood)) : std::nullopt;
  return found ? std::optional(found->estimate) : std::nullopt;
}

AccessPointEstimate estimateAccessPoint(const std::vector<Sample>& samples,
                                        const PositionPrior& prior,
                                        std::optional<double> height_m) {
  if (const std::optional<AccessPointLikelihood> likelihood = likelihoodOf(samples, height_m)) {
    return search(LogPosterior(*likelihood, prior))->estimate;
  }
  AccessPointEstimate estimate;
  estimate.position = prior.mean;
  estimate.covariance = prior.deviation_m * prior.deviation_m * Eigen::Matrix2d::Identity();
  return estimate;
}

std::optional<AccessPointFit> accessPointFit(const std::vector<Sample>& samples,
                                             const Position& configured,
                                             std::optional<double> height_m,
                                             std::optional<double> deviation_m) {
  const std::optional<AccessPointLikelihood> likelihood = likelihoodOf(samples, height_m);
  const std::optional<Found> found = likelihood ? search(LogPosterior(*likelihood)) : std::nullopt;
  if (!found) {
    return std::nullopt;
  }
  AccessPointFit fit;
  fit.estimate = found->estimate;
  fit.residual_db = likelihood->residualAt(configured);
  const double at_configured =
      deviation_m ? search(LogPosterior(*likelihood, PositionPrior{configured, *deviation_m}))
                        ->log_likelihood
                  : likelihood->at(configured);
  fit.log_ratio = std::max(0.0, likelihood->at(fit.estimate.position) - at_configured);
  fit.distance_m = (configured - fit.estimate.position).norm();
  fit.suspect = fit.log_ratio > kSuspectRatio && fit.distance_m > kSuspectDistanceM;
  return fit;
}

}  // namespace sfw
