#include "localization/place_lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

PlaceLattice line() {
  PlaceLattice::Config config;
  config.reach_m = 2.0;
  config.deviation_m = 1.0;
  config.finest_edge_m = 0.5;
  config.coarsest_edge_m = 0.5;
  return {{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}}, config};
}

TEST(PlaceLattice, HoldsThePlacesNearThePath) {
  const PlaceLattice places = line();
  for (const Position& point : places.points()) {
    EXPECT_LE(std::abs(point.y()), 2.0);
  }
  EXPECT_GE(places.nearest({1.1, 1.4}), 0);
  EXPECT_EQ(places.nearest({1.0, 3.1}), -1);
  EXPECT_EQ(places.nearest({1e9, 0.0}), -1);
}

TEST(PlaceLattice, PriorFallsWithTheDistanceFromThePath) {
  const PlaceLattice places = line();
  double sum = 0.0;
  for (const double value : places.logPrior()) {
    sum += std::exp(value);
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
  const auto at = [&](double y) {
    return places.logPrior()[static_cast<std::size_t>(places.nearest({1.0, y}))];
  };
  EXPECT_NEAR(at(0.0) - at(1.0), 0.5, 1e-9);
}

TEST(PlaceLattice, InterpolatesLinearFunctionsExactly) {
  const PlaceLattice places = line();
  std::vector<double> values;
  for (const Position& point : places.points()) {
    values.push_back(3.0 * point.x() - 2.0 * point.y());
  }
  EXPECT_NEAR(places.interpolated(values, {1.13, 0.41}), 3.0 * 1.13 - 2.0 * 0.41, 1e-9);
  EXPECT_TRUE(std::isinf(places.interpolated(values, {1.0, 5.0})));
}

TEST(PlaceLattice, RefusesPositionsOfAContinent) {
  PlaceLattice::Config config;
  EXPECT_THROW(PlaceLattice({{0.0, 0.0}, {1e6, 1e6}}, config), InputError);
}

}  // namespace
}  // namespace sfw
