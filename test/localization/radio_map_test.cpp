#include "localization/radio_map.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "localization/heard_hall.h"
#include "localization/place_estimate.h"

namespace sfw {
namespace {

PlaceEstimate locate(const RadioMap& map, const Scan& scan) {
  const auto log_likelihood = map.logLikelihood(scan);
  return estimateOf(map.places().points(), posterior(map.places(), log_likelihood.value()));
}

struct Errors {
  double median_m;
  double in_ellipse;  // share of truths in the ellipse of 90 %
};

Errors errorsOf(const RadioMap& map, const std::vector<Scan>& scans) {
  std::vector<double> errors_m;
  double held = 0.0;
  for (const Scan& scan : scans) {
    const PlaceEstimate estimate = locate(map, scan);
    const Position error = scan.position - estimate.position;
    errors_m.push_back(error.norm());
    held += error.dot(estimate.covariance.inverse() * error) < 4.605 ? 1.0 : 0.0;
  }
  std::sort(errors_m.begin(), errors_m.end());
  return {errors_m[errors_m.size() / 2], held / static_cast<double>(errors_m.size())};
}

TEST(RadioMap, LocatesScansBetweenTheMappedLanes) {
  const HeardHall hall;
  const Errors errors =
      errorsOf(RadioMap(hall.drive(0.0, 2.0, 0.0), {}), hall.drive(1.0, 2.0, 5000.0));
  EXPECT_LT(errors.median_m, 1.5);
  EXPECT_GT(errors.in_ellipse, 0.8);
}

TEST(RadioMap, NamesOfOneRadioAreOneWitness) {
  HeardHall hall;
  const double alone =
      errorsOf(RadioMap(hall.drive(0.0, 2.0, 0.0), {}), hall.drive(1.0, 2.0, 5000.0)).median_m;
  hall.names = 8;
  const Errors errors =
      errorsOf(RadioMap(hall.drive(0.0, 2.0, 0.0), {}), hall.drive(1.0, 2.0, 5000.0));
  EXPECT_LT(errors.median_m, 1.2 * alone);
  EXPECT_GT(errors.in_ellipse, 0.8) << "eight names made it eight times as sure";
}

TEST(RadioMap, ARadioWithRandomValuesDoesLittleHarm) {
  const HeardHall hall;
  std::vector<Scan> mapped = hall.drive(0.0, 2.0, 0.0);
  std::vector<Scan> unknown = hall.drive(1.0, 2.0, 5000.0);
  const double before = errorsOf(RadioMap(mapped, {}), unknown).median_m;
  Random random(1, 2, 3);
  for (std::vector<Scan>* scans : {&mapped, &unknown}) {
    for (Scan& scan : *scans) {
      scan.heard.emplace_back(HeardHall::bssid(9, 0), random.uniform(-90.0, -30.0));
    }
  }
  EXPECT_LT(errorsOf(RadioMap(mapped, {}), unknown).median_m, 1.15 * before);
}

TEST(RadioMap, SilenceOfARadioCounts) {
  // Two rooms far apart with equal signals; only one hears the second radio.
  std::vector<Scan> mapped;
  for (int i = 0; i < 80; ++i) {
    Scan scan;
    scan.stamp_ns = 1'000'000'000LL * i;
    const bool second = i >= 40;
    scan.position = {0.1 * (i % 40) + (second ? 30.0 : 0.0), 0.0};
    scan.heard.emplace_back(HeardHall::bssid(0, 0), -60.0 + i % 3);
    if (second) {
      scan.heard.emplace_back(HeardHall::bssid(1, 0), -60.0 + i % 3);
    }
    mapped.push_back(scan);
  }
  const RadioMap map(mapped, {});
  EXPECT_LT(locate(map, mapped[20]).position.x(), 15.0);
  EXPECT_GT(locate(map, mapped[60]).position.x(), 19.0);
}

TEST(RadioMap, AScanWithoutKnownRadiosSaysNothing) {
  const HeardHall hall;
  Scan strange;
  strange.heard.emplace_back(HeardHall::bssid(9, 9), -50.0);
  const RadioMap map(hall.drive(0.0, 4.0, 0.0), {});
  EXPECT_FALSE(map.logLikelihood(strange));
  EXPECT_FALSE(map.logLikelihood(Scan()));
}

TEST(RadioMap, OneScanMakesAMap) {
  const HeardHall hall;
  RadioMap::Config config;
  config.fewest_scans = 1;
  const RadioMap map({hall.scanAt({1.0, 1.0}, 0.0)}, {}, config);
  EXPECT_LT((locate(map, hall.scanAt({1.0, 1.0}, 1.0)).position - Position(1.0, 1.0)).norm(), 1.5);
}

}  // namespace
}  // namespace sfw
