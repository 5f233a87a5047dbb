// Sessions, regions and the rule of refreshes, without a ROS master.

#include "ros/mapping/session.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "ros/conversion/message_conversion.h"
#include "ros/mapping/refresh_rule.h"
#include "ros/mapping/region.h"
#include "ros/mapping/shared_mapper.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

const Bssid kA = *Bssid::parse("02:00:00:00:00:0a");
const Bssid kB = *Bssid::parse("02:00:00:00:00:0b");

LocatedObservation reading(double x, double y, const Bssid& bssid = kA) {
  static std::int64_t stamp_ns = 0;
  return {{{++stamp_ns, {x, y}, bssid, -50.0}}, {}, {}};
}

TEST(RefreshRule, AStandingRobotBringsNoNewsAfterFiveReadings) {
  RefreshRule rule(0.2);
  int news = 0;
  for (int i = 0; i < 1000; ++i) {
    news += rule.isNews(reading(1.05 + 1e-5 * i, 1.05)) ? 1 : 0;
  }
  EXPECT_EQ(news, 5);
  EXPECT_TRUE(rule.isNews(reading(1.05, 1.05, kB))) << "another access point";
  EXPECT_TRUE(rule.isNews(reading(1.25, 1.05))) << "another place";
  rule.clear();
  EXPECT_TRUE(rule.isNews(reading(1.05, 1.05)));
}

TEST(RefreshRule, CountsContactsAndIgnoresPositionsThatNoMapHas) {
  RefreshRule rule(0.2);
  const LocatedObservation touch{{}, {{1, {0.1, 0.1}}}, {}};
  EXPECT_TRUE(rule.isNews(touch));
  EXPECT_FALSE(rule.isNews(touch)) << "the robot still touches it";
  const LocatedObservation beside{{}, {{2, {0.16, 0.1}}}, {}};
  EXPECT_TRUE(rule.isNews(beside)) << "it turned, and touches the wall again";
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -1e300}) {
    EXPECT_FALSE(rule.isNews(reading(bad, 0.0)));
  }
}

TEST(UpdatePeriod, IsTheLongerOfRateAndShare) {
  EXPECT_DOUBLE_EQ(updatePeriod(1.0, 0.25, 0.1), 1.0);
  EXPECT_DOUBLE_EQ(updatePeriod(1.0, 0.25, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(updatePeriod(20.0, 1.0, 0.5), 0.5);
}

TEST(Region, AnLShapeContainsItsArmsOnly) {
  const std::vector<Position> l = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_TRUE(contains(l, {2.5, 0.5}));
  EXPECT_TRUE(contains(l, {0.5, 2.5}));
  EXPECT_FALSE(contains(l, {2.0, 2.0}));
  EXPECT_FALSE(contains(l, {-0.5, 0.5}));
}

TEST(MapUpdate, IsTheRectangleOfAllChanges) {
  nav_msgs::OccupancyGrid before;
  before.info.width = 5;
  before.info.height = 4;
  before.data.assign(20, -1);
  nav_msgs::OccupancyGrid after = before;
  after.data[1 * 5 + 3] = 0;
  after.data[3 * 5 + 2] = 100;
  const map_msgs::OccupancyGridUpdate update = toUpdate(before, after);
  EXPECT_EQ(update.x, 2);
  EXPECT_EQ(update.y, 1);
  EXPECT_EQ(update.width, 2U);
  EXPECT_EQ(update.height, 3U);
  EXPECT_EQ(update.data, (std::vector<std::int8_t>{-1, 0, -1, -1, 100, -1}));
  const map_msgs::OccupancyGridUpdate nothing = toUpdate(after, after);
  EXPECT_LT(nothing.x + static_cast<int>(nothing.width), 6);
  EXPECT_EQ(nothing.data.size(), 1U);
}

class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sfw_session_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    session_.access_points = {{kA, "a", {1.0, 2.0}, {}, {}}, {kB, "b", {3.0, 2.0}, {}, {}}};
    for (int i = 0; i < 20; ++i) {
      session_.readings.push_back({i, {0.1 * i, 0.5}, i % 2 == 0 ? kA : kB, -40.0 - i});
    }
    session_.contacts = {{7, {0.3, 0.9}}};
    session_.path = {{8, {0.75, 0.5}}, {9, {0.85, 0.5}}};
    writeSession(session_, folder_.string());
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string refusal(const Config::Map& config = {}) const {
    try {
      readSession(folder_.string(), config);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  void write(const char* file, const std::string& content) const {
    std::ofstream(folder_ / file, std::ios::binary) << content;
  }

  std::string read(const char* file) const {
    std::ifstream stream(folder_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
  Session session_;
};

TEST_F(SessionTest, IsReadAsItWasWritten) {
  const Session again = readSession(folder_.string(), {});
  EXPECT_EQ(again.readings.size(), 20U);
  EXPECT_EQ(again.readings.back().rssi_dbm, -59.0);
  EXPECT_EQ(again.contacts.size(), 1U);
  ASSERT_EQ(again.path.size(), 2U);
  EXPECT_EQ(again.path[1].stamp_ns, 9);
  EXPECT_EQ(again.path[1].antenna_in_map, Position(0.85, 0.5));
  EXPECT_EQ(again.access_points.size(), 2U);
  fs::remove(folder_ / "path.csv");
  EXPECT_TRUE(readSession(folder_.string(), {}).path.empty()) << "of an old version";
}

TEST_F(SessionTest, EveryCutOfAFileIsRefusedOrLosesWholeRowsOnly) {
  const std::string whole = read("readings.csv");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write("readings.csv", whole.substr(0, length));
    const bool ends_with_row = length > 0 && whole[length - 1] == '\n' && length > 30;
    EXPECT_EQ(refusal().empty(), ends_with_row) << length << ": " << refusal();
  }
}

TEST_F(SessionTest, HostileFilesAreRefusedByName) {
  const std::string whole = read("readings.csv");
  write("readings.csv", whole + "nan,0,0,02:00:00:00:00:0a,-50\n");
  EXPECT_NE(refusal().find("readings.csv"), std::string::npos);
  write("readings.csv", std::string(5000, '\0') + "\n");
  EXPECT_NE(refusal().find("readings.csv"), std::string::npos);
  write("readings.csv", whole);
  Config::Map small;
  small.max_readings = 1;
  EXPECT_NE(refusal(small).find("too large"), std::string::npos);
  write("access_points.yaml", "access_points: {\n");
  EXPECT_NE(refusal().find("access_points.yaml"), std::string::npos);
  fs::remove(folder_ / "contacts.csv");
  fs::create_directory(folder_ / "contacts.csv");
  EXPECT_NE(refusal().find("contacts.csv"), std::string::npos);
}

TEST_F(SessionTest, IsAddedWhollyOrNotAtAll) {
  SharedMapper mapper(Config(), {{kA, "", {5.0, 5.0}, {}, {}}}, jumpTolerance({}));
  mapper.insert(reading(0.0, 0.0));
  Session hostile = session_;
  hostile.readings.push_back({99, {1e7, 0.0}, kA, -50.0});
  EXPECT_THROW(mapper.add(hostile), InputError);
  EXPECT_EQ(mapper.readings(), 1U);
  EXPECT_EQ(mapper.corrected({}).mapper.readings().size(), 1U);
  EXPECT_EQ(mapper.corrected({}).mapper.accessPoints().size(), 1U);

  EXPECT_EQ(mapper.add(session_), 1U) << "kA stands elsewhere in the session";
  const Mapper merged = mapper.corrected({}).mapper;
  EXPECT_EQ(merged.readings().size(), 21U);
  EXPECT_EQ(merged.contacts().size(), 1U);
  EXPECT_EQ(merged.poses().size(), 2U);
  ASSERT_EQ(merged.accessPoints().size(), 2U);
  EXPECT_EQ(merged.accessPoints()[0].position, Position(5.0, 5.0));
}

TEST_F(SessionTest, PlacesAndForgets) {
  SharedMapper mapper(Config(), {{kA, "", {5.0, 5.0}, {}, {}}}, jumpTolerance({}));
  mapper.add(session_);
  mapper.place(kA, {2.0, 2.5});
  EXPECT_EQ(mapper.corrected({}).mapper.accessPoints()[0].position, Position(2.0, 2.5));
  EXPECT_THROW(mapper.place(kB, {1e7, 0.0}), InputError);
  const Box extent = mapper.corrected({}).mapper.extent();
  const auto forgotten = mapper.forget([](const Position& point) { return point.x() < 0.95; });
  EXPECT_EQ(forgotten.first, 10U);
  EXPECT_EQ(forgotten.second, 1U);
  EXPECT_EQ(mapper.readings(), 10U);
  EXPECT_TRUE(mapper.corrected({}).mapper.extent().contains(extent)) << "the geometry stays";
}

}  // namespace
}  // namespace sfw
