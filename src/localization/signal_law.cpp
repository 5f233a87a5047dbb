#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "localization/signal_bins.h"
#include "localization/signal_field.h"
#include "radio/shadowing.h"

namespace sfw {
namespace {

constexpr double kPriorShadowingDb = 4.0;
constexpr double kPriorReachM = 5.0;
constexpr double kPriorNuggetDb2 = 4.0;
constexpr double kPriorFactor = 0.7;  // standard deviation of each logarithm: a factor of 2

SignalLaw priorLaw() {
  SignalLaw law;
  law.covariance.shadowing_db = kPriorShadowingDb;
  law.covariance.shadowing_distance_m = kPriorReachM;
  law.covariance.nugget_db2 = kPriorNuggetDb2;
  law.covariance.power_sd_db = 12.0;
  law.covariance.exponent_sd = 0.8;  // walls are part of it
  return law;
}

double logPrior(const SignalCovariance& covariance) {
  const auto term = [](double value, double usual) {
    const double deviations = std::log(value / usual) / kPriorFactor;
    return -0.5 * deviations * deviations;
  };
  return term(covariance.shadowing_db, kPriorShadowingDb) +
         term(covariance.shadowing_distance_m, kPriorReachM) +
         term(covariance.nugget_db2, kPriorNuggetDb2);
}

/// The marginal likelihood of one transmitter's bins.
class LawLikelihood {
 public:
  explicit LawLikelihood(SignalBins bins) : bins_(std::move(bins)) {
    for (const double readings : bins_.readings) {
      noise_db2_.push_back(bins_.noise_db2 / readings);
    }
  }

  const SignalBins& bins() const { return bins_; }

  /// Prepares the covariance for any number of sources.
  void setCovariance(const SignalCovariance& covariance) {
    whitener_.emplace(bins_.positions, noise_db2_, covariance);
    log_determinant_ = whitener_->logDeterminant();
  }

  /// Log marginal likelihood, up to a constant; power and exponent are integrated out.
  double of(const SignalLaw& law) const {
    const auto count = static_cast<Eigen::Index>(bins_.positions.size());
    Eigen::MatrixX3d columns(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto bin = static_cast<std::size_t>(i);
      columns.row(i).head<2>() = signalBasis(law, bins_.positions[bin]).transpose();
      columns(i, 2) = bins_.rssi_dbm[bin] - priorMean(law, bins_.positions[bin]);
    }
    const Eigen::MatrixX3d white = whitener_->whitened(columns);
    const Eigen::Matrix3d moments = white.transpose() * white;
    const Eigen::Matrix2d information = Eigen::Matrix2d::Identity() + moments.topLeftCorner<2, 2>();
    const Eigen::Vector2d pull = moments.topRightCorner<2, 1>();
    const double explained = pull.dot(information.inverse() * pull);
    return log_determinant_ - 0.5 * std::log(information.determinant()) -
           0.5 * (moments(2, 2) - explained);
  }

 private:
  SignalBins bins_;
  std::vector<double> noise_db2_;
  std::optional<ShadowingWhitener> whitener_;
  double log_determinant_ = 0.0;
};

/// The most likely source: on a lattice first, then in ever finer steps around the best point.
void findSource(const LawLikelihood& likelihood, SignalLaw& law) {
  constexpr double kMarginM = 10.0;
  constexpr double kMostPlaces = 250.0;
  constexpr double kFinestM = 0.7;
  Box box;
  for (const Position& position : likelihood.bins().positions) {
    box.extend(position);
  }
  const Position low = box.min() - Position(kMarginM, kMarginM);
  const Position size = box.sizes() + Position(2.0 * kMarginM, 2.0 * kMarginM);
  double step_m = std::max(2.0, std::sqrt(size.prod() / kMostPlaces));
  law.source.reset();
  // A source must be better than a constant by what two more unknowns are worth (AIC).
  double best = likelihood.of(law) + 2.0;
  std::optional<Position> found;
  const auto consider = [&](const Position& place) {
    law.source = place;
    const double value = likelihood.of(law);
    if (value > best) {
      best = value;
      found = place;
    }
  };
  for (double y = low.y(); y <= low.y() + size.y(); y += step_m) {
    for (double x = low.x(); x <= low.x() + size.x(); x += step_m) {
      consider({x, y});
    }
  }
  for (step_m *= 0.5; found && step_m > kFinestM; step_m *= 0.5) {
    const Position centre = *found;
    for (int neighbour = 0; neighbour < 9; ++neighbour) {
      consider(centre + step_m * Position(neighbour % 3 - 1, neighbour / 3 - 1));
    }
  }
  law.source = found;
}

/// Climbs the posterior of shadowing, reach and nugget, one after the other.
void climb(LawLikelihood& likelihood, SignalLaw& law) {
  constexpr int kRounds = 3;
  constexpr double kStep = 1.6;
  const auto value = [&](const SignalCovariance& covariance) {
    SignalLaw tried = law;
    tried.covariance = covariance;
    likelihood.setCovariance(covariance);
    return likelihood.of(tried) + logPrior(covariance);
  };
  double best = value(law.covariance);
  double step = kStep;
  for (int round = 0; round < kRounds; ++round) {
    bool climbed = false;
    for (double SignalCovariance::*part :
         {&SignalCovariance::shadowing_db, &SignalCovariance::shadowing_distance_m,
          &SignalCovariance::nugget_db2}) {
      for (const double factor : {step, 1.0 / step}) {
        SignalCovariance tried = law.covariance;
        tried.*part *= factor;
        const double found = value(tried);
        if (found > best) {
          best = found;
          law.covariance = tried;
          climbed = true;
          break;
        }
      }
    }
    if (!climbed) {
      step = std::sqrt(step);
    }
  }
  likelihood.setCovariance(law.covariance);
}

SignalLaw startingLaw(const LawLikelihood& likelihood) {
  SignalLaw law = priorLaw();
  law.noise_db2 = likelihood.bins().noise_db2;
  return law;
}

}  // namespace

SignalLaw learnSignalLaw(const std::vector<Sample>& samples, std::optional<Position> place) {
  constexpr std::size_t kFewestBins = 6;  // fewer determine no source
  LawLikelihood likelihood(signalBins(samples));
  SignalLaw law = startingLaw(likelihood);
  law.source = place;
  likelihood.setCovariance(law.covariance);
  const bool search = !place && likelihood.bins().positions.size() >= kFewestBins;
  if (search) {
    findSource(likelihood, law);
  }
  climb(likelihood, law);
  if (search) {
    findSource(likelihood, law);
  }
  return law;
}

SignalLaw learnConstantLaw(const std::vector<Sample>& samples) {
  LawLikelihood likelihood(signalBins(samples));
  SignalLaw law = startingLaw(likelihood);
  climb(likelihood, law);
  return law;
}

}  // namespace sfw
