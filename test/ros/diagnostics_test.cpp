// What diagnostics say, from the facts alone.

#include "ros/mapping/diagnostics.h"

#include <gtest/gtest.h>

#include <string>

#include "ros/mapping/announcements.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr int kOk = DiagnosticStatus::OK;
constexpr int kWarn = DiagnosticStatus::WARN;
constexpr int kError = DiagnosticStatus::ERROR;

DiagnosticStatusWrapper described(void (*describe)(const MappingStatus&, DiagnosticStatusWrapper&),
                                  const MappingStatus& status) {
  DiagnosticStatusWrapper to;
  describe(status, to);
  return to;
}

std::string valueOf(const DiagnosticStatusWrapper& to, const std::string& key) {
  for (const diagnostic_msgs::KeyValue& pair : to.values) {
    if (pair.key == key) {
      return pair.value;
    }
  }
  return "(no value " + key + ")";
}

/// A nodelet that runs for a minute and to which nothing was sent.
MappingStatus silent() {
  MappingStatus status;
  status.now_s = 1060.0;
  status.running_s = 60.0;
  status.inputs.resize(2);
  status.inputs[0].topic = "/wifi_scan";
  status.inputs[0].is_radio = true;
  status.inputs[1].topic = "/contact";
  status.transform = {"map", "antenna", {}, "", 0.1};
  status.transform_timeout_s = 5.0;
  return status;
}

/// The same with a reading a second ago.
MappingStatus hearing() {
  MappingStatus status = silent();
  status.inputs[0].messages = status.inputs[0].observations = 10;
  status.inputs[0].last_message_s = status.inputs[0].last_observation_s = 1059.0;
  return status;
}

void expectStatus(const DiagnosticStatusWrapper& to, int level, const std::string& words) {
  EXPECT_EQ(static_cast<int>(to.level), level) << to.message;
  EXPECT_NE(to.message.find(words), std::string::npos) << to.message;
}

TEST(Diagnostics, NameTheTopicsOnWhichNothingComes) {
  expectStatus(described(describeInputs, silent()), kWarn, "/wifi_scan");
  expectStatus(described(describeMap, silent()), kWarn, "no message has come on /wifi_scan");
  expectStatus(described(describeInputs, hearing()), kOk, "Readings arrive");
}

TEST(Diagnostics, TellOfARadioWithoutAnAccessPointAfterTenSeconds) {
  MappingStatus status = hearing();
  status.inputs[0].problem = "the radio is not associated";
  status.inputs[0].last_observation_s = 1055.0;
  expectStatus(described(describeInputs, status), kOk, "");
  status.inputs[0].last_observation_s = 1040.0;
  expectStatus(described(describeInputs, status), kWarn, "20 s: the radio is not associated");
}

TEST(Diagnostics, TellAScannerThatFellSilentFromOneWithEmptyScans) {
  MappingStatus status = hearing();
  status.inputs[0].last_observation_s = 1010.0;
  EXPECT_EQ(whyNoReading(status), "/wifi_scan brings no reading for 50 s: its scans are empty");
  status.inputs[0].last_message_s = 1020.0;
  EXPECT_EQ(whyNoReading(status),
            "/wifi_scan brings no reading for 50 s: no message has come for 40 s");
}

TEST(Diagnostics, NameMissingFrames) {
  MappingStatus status = hearing();
  status.transform.missing_frames = {"antenna"};
  status.transform.tf_error = "\"antenna\" does not exist";
  status.waiting = 3;
  expectStatus(described(describeTransforms, status), kError, "no frame antenna.");
  expectStatus(described(describeMap, status), kWarn, "tf has no frame antenna");
  EXPECT_EQ(valueOf(described(describeTransforms, status), "readings waiting for a transform"),
            "3");
}

TEST(Diagnostics, TellOfTreesApartAndOldTransforms) {
  MappingStatus status = hearing();
  status.transform.tf_error = "two trees";
  expectStatus(described(describeTransforms, status), kError, "antenna to map");
  status.transform.tf_error.clear();
  status.transform.age_s = 7.0;
  expectStatus(described(describeTransforms, status), kWarn, "7 s old");
  status.transform.age_s = 0.1;
  expectStatus(described(describeTransforms, status), kOk, "");
}

TEST(Diagnostics, TellOfATransformWithTwoPublishers) {
  MappingStatus status = hearing();
  status.frames.published_twice = "map to odom";
  status.frames.flips = 12;
  status.transform.odom_frame = "odom";
  const DiagnosticStatusWrapper described_status = described(describeTransforms, status);
  expectStatus(described_status, kWarn, "Two programs publish the transform from map to odom.");
  EXPECT_EQ(valueOf(described_status, "transforms to and fro"), "12");
  EXPECT_EQ(valueOf(described_status, "frame of the odometry"), "odom");
}

TEST(Diagnostics, TellOfAMissingClock) {
  MappingStatus status = silent();
  status.is_clock_missing = true;
  expectStatus(described(describeTransforms, status), kError, "/clock");
  expectStatus(described(describeMap, status), kWarn, "/clock");
}

TEST(Diagnostics, TellWhyMappingCannotStart) {
  MappingStatus status;
  status.failure = "map/resolution must be above 0\nros/tf_cache must be above 0";
  for (const auto describe : {describeInputs, describeTransforms, describeMap}) {
    EXPECT_EQ(static_cast<int>(described(describe, status).level), kError);
  }
  expectStatus(described(describeMap, status), kError, "map/resolution must be above 0");
  EXPECT_EQ(valueOf(described(describeMap, status), "problems"), status.failure);
}

TEST(Diagnostics, CountRejectionsByReason) {
  MappingStatus status = hearing();
  status.inputs[0].rejected = {{"age_s is malformed", 4}};
  status.rejections.count[InsertResult::kRssiOutOfRange] = 7;
  EXPECT_EQ(valueOf(described(describeInputs, status), "/wifi_scan: rejected: age_s is malformed"),
            "4");
  EXPECT_EQ(valueOf(described(describeMap, status),
                    std::string("rejected: ") + toString(InsertResult::kRssiOutOfRange)),
            "7");
}

TEST(Diagnostics, ListTwentyUnknownAccessPointsAtMost) {
  MappingStatus status = hearing();
  status.readings = 30;
  for (int i = 0; i < 30; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof bssid, "02:00:00:00:00:%02x", i);
    ++status.rejections.unknown_access_points[*Bssid::parse(bssid)];
    ++status.rejections.count[InsertResult::kUnknownAccessPoint];
  }
  const DiagnosticStatusWrapper to = described(describeMap, status);
  expectStatus(to, kWarn, "no access point of the table was heard");
  EXPECT_EQ(valueOf(to, "unknown access points"), "30");
  EXPECT_EQ(valueOf(to, "unknown access points: bssids").size(), 20U * 18U - 1U);
}

TEST(Diagnostics, DescribeTheMap) {
  std::vector<AccessPoint> table(2);
  table[0].bssid = *Bssid::parse("02:00:00:00:00:01");
  table[1].bssid = *Bssid::parse("02:00:00:00:00:02");
  table[1].position = {3.0, 3.0};
  Mapper mapper(Config(), table);
  for (int i = 0; i < 50; ++i) {
    mapper.insert(Reading{i, {0.05 * i, 0.0}, table[0].bssid, -50.0});
  }
  MappingStatus status = hearing();
  status.map = mapper.infer();
  status.free_m2 = 2.0;
  status.readings = 50;
  status.inference_s = 0.25;
  const DiagnosticStatusWrapper to = described(describeMap, status);
  expectStatus(to, kOk, "2.0 m2 of free space from 50 readings");
  EXPECT_EQ(valueOf(to, "access points of the table"), "2");
  EXPECT_EQ(valueOf(to, "access points heard"), "1");
  EXPECT_EQ(valueOf(to, "inference time"), "0.25 s");
  EXPECT_GT(std::stod(valueOf(to, "memory")), 1.0);
  status.update_failure = "no memory";
  expectStatus(described(describeMap, status), kError, "no memory");
}

TEST(InputStatistics, RemembersSoManyReasonsOnly) {
  InputStatistics statistics;
  const std::size_t scan = statistics.add("/scan", true);
  for (int i = 0; i < 1000; ++i) {
    statistics.count(scan, rejection("frame " + std::to_string(i)), 100.0);
  }
  const auto rejected = statistics.inputs(100.0)[scan].rejected;
  EXPECT_EQ(rejected.size(), 101U);
  EXPECT_EQ(rejected.at("other reasons"), 900U);
  EXPECT_EQ(statistics.takeRejected().at("other reasons"), 900U);
}

TEST(InputStatistics, CountsMessagesRatesAndRejections) {
  InputStatistics statistics;
  const std::size_t scan = statistics.add("/scan", true);
  const std::size_t contact = statistics.add("/contact", false);
  const Observation observation{ros::Time(1.0), UnlocatedReading{}};
  Conversion conversion{{observation, observation}};
  conversion.reject("odd");
  conversion.reject("even", 2);
  for (int i = 0; i < 40; ++i) {
    statistics.count(scan, conversion, 100.0 + 0.5 * i);
  }
  auto inputs = statistics.inputs(119.9);
  EXPECT_EQ(inputs[scan].messages, 40U);
  EXPECT_EQ(inputs[scan].observations, 80U);
  EXPECT_EQ(inputs[scan].rejected.at("odd"), 40U);
  EXPECT_EQ(inputs[scan].rejected.at("even"), 80U) << "each reason has its own count";
  EXPECT_EQ(inputs[scan].rate_hz, 2.0);
  EXPECT_EQ(inputs[contact].messages, 0U);
  EXPECT_EQ(statistics.inputs(125.0)[scan].rate_hz, 0.8) << "four seconds are left of ten";
  EXPECT_EQ(statistics.inputs(1e6)[scan].rate_hz, 0.0);
  EXPECT_EQ(statistics.takeRejected().at("odd"), 40U);
  EXPECT_TRUE(statistics.takeRejected().empty());
}

TEST(Announcements, TellEachCauseOnceAndItsChanges) {
  Announcements announcements;
  EXPECT_TRUE(announcements.isNews("tf", "no frame a"));
  EXPECT_FALSE(announcements.isNews("tf", "no frame a"));
  EXPECT_TRUE(announcements.isNews("radio", "no frame a")) << "another cause hid this one";
  EXPECT_TRUE(announcements.isNews("tf", "no frame b"));
  announcements.forget("tf");
  EXPECT_TRUE(announcements.isNews("tf", "no frame b"));
}

TEST(Announcements, RememberSoManyCausesOnly) {
  Announcements announcements;
  std::size_t told = 0;
  for (int i = 0; i < 5000; ++i) {
    told += announcements.isNews("frame /" + std::to_string(i)) ? 1 : 0;
  }
  EXPECT_EQ(told, 1000U);
  EXPECT_TRUE(announcements.isNews("frame /0", "another state"));
}

TEST(Announcements, TellCountsAtPowersOfTen) {
  Announcements announcements;
  std::vector<std::size_t> told;
  for (std::size_t count = 0; count <= 1000; ++count) {
    if (announcements.isNews("lost", count)) {
      told.push_back(count);
    }
  }
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 10, 100, 1000}));
}

}  // namespace
}  // namespace sfw
