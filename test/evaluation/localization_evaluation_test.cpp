#include "evaluation/localization_evaluation.h"

#include <gtest/gtest.h>

#include "localization/heard_hall.h"

namespace sfw {
namespace {

TEST(NearestFingerprints, FindsTheMappedPlace) {
  HeardHall hall;
  hall.noise_db = 0.1;
  const std::vector<Scan> mapped = hall.drive(0.0, 2.0, 0.0);
  const NearestFingerprints fingerprints(mapped, 6.0);
  EXPECT_LT((fingerprints.locate(hall.scanAt({10.0, 4.0}, 900.0)) - Position(10.0, 4.0)).norm(),
            1.5);
}

TEST(NearestFingerprints, AveragesSeveralInNoise) {
  HeardHall hall;
  hall.noise_db = 8.0;
  EXPECT_GT(NearestFingerprints(hall.drive(0.0, 2.0, 0.0), 6.0).neighbours(), 2U);
}

TEST(LocalizationEvaluation, ComparesTheMethodsOnTheSameScans) {
  const HeardHall hall;
  const std::vector<Scan> mapped = hall.drive(0.0, 2.0, 0.0);
  std::vector<Scan> scans = hall.drive(1.0, 2.0, 5000.0);
  scans.front().heard.clear();
  const RadioMap map(mapped, {});
  const std::vector<LocalizedScan> localized = localizeScans(
      map, scans, std::vector<std::optional<Position>>(scans.size()), ParticleFilter::Config());
  const LocalizationEvaluation evaluation =
      evaluateLocalization(scans, localized, NearestFingerprints(mapped, 6.0));
  EXPECT_EQ(evaluation.filtered.scans, scans.size() - 1);
  EXPECT_EQ(evaluation.nearest.scans, scans.size() - 1);
  EXPECT_LT(evaluation.filtered.median_m, evaluation.nearest.median_m);
  EXPECT_LE(evaluation.filtered.median_m, evaluation.filtered.largest_of_90_percent_m);
  EXPECT_FALSE(evaluation.nearest.in_ellipse);
  EXPECT_GT(*evaluation.filtered.in_ellipse, 0.7);
}

}  // namespace
}  // namespace sfw
