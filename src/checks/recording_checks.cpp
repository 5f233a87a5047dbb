#include "checks/recording_checks.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/erase_if.h"
#include "base/rssi_range.h"
#include "checks/radio_checks.h"
#include "checks/sentinel_checks.h"
#include "checks/signal_checks.h"
#include "checks/time_checks.h"
#include "checks/unit_checks.h"
#include "path/poses_between.h"

namespace sfw {
namespace {

using ByRadio = std::vector<ReadingRefs>;

bool isSignal(const Reading& reading) { return isInRssiRange(reading.rssi_dbm); }

bool earlier(const Reading& a, const Reading& b) {
  return std::tie(a.robot, a.stamp_ns) < std::tie(b.robot, b.stamp_ns);
}

/// Every pose once, by robot and stamp, of accepted and of refused readings.
std::vector<PathPose> posesOf(const RecordingData& data) {
  const auto isNext = [](const ReadingRefs& readings, std::size_t i) {
    const Reading& reading = readings[i];
    const Reading& before = readings[i == 0 ? 0 : i - 1];
    return i == 0 || before.stamp_ns != reading.stamp_ns ||
           before.antenna_in_map != reading.antenna_in_map || before.robot != reading.robot;
  };
  std::vector<PathPose> poses;
  const auto add = [&](const ReadingRefs& readings) {
    std::size_t count = poses.size();
    for (std::size_t i = 0; i < readings.size(); ++i) {
      count += isNext(readings, i) ? 1 : 0;
    }
    poses.reserve(count);  // a list that grows would take twice the memory
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (isNext(readings, i)) {
        const Reading& reading = readings[i];
        poses.push_back(
            {reading.stamp_ns, reading.antenna_in_map, PathPose::kNoWallCount, reading.robot});
      }
    }
  };
  add(data.accepted);
  add(data.refused);
  return sortedPath(std::move(poses));
}

/// The readings of each access point, by robot and stamp.
class Radios {
 public:
  explicit Radios(const CheckedRecording& recording) {
    const std::size_t count = recording.table.size();
    signals.resize(count);
    others.resize(count);
    std::map<Bssid, std::size_t> index_of;
    for (std::size_t i = 0; i < count; ++i) {
      index_of.emplace(recording.table[i].bssid, i);
    }
    std::vector<std::size_t> most(
        count);  // readings: vectors that grow would take twice the memory
    for (const Reading& reading : recording.data.accepted) {
      const auto found = index_of.find(reading.bssid);
      if (found != index_of.end()) {
        ++most[found->second];
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      signals[i].reserve(most[i]);
    }
    add(recording.data.accepted, index_of);
    add(recording.data.refused, index_of);
    for (ByRadio* kind : {&signals, &others}) {
      for (ReadingRefs& radio : *kind) {
        if (!std::is_sorted(radio.begin(), radio.end(), earlier)) {  // sorting takes more memory
          std::stable_sort(radio.begin(), radio.end(), earlier);
        }
      }
    }
  }

  ByRadio signals;  // in (-120, 0] dBm
  ByRadio others;   // other numbers, which the mapper refuses

 private:
  void add(const ReadingRefs& readings, const std::map<Bssid, std::size_t>& index_of) {
    for (const Reading& reading : readings) {
      const auto found = index_of.find(reading.bssid);
      if (found == index_of.end()) {
        continue;
      }
      ReadingRefs& radio = (isSignal(reading) ? signals : others)[found->second];
      if (radio.empty() || radio.back().get().stamp_ns != reading.stamp_ns ||
          radio.back().get().robot != reading.robot) {  // else it is repeated
        radio.emplace_back(reading);
      }
    }
  }
};

bool isOneStamp(const CheckedRecording& recording, const std::vector<PathPose>& poses) {
  return recording.stamped_alike > 0 &&
         std::all_of(poses.begin(), poses.end(),
                     [&](const PathPose& pose) { return pose.stamp_ns == poses.front().stamp_ns; });
}

bool areStampsCut(const CheckedRecording& recording) {
  constexpr double kMany = 0.1;  // of the readings
  return static_cast<double>(recording.stamped_alike) >
         kMany * static_cast<double>(recording.data.accepted.size());
}

void checkPoses(const CheckedRecording& recording, const ByRadio& signals,
                RecordingFindings& findings) {
  const std::vector<PathPose> poses = posesOf(recording.data);
  if (poses.empty()) {
    return;
  }
  findings.is_one_stamp = isOneStamp(recording, poses);
  if (findings.is_one_stamp) {
    return;
  }
  const bool is_cut = areStampsCut(recording);
  findings.overlap = checkOverlap(poses, recording.data.step_back_ns);
  if (is_cut && findings.overlap && findings.overlap->step_back_s == 0.0) {
    findings.overlap.reset();  // poses of one stamp lie in no order
  }
  findings.are_stamps_cut = is_cut && !findings.overlap;
  if (!findings.overlap && !is_cut) {
    findings.units = checkUnits(poses, powerAtOneUnit(recording.table, signals));
  }
}

/// The checks that show which others make sense: of signals, then of poses.
RecordingFindings checkBasics(const CheckedRecording& recording, Radios& radios) {
  RecordingFindings findings;
  findings.signal_unit = checkSignalUnit(recording.table, radios.signals, radios.others);
  if (!findings.signal_unit) {
    findings.sentinels = findSentinels(recording.table, radios.signals, radios.others);
    for (ReadingRefs& radio : radios.signals) {
      if (findings.sentinels.empty()) {
        break;
      }
      eraseIf(radio, [&](const Reading& reading) {
        return isSentinel(findings.sentinels, reading.bssid, reading.rssi_dbm);
      });
    }
  }
  checkPoses(recording, radios.signals, findings);
  return findings;
}

}  // namespace

RecordingFindings checkRecording(const CheckedRecording& recording) {
  Radios radios(recording);
  RecordingFindings findings = checkBasics(recording, radios);
  const bool are_poses_right = !arePosesWrong(findings);
  if (!findings.signal_unit && are_poses_right) {
    findings.cached = checkCachedSignals(recording.table, radios.signals);
    findings.bursts = checkBursts(radios.signals);
    findings.single_place = findHeardAtOnePlace(recording.table, radios.signals, recording.path);
  }
  if (are_poses_right && !findings.bursts) {
    findings.gaps = checkGaps(recording.path, recording.max_gap_m);
  }
  return findings;
}

std::optional<UnitFinding> checkUnits(const CheckedRecording& recording) {
  Radios radios(recording);
  return checkBasics(recording, radios).units;
}

bool arePosesWrong(const RecordingFindings& findings) {
  return findings.is_one_stamp || findings.are_stamps_cut || findings.overlap || findings.units;
}

}  // namespace sfw
