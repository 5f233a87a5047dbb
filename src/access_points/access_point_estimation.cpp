#include "access_points/access_point_estimation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "access_points/access_point_likelihood.h"

namespace sfw {
namespace {

constexpr double kBin = 0.4;  // [m]
constexpr std::size_t kFewestBins = 12;
constexpr std::size_t kMostBins = 300;
constexpr double kLeastSpread = 1.0;  // [dB]; less is rounding, not distance

constexpr double kLeastNoise = 0.1;  // [dB2]

constexpr double kMargin = 8.0;  // [m], of the search beyond the path
constexpr double kCoarseCell = 0.5;
constexpr double kMostCoarseCells = 2500.0;
constexpr std::size_t kMostFineCells = 250;
constexpr int kRefinements = 2;  // to an eighth of a metre: finer than any path is known
constexpr double kWidest = 5.0;  // [m]

/// Cells this much less likely than the best, as a logarithm, do not count.
constexpr double kNegligible = 12.0;

/// A mean that is this much less likely than the best lies between places, not at one.
constexpr double kAmbiguous = 3.0;

/// Simulated access points that stand where they are said to hardly ever pass both limits; most of
/// those moved by 3 m or more do.
constexpr double kSuspectRatio = 6.0;
constexpr double kSuspectDistance = 1.5;  // [m]

/// Variance of a reading about its bin's mean. Successive readings would tell it too, but the order
/// in which they came must not matter.
double noiseOf(const std::vector<Sample>& samples, const std::vector<RadioBin>& bins) {
  constexpr double kUsual = 9.0;          // [dB2]
  constexpr double kReadings = 2.0;       // that the usual noise counts as
  constexpr double kUsualSignal = -60.0;  // [dBm], taken off first: squares of large numbers round
  double sum = kReadings * kUsual;
  for (const Sample& sample : samples) {
    sum += (sample.rssi_dbm - kUsualSignal) * (sample.rssi_dbm - kUsualSignal);
  }
  for (const RadioBin& bin : bins) {
    sum -= bin.readings * (bin.rssi_dbm - kUsualSignal) * (bin.rssi_dbm - kUsualSignal);
  }
  const double freedom = static_cast<double>(samples.size() - bins.size()) + kReadings;
  return std::max(kLeastNoise, sum / freedom);
}

/// Bins of a size that keeps them few.
AccessPointBins thinned(std::vector<Sample> samples, std::optional<double> height_m) {
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return std::make_tuple(a.antenna_in_map.x(), a.antenna_in_map.y(), a.rssi_dbm) <
           std::make_tuple(b.antenna_in_map.x(), b.antenna_in_map.y(), b.rssi_dbm);
  });
  // No bin is near this, so none is left out.
  Position beyond(0.0, 0.0);
  for (const Sample& sample : samples) {
    beyond = beyond.cwiseMax(sample.antenna_in_map + Position(1.0, 1.0));
  }
  AccessPointBins heard;
  double bin = kBin;
  do {
    heard = binned(samples, beyond, height_m, BuildingFrame(), bin);
    bin *= 1.25;
  } while (heard.bins.size() > kMostBins);
  heard.noise_db2 = noiseOf(samples, heard.bins);
  return heard;
}

double spreadOf(const std::vector<RadioBin>& bins) {
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

/// A square of places and how likely its middle is.
struct Patch {
  Position middle;
  double edge;
  double log_likelihood;
};

bool likelier(const Patch& a, const Patch& b) { return a.log_likelihood > b.log_likelihood; }

Box searched(const std::vector<RadioBin>& bins) {
  const Position margin(kMargin, kMargin);
  Box box;
  for (const RadioBin& bin : bins) {
    box.extend(bin.place);
  }
  return {box.min() - margin, box.max() + margin};
}

std::vector<Patch> coarsePatches(AccessPointLikelihood& likelihood) {
  const Box box = searched(likelihood.heard().bins);
  const Position low = box.min();
  const Position size = box.sizes();
  const double edge = std::max(kCoarseCell, std::sqrt(size.prod() / kMostCoarseCells));
  std::vector<Patch> patches;
  for (double y = low.y() + 0.5 * edge; y < low.y() + size.y(); y += edge) {
    for (double x = low.x() + 0.5 * edge; x < low.x() + size.x(); x += edge) {
      patches.push_back({{x, y}, edge, likelihood.at({x, y})});
    }
  }
  return patches;
}

/// Quarters the likeliest patches.
void refine(AccessPointLikelihood& likelihood, std::vector<Patch>& patches) {
  std::stable_sort(patches.begin(), patches.end(), likelier);
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
        const Position middle = patch.middle + patch.edge * Position(x, y);
        quarters.push_back({middle, 0.5 * patch.edge, likelihood.at(middle)});
      }
    }
  }
  patches.erase(patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(done));
  patches.insert(patches.end(), quarters.begin(), quarters.end());
}

struct Moments {
  Position mean = Position::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Mean of the likelihood over the patches, and covariance about it or about another centre.
Moments momentsOf(const std::vector<Patch>& patches, double best, const Position* centre) {
  Moments moments;
  double sum = 0.0;
  for (const Patch& patch : patches) {
    const double weight = patch.edge * patch.edge * std::exp(patch.log_likelihood - best);
    sum += weight;
    moments.mean += weight * patch.middle;
  }
  moments.mean /= sum;
  const Position about = centre != nullptr ? *centre : moments.mean;
  for (const Patch& patch : patches) {
    const double weight = patch.edge * patch.edge * std::exp(patch.log_likelihood - best) / sum;
    const Position away = patch.middle - about;
    moments.covariance += weight * (away * away.transpose() +
                                    patch.edge * patch.edge / 12.0 * Eigen::Matrix2d::Identity());
  }
  return moments;
}

double widestOf(const Eigen::Matrix2d& covariance) {
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues().maxCoeff());
}

std::optional<AccessPointEstimate> search(AccessPointLikelihood& likelihood) {
  const std::vector<RadioBin>& bins = likelihood.heard().bins;
  std::vector<Patch> patches = coarsePatches(likelihood);
  for (int i = 0; i < kRefinements; ++i) {
    refine(likelihood, patches);
  }
  const Patch best = *std::min_element(patches.begin(), patches.end(), likelier);
  const Moments moments = momentsOf(patches, best.log_likelihood, nullptr);
  AccessPointEstimate estimate;
  estimate.position = moments.mean;
  estimate.covariance = moments.covariance;
  if (likelihood.at(moments.mean) < best.log_likelihood - kAmbiguous) {
    estimate.ambiguous = true;
    estimate.position = best.middle;
    estimate.covariance = momentsOf(patches, best.log_likelihood, &best.middle).covariance;
  } else if (widestOf(estimate.covariance) > kWidest) {
    return std::nullopt;
  }
  estimate.bins = bins.size();
  for (const RadioBin& bin : bins) {
    estimate.readings += static_cast<std::size_t>(bin.readings);
  }
  return estimate;
}

/// Some places all over the area that is searched.
std::vector<Position> somePlaces(const Box& box) {
  constexpr int kEachWay = 10;
  std::vector<Position> places;
  for (int y = 0; y < kEachWay; ++y) {
    for (int x = 0; x < kEachWay; ++x) {
      const Position share((x + 0.5) / kEachWay, (y + 0.5) / kEachWay);
      places.push_back(box.min() + box.sizes().cwiseProduct(share));
    }
  }
  return places;
}

/// The likelihood with the shadowing that explains the signals best, with the access point at the
/// best of some places: how strong it is and how far it reaches differs from building to building,
/// and so does what signals can tell.
AccessPointLikelihood likeliest(const AccessPointBins& heard) {
  constexpr double kUsual = 5.0;   // [dB]
  constexpr double kFactor = 0.5;  // deviation of its logarithm
  const std::vector<Position> places = somePlaces(searched(heard.bins));
  std::optional<AccessPointLikelihood> best;
  double most = -std::numeric_limits<double>::infinity();
  for (const double distance : {1.5, 4.0}) {
    for (const double deviation : {1.0, 2.0, 3.0, 4.0, 5.5, 7.5}) {
      AccessPointLikelihood likelihood(heard, {deviation, distance});
      double evidence = -std::numeric_limits<double>::infinity();
      for (const Position& place : places) {
        evidence = std::max(evidence, likelihood.at(place));
      }
      const double unusual = std::log(deviation / kUsual) / kFactor;
      evidence -= 0.5 * unusual * unusual;
      if (evidence > most) {
        most = evidence;
        best.emplace(std::move(likelihood));
      }
    }
  }
  return std::move(*best);
}

std::optional<AccessPointLikelihood> likelihoodOf(const std::vector<Sample>& samples,
                                                  std::optional<double> height_m) {
  AccessPointBins heard = thinned(samples, height_m);
  if (heard.bins.size() < kFewestBins || spreadOf(heard.bins) < kLeastSpread) {
    return std::nullopt;
  }
  return likeliest(heard);
}

}  // namespace

std::optional<AccessPointEstimate> estimateAccessPoint(const std::vector<Sample>& samples,
                                                       std::optional<double> height_m) {
  std::optional<AccessPointLikelihood> likelihood = likelihoodOf(samples, height_m);
  return likelihood ? search(*likelihood) : std::nullopt;
}

std::optional<AccessPointFit> accessPointFit(const std::vector<Sample>& samples,
                                             const Position& place,
                                             std::optional<double> height_m) {
  std::optional<AccessPointLikelihood> likelihood = likelihoodOf(samples, height_m);
  const std::optional<AccessPointEstimate> estimate =
      likelihood ? search(*likelihood) : std::nullopt;
  if (!estimate) {
    return std::nullopt;
  }
  AccessPointFit fit;
  fit.estimate = *estimate;
  fit.residual_db = likelihood->residualAt(place);
  fit.log_ratio = std::max(0.0, likelihood->at(estimate->position) - likelihood->at(place));
  fit.distance_m = (place - estimate->position).norm();
  fit.suspect = fit.log_ratio > kSuspectRatio && fit.distance_m > kSuspectDistance;
  return fit;
}

}  // namespace sfw
