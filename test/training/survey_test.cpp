#include "training/survey.h"

#include <gtest/gtest.h>

#include <set>

#include "training/clearance.h"
#include "training/survey_places.h"
#include "training/training_world.h"

namespace sfw::test {
namespace {

TEST(SurveyPlaces, TheWalkGoesAlongFreeWaysAndVisitsNearlyAllPlaces) {
  const FloorPlan plan = makeSurveyBuilding(3);
  const Clearance clearance(plan, 0.01);
  Random random(3, 1, 0);
  const SurveyPlaces places(plan, random);
  const std::vector<std::size_t> walk = places.walk(random);
  ASSERT_GT(walk.size(), 20U);
  for (std::size_t i = 1; i < walk.size(); ++i) {
    const Position from = places.position(walk[i - 1]);
    const Position to = places.position(walk[i]);
    EXPECT_TRUE(clearance.allows(from, to)) << "step " << i;
    EXPECT_LT((to - from).norm(), 2.0) << "longer gaps would break the path";
  }
}

TEST(SurveyPlaces, ABuildingWithoutSpaceHasNoWalk) {
  const FloorPlan plan(GridGeometry(0.05, Position::Zero(), 40, 40), Material::kInteriorWall);
  Random random(1, 1, 0);
  EXPECT_TRUE(SurveyPlaces(plan, random).walk(random).empty());
  EXPECT_FALSE(makeSurvey(plan, noiseLevel("low"), 1, random).has_value());
}

TEST(Survey, MeasuresKnownAccessPointsAtPlacesOnly) {
  Random random(5, 1, 0);
  const auto drive = makeSurvey(makeSurveyBuilding(5), noiseLevel("low"), 5, random);
  ASSERT_TRUE(drive.has_value());
  std::set<std::string> known;
  for (const AccessPoint& access_point : drive->access_points) {
    EXPECT_TRUE(known.insert(access_point.bssid.str()).second) << "a BSSID comes up twice";
  }
  for (std::size_t i = 0; i < drive->readings.size(); ++i) {
    EXPECT_EQ(known.count(drive->readings[i].bssid.str()), 1U);
    EXPECT_TRUE(i == 0 || drive->readings[i].stamp_ns >= drive->readings[i - 1].stamp_ns);
  }
  EXPECT_GE(pathOf(drive->readings).size(), 20U);
}

}  // namespace
}  // namespace sfw::test
