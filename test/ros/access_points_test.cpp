// The mapping nodelet with access points at right, wrong and unknown positions.

#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>
#include <structure_from_wifi/AccessPoints.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/random.h"
#include "mapping_nodelet_world.h"
#include "structure_from_wifi/types.h"

namespace sfw {
namespace {

constexpr char kLost[] = "02:00:00:00:00:03";
constexpr int kSteps = 560;  // through a hall of 8 x 6 m, in lanes 1 m apart

constexpr char kAbout[] = "02:00:00:00:00:04";

class AccessPointsTest : public NodeletWorld {
 protected:
  void SetUp() override {
    NodeletWorld::SetUp();
    XmlRpc::XmlRpcValue table = tableOf({{kNear, 2.0, 1.5}, {kFar, 2.0, 4.5}});  // really at 6, 4.5
    table[2]["bssid"] = std::string(kLost);
    table[2]["name"] = std::string("lost");
    table[3]["bssid"] = std::string(kAbout);
    table[3]["x"] = 7.0;  // really at 5, 5
    table[3]["y"] = 5.0;
    table[3]["position_sd"] = 2.0;
    ros::param::set(name_ + "/mapping/access_points", table);
    ros::NodeHandle node;
    subscribers_.push_back(node.subscribe<structure_from_wifi::AccessPoints>(
        name_ + "/access_points", 10,
        [this](const structure_from_wifi::AccessPointsConstPtr& message) {
          published_ = message;
        }));
    subscribers_.push_back(node.subscribe<visualization_msgs::MarkerArray>(
        name_ + "/markers", 10,
        [this](const visualization_msgs::MarkerArrayConstPtr& markers) { markers_ = markers; }));
    subscribers_.push_back(node.subscribe<rosgraph_msgs::Log>(
        "/rosout", 100, [this](const rosgraph_msgs::LogConstPtr& log) {
          if (log->level == rosgraph_msgs::Log::WARN) {
            logged_.push_back(log->msg);
          }
        }));
    load();
  }

  void drive(int steps) {
    send(0, steps);
    EXPECT_EQ(rows(4U * static_cast<unsigned>(steps)).size(), 4U * static_cast<unsigned>(steps));
  }

  void send(int first, int last) {
    Random random(1, 2, 3);
    const auto rssiAt = [&](const Position& place, const Position& access_point) {
      const double distance = std::max(0.3, (place - access_point).norm());
      return static_cast<float>(-40.0 - 20.0 * std::log10(distance) + random.normal());
    };
    for (int i = first; i < last; ++i) {
      const int lane = i / 80;
      const Position place(0.1 * (lane % 2 == 0 ? i % 80 : 80 - i % 80), lane);
      sendPose(0.1 * i, place.x(), place.y());
      sendScan(0.1 * i, {{kNear, rssiAt(place, {2.0, 1.5})},
                         {kFar, rssiAt(place, {6.0, 4.5})},
                         {kLost, rssiAt(place, {5.0, 1.0})},
                         {kAbout, rssiAt(place, {5.0, 5.0})}});
      ros::Time::setNow(at(0.1 * i));
      ros::WallDuration(0.001).sleep();
    }
  }

  /// Warnings that were logged with a text in them.
  std::size_t warnings(const std::string& text) const {
    return static_cast<std::size_t>(std::count_if(
        logged_.begin(), logged_.end(),
        [&](const std::string& message) { return message.find(text) != std::string::npos; }));
  }

  bool isJudged() {
    return published_ && published_->access_points.size() == 4U &&
           std::isfinite(published_->access_points[1].fit_db);
  }

  /// Of that group and number, or nullptr.
  const visualization_msgs::Marker* marker(const std::string& group, int id) const {
    for (const visualization_msgs::Marker& marker : markers_->markers) {
      if (marker.ns == group && marker.id == id) {
        return &marker;
      }
    }
    return nullptr;
  }

  std::vector<ros::Subscriber> subscribers_;
  std::vector<std::string> logged_;
  structure_from_wifi::AccessPointsConstPtr published_;
  visualization_msgs::MarkerArrayConstPtr markers_;
};

TEST_F(AccessPointsTest, PublishesWhichPositionsAgreeWithTheReadings) {
  drive(kSteps);
  ASSERT_TRUE(spinUntil([&] { return isJudged(); }, 30.0));
  const structure_from_wifi::AccessPoint& right = published_->access_points[0];
  EXPECT_FALSE(right.estimated);
  EXPECT_FALSE(right.suspect);
  EXPECT_LT(right.fit_db, 2.0);
  EXPECT_NEAR(right.seems_to_stand_at.x, 2.0, 0.5);
  const structure_from_wifi::AccessPoint& wrong = published_->access_points[1];
  EXPECT_TRUE(wrong.suspect);
  EXPECT_GT(wrong.fit_db, right.fit_db);
  EXPECT_EQ(wrong.position.x, 2.0) << "is used as given all the same";
  EXPECT_NEAR(wrong.seems_to_stand_at.x, 6.0, 0.7);
  EXPECT_NEAR(wrong.seems_to_stand_at.y, 4.5, 0.7);
  const structure_from_wifi::AccessPoint& lost = published_->access_points[2];
  EXPECT_TRUE(lost.estimated);
  EXPECT_FALSE(lost.suspect);
  EXPECT_TRUE(std::isnan(lost.fit_db));
  EXPECT_TRUE(std::isnan(lost.seems_to_stand_at.x));
  EXPECT_NEAR(lost.position.x, 5.0, 1.0);
  EXPECT_TRUE(std::isnan(lost.given_sd));
  const structure_from_wifi::AccessPoint& about = published_->access_points[3];
  EXPECT_TRUE(about.estimated);
  EXPECT_EQ(about.given_position.x, 7.0);
  EXPECT_EQ(about.given_sd, 2.0);
  EXPECT_NEAR(about.position.x, 5.0, 1.0);
  EXPECT_GT(about.covariance[0], 0.0);

  const std::string report = savedFile("report.json");
  EXPECT_NE(report.find("\"suspect\": true"), std::string::npos);
  EXPECT_NE(report.find("\"suspect\": false"), std::string::npos);
}

TEST_F(AccessPointsTest, WarnsOfAWrongPositionWhileTheRobotDrives) {
  const std::string warning = std::string("much better than the given one: ") + kFar;
  constexpr int kMost = kSteps - 80;
  send(0, kMost);
  ASSERT_TRUE(spinUntil([&] { return warnings(warning) > 0; }, 30.0)) << "nobody saves the map";
  published_.reset();
  send(kMost, kSteps);
  ASSERT_TRUE(spinUntil([&] { return published_ != nullptr; }, 30.0));
  EXPECT_EQ(warnings(warning), 1U) << "once is enough";
  EXPECT_EQ(warnings(kNear), 0U);
}

TEST_F(AccessPointsTest, WarnsUntilTheFirstReading) {
  EXPECT_TRUE(spinUntil(
      [&] {
        return warnings("No reading yet: no message has come on " + name_ + "/wifi_scan") > 0;
      },
      30.0));
}

TEST_F(AccessPointsTest, ShowsWhatIsEstimatedAndWhatIsSuspect) {
  drive(kSteps);
  ASSERT_TRUE(spinUntil([&] { return isJudged() && markers_ && marker("doubts", 1); }, 30.0));
  ASSERT_NE(marker("access_points", 0), nullptr);
  ASSERT_NE(marker("access_points", 1), nullptr);
  for (const int number : {0, 1, 2}) {
    ASSERT_NE(marker("names", number), nullptr);
  }
  EXPECT_NE(marker("access_points", 0)->color, marker("access_points", 1)->color);
  EXPECT_EQ(marker("names", 0)->text, kNear);
  EXPECT_NE(marker("names", 1)->text.find("readings fit 4."), std::string::npos)
      << marker("names", 1)->text;
  EXPECT_NE(marker("names", 2)->text.find("lost\nestimated, ± "), std::string::npos)
      << marker("names", 2)->text;
  EXPECT_EQ(marker("uncertainty", 0), nullptr);
  EXPECT_EQ(marker("doubts", 0), nullptr);
  ASSERT_NE(marker("doubts", 1), nullptr);
  EXPECT_EQ(marker("doubts", 1)->points.size(), 2U);
  const visualization_msgs::Marker* ellipse = marker("uncertainty", 2);
  ASSERT_NE(ellipse, nullptr);
  EXPECT_EQ(marker("doubts", 2), nullptr);
  EXPECT_GE(ellipse->scale.x, ellipse->scale.y);
  EXPECT_GT(ellipse->scale.y, 0.0);
  EXPECT_LT(ellipse->color.a, 1.0F);
  const auto& turn = ellipse->pose.orientation;
  EXPECT_NEAR(turn.z * turn.z + turn.w * turn.w, 1.0, 1e-9);
}

TEST_F(AccessPointsTest, JudgesNothingFromAFewReadings) {
  drive(5);
  ASSERT_TRUE(spinUntil(
      [&] {
        return published_ && !published_->access_points.empty() &&
               published_->access_points[0].readings && markers_;
      },
      5.0));
  for (const structure_from_wifi::AccessPoint& access_point : published_->access_points) {
    EXPECT_TRUE(std::isnan(access_point.fit_db));
    EXPECT_FALSE(access_point.suspect);
    EXPECT_EQ(access_point.estimated, access_point.bssid == kAbout) << "its prior is all there is";
  }
  EXPECT_EQ(marker("names", 2), nullptr) << "is nowhere";
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "access_points_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
