#include "mapping/joined_radios.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "access_points/radio_groups.h"

namespace sfw {
namespace {

/// The readings of each BSSID that may share a radio with another one; none of the others.
std::vector<std::vector<Reading>> byStamp(const std::vector<AccessPoint>& table,
                                          const Inliers& inliers) {
  std::vector<std::vector<Reading>> all(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (isAlone(i, table)) {
      continue;
    }
    const AccessPointReadings& own = inliers.readings[i];
    all[i].reserve(own.samples.size());
    for (std::size_t j = 0; j < own.samples.size(); ++j) {
      const PathPose& pose = inliers.path[own.poses[j]];
      all[i].push_back({pose.stamp_ns, pose.antenna_in_map, table[i].bssid, own.samples[j].rssi_dbm,
                        pose.robot});
    }
  }
  return all;
}

/// The member that stands for a radio: the one whose position is known best.
std::size_t standIn(const RadioGroup& group, const std::vector<AccessPoint>& table,
                    const std::vector<AccessPointReadings>& readings) {
  return *std::max_element(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t i) {
      return std::make_tuple(table[i].position_known, -table[i].position_sd_m.value_or(0.0),
                             readings[i].samples.size(), table.size() - i);
    };
    return rank(a) < rank(b);
  });
}

/// The readings of a radio: the mean at each pose.
/// @param offset_db  of each member, to take from its signals
AccessPointReadings meanOf(const std::vector<AccessPointReadings>& readings,
                           const std::vector<std::pair<std::size_t, double>>& members) {
  struct Sum {
    Sample sample;
    double count = 0.0;
  };
  std::map<std::uint32_t, Sum> by_pose;
  for (const auto& [member, offset_db] : members) {
    const AccessPointReadings& own = readings[member];
    for (std::size_t j = 0; j < own.samples.size(); ++j) {
      Sum& sum = by_pose[own.poses[j]];
      sum.sample.antenna_in_map = own.samples[j].antenna_in_map;
      sum.sample.rssi_dbm += own.samples[j].rssi_dbm - offset_db;
      sum.count += 1.0;
    }
  }
  AccessPointReadings mean;
  for (const auto& [pose, sum] : by_pose) {
    mean.poses.push_back(pose);
    mean.samples.push_back({sum.sample.antenna_in_map, sum.sample.rssi_dbm / sum.count});
  }
  return mean;
}

}  // namespace

JoinedRadios joinRadios(const std::vector<AccessPoint>& table, Inliers& inliers) {
  JoinedRadios joined;
  joined.radio_of.resize(table.size());
  std::iota(joined.radio_of.begin(), joined.radio_of.end(), std::size_t{0});
  const std::vector<std::vector<Reading>> readings = byStamp(table, inliers);
  for (const RadioGroup& group : groupByRadio(table, readings)) {
    const std::size_t radio = standIn(group, table, inliers.readings);
    std::vector<std::pair<std::size_t, double>> members;
    std::vector<Bssid> bssids;
    for (const std::size_t member : group) {
      members.emplace_back(member, levelDifference(readings[member], readings[radio]));
      bssids.push_back(table[member].bssid);
      joined.radio_of[member] = radio;
    }
    AccessPointReadings mean = meanOf(inliers.readings, members);
    for (const std::size_t member : group) {
      inliers.readings[member] = {};
    }
    inliers.readings[radio] = std::move(mean);
    std::sort(bssids.begin(), bssids.end());
    joined.groups.push_back(std::move(bssids));
  }
  std::sort(joined.groups.begin(), joined.groups.end());
  return joined;
}

}  // namespace sfw
