#include "simulation/simulated_recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "simulation/building/wall_crossings.h"
#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/input_error.h"
#include "support/moments.h"
#include "support/radio_hall.h"

namespace sfw {
namespace {

using test::accessPointAt;
using test::correlationOf;
using test::momentsOf;

const std::vector<Position> kThroughTheWall{{40, 20}, {60, 20}, {60, 25}};

std::vector<Transmitter> twoTransmitters() {
  return {{accessPointAt({30, 20}), Band::k2400MHz},
          {accessPointAt({70, 30}, "02:00:00:00:00:02"), Band::k5000MHz}};
}

SimulatedRecording recordingOf(const RecordingConfig& config) {
  return simulateRecording(test::dividedHall(), kThroughTheWall, twoTransmitters(), config);
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Seconds since the start.
double timeOf(const Reading& reading, const RecordingConfig& config) {
  return static_cast<double>(reading.stamp_ns) * 1e-9 - config.start_s;
}

// ---- When what is heard ----

TEST(Recording, ALinkHearsEveryAccessPointAtItsRate) {
  RecordingConfig config;
  config.link_rate_hz = 10.0;
  const SimulatedRecording recording = recordingOf(config);
  const double duration = SimulatedDrive(kThroughTheWall, config).duration();
  const auto samples = static_cast<std::size_t>(std::floor(duration * 10.0)) + 1;
  ASSERT_EQ(recording.readings.size(), 2 * samples);
  ASSERT_EQ(recording.truth.size(), recording.readings.size());
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    EXPECT_EQ(recording.readings[i].stamp_ns,
              1000000000000 + static_cast<std::int64_t>(i / 2) * 100000000);
    EXPECT_EQ(recording.truth[i].access_point, i % 2);
    EXPECT_EQ(recording.readings[i].bssid, twoTransmitters()[i % 2].access_point.bssid);
  }
}

TEST(Recording, AScanHearsEachAccessPointOnceAtItsOwnTime) {
  RecordingConfig config;
  config.listening = Listening::kScans;
  config.scan_period_s = 3.0;
  const SimulatedRecording recording = recordingOf(config);
  const double duration = SimulatedDrive(kThroughTheWall, config).duration();
  std::vector<std::vector<double>> times(2);
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    times[recording.truth[i].access_point].push_back(timeOf(recording.readings[i], config));
    if (i > 0) {
      EXPECT_LE(recording.readings[i - 1].stamp_ns, recording.readings[i].stamp_ns);
    }
  }
  for (const std::vector<double>& of_one : times) {
    EXPECT_GE(static_cast<double>(of_one.size()), std::floor(duration / 3.0));
    EXPECT_GE(of_one.front(), 0.0);
    EXPECT_LT(of_one.front(), 3.0);
    for (std::size_t i = 1; i < of_one.size(); ++i) {
      EXPECT_NEAR(of_one[i] - of_one[i - 1], 3.0, 1e-6);
    }
  }
  EXPECT_GT(std::abs(times[0].front() - times[1].front()), 0.01);
}

TEST(Recording, LeavesOutWhatIsNotHeard) {
  RecordingConfig config;
  config.link_rate_hz = 20.0;
  const auto complete = static_cast<double>(recordingOf(config).readings.size());
  config.radio.missed_share = 0.25;
  const SimulatedRecording recording = recordingOf(config);
  const double share = static_cast<double>(recording.readings.size()) / complete;
  EXPECT_NEAR(share, 0.75, 4.0 * std::sqrt(0.25 * 0.75 / complete));
  EXPECT_EQ(recording.truth.size(), recording.readings.size());
}

// ---- Truth ----

TEST(Recording, TellsTruePosesAndWallCounts) {
  const RecordingConfig config;
  const FloorPlan plan = test::dividedHall();
  const SimulatedRecording recording = recordingOf(config);
  const SimulatedDrive drive(kThroughTheWall, config);
  const RadioModel radio(plan, twoTransmitters(), config.radio);
  int behind = 0;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const ReadingTruth& truth = recording.truth[i];
    const RobotPose pose = drive.truePose(timeOf(recording.readings[i], config));
    EXPECT_NEAR((truth.pose.position - pose.position).norm(), 0.0, 1e-6);
    EXPECT_NEAR(truth.pose.yaw_rad, pose.yaw_rad, 1e-6);
    const Position source = twoTransmitters()[truth.access_point].access_point.position;
    EXPECT_EQ(truth.walls, countWalls(plan, source, truth.pose.position));
    behind += truth.walls;
    // Without errors the reported position is the true one.
    EXPECT_EQ(recording.readings[i].antenna_in_map, truth.pose.position);
  }
  EXPECT_GT(behind, 0);
}

TEST(Recording, HearsAtTheTruePlaceNotAtTheReportedOne) {
  RecordingConfig exact, wrong;
  wrong.registration_error_m = 0.5;
  wrong.drift = 0.05;
  const SimulatedRecording a = recordingOf(exact), b = recordingOf(wrong);
  ASSERT_EQ(a.readings.size(), b.readings.size());
  for (std::size_t i = 0; i < a.readings.size(); ++i) {
    EXPECT_EQ(a.readings[i].rssi_dbm, b.readings[i].rssi_dbm);
    EXPECT_EQ(a.truth[i].walls, b.truth[i].walls);
    EXPECT_NE(a.readings[i].antenna_in_map, b.readings[i].antenna_in_map);
  }
}

// ---- Errors of the reported path ----

Position errorAt(const SimulatedDrive& drive, double time_s) {
  return drive.reportedPose(time_s).position - drive.truePose(time_s).position;
}

TEST(SimulatedDrive, RegistrationErrorIsASmoothFunctionOfPlace) {
  RecordingConfig config;
  config.speed_m_s = 1.0;
  config.registration_error_m = 0.1;
  config.registration_distance_m = 3.0;
  // There and back with turns of a millisecond: a second is a metre.
  config.yaw_rate_rad_s = 100.0;
  std::vector<double> here, beside, far;
  for (config.radio.seed = 0; config.radio.seed < 500; ++config.radio.seed) {
    const SimulatedDrive drive({{5, 5}, {25, 5}, {5, 5}}, config);
    for (const int axis : {0, 1}) {
      here.push_back(errorAt(drive, 4.0)[axis]);
      beside.push_back(errorAt(drive, 4.1)[axis]);
      far.push_back(errorAt(drive, 7.0)[axis]);
    }
    const double back_s = drive.duration() - 4.0;
    EXPECT_NEAR((errorAt(drive, 4.0) - errorAt(drive, back_s)).norm(), 0.0, 1e-6);
  }
  // 1000 values; four standard errors.
  EXPECT_NEAR(momentsOf(here).mean, 0.0, 4.0 * 0.1 / std::sqrt(1000.0));
  EXPECT_NEAR(momentsOf(here).deviation, 0.1, 4.0 * 0.1 / std::sqrt(2000.0));
  EXPECT_NEAR(correlationOf(here, far), std::exp(-1.0), 4.0 / std::sqrt(1000.0));
  EXPECT_GT(correlationOf(here, beside), 0.995);
}

TEST(SimulatedDrive, DriftGrowsWithTheWay) {
  RecordingConfig config;
  config.speed_m_s = 1.0;
  config.drift = 0.01;
  for (const double way_m : {2.0, 50.0}) {
    double squares = 0.0;
    for (config.radio.seed = 0; config.radio.seed < 500; ++config.radio.seed) {
      const SimulatedDrive drive({{0, 0}, {100, 0}}, config);
      squares += errorAt(drive, way_m).squaredNorm();
    }
    // A squared error has its mean as standard deviation, its root half of that.
    EXPECT_NEAR(std::sqrt(squares / 500.0) / way_m, 0.01, 4.0 * 0.5 * 0.01 / std::sqrt(500.0));
  }
  EXPECT_EQ(errorAt(SimulatedDrive({{0, 0}, {100, 0}}, config), 0.0), Position(0, 0));
}

// ---- All of it ----

TEST(Recording, DependsOnItsSeed) {
  const auto signals = [](const NoiseLevel& level, std::int64_t seed) {
    std::vector<double> values;
    for (const Reading& reading : recordingOf(recordingConfig(level, seed)).readings) {
      values.insert(values.end(), {reading.rssi_dbm, reading.antenna_in_map.x()});
    }
    return values;
  };
  for (const NoiseLevel& level : kNoiseLevels) {
    EXPECT_EQ(signals(level, 1), signals(level, 1));
    EXPECT_EQ(signals(level, 1) == signals(level, 2), level.name == "none");
  }
}

TEST(Recording, AnotherAccessPointChangesNothingForTheOthers) {
  const RecordingConfig config = recordingConfig(noiseLevel("realistic"), 3);
  const SimulatedRecording both = recordingOf(config);
  const SimulatedRecording alone =
      simulateRecording(test::dividedHall(), kThroughTheWall, {twoTransmitters()[0]}, config);
  std::vector<double> heard_alone, heard_of_both;
  for (const Reading& reading : alone.readings) {
    heard_alone.push_back(reading.rssi_dbm);
  }
  for (std::size_t i = 0; i < both.readings.size(); ++i) {
    if (both.truth[i].access_point == 0) {
      heard_of_both.push_back(both.readings[i].rssi_dbm);
    }
  }
  EXPECT_EQ(heard_alone, heard_of_both);
}

TEST(Recording, GivesTheSameSignalsOnEveryMachine) {
  RecordingConfig config = recordingConfig(noiseLevel("realistic"), 5);
  config.link_rate_hz = 0.25;
  std::vector<double> heard;
  for (const Reading& reading : recordingOf(config).readings) {
    heard.push_back(reading.rssi_dbm);
  }
  EXPECT_EQ(heard,
            (std::vector<double>{-56, -79, -58, -74, -65, -75, -63, -76, -59, -66, -64, -70, -71,
                                 -59, -78, -55, -70, -57, -77, -53, -70, -53, -76, -52, -62, -60}));
}

TEST(Recording, NamesEverySettingOutOfRange) {
  RecordingConfig config;
  config.speed_m_s = 0.0;
  config.drift = NAN;
  config.radio.rssi_step_db = -1.0;
  EXPECT_EQ(messageOf([&] { recordingOf(config); }),
            "speed must lie in 0.01..10; it is 0\n"
            "drift must lie in 0..1; it is nan\n"
            "radio/step must lie in 0..10; it is -1");
  EXPECT_EQ(messageOf([] {
              simulateRecording(test::emptyHall(), {{1, 1}}, twoTransmitters(), RecordingConfig());
            }),
            "a route needs at least two different way points");
}

}  // namespace
}  // namespace sfw
