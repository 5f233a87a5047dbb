#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "output/report.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/mapper.h"

namespace sfw::test {

inline Bssid bssid(int number) {
  char text[18];
  std::snprintf(text, sizeof text, "02:00:00:00:00:%02x", static_cast<unsigned>(number) & 0xff);
  return *Bssid::parse(text);
}

inline AccessPoint accessPoint(int number, double x, double y) {
  AccessPoint access_point;
  access_point.bssid = bssid(number);
  access_point.position = {x, y};
  return access_point;
}

inline Reading reading(std::int64_t stamp_s, double x, double y, double rssi_dbm, int number = 1) {
  return {stamp_s * 1000000000, {x, y}, bssid(number), rssi_dbm};
}

/// Counts walls on the raw signal, so that tests can write wall counts in dB.
inline Config rawConfig() {
  Config config;
  config.method = "k_visibility";
  config.belief.free_threshold = 0.35;
  config.map.resolution_m = 0.1;
  config.k_visibility.path_loss_exponent = 0.0;
  config.k_visibility.window = 1;
  return config;
}

/// The 64-bit FNV-1a hash.
inline std::uint64_t hashOf(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return hash;
}

/// The hash of the states, probabilities and report of a map.
inline std::uint64_t hashOf(const Snapshot& snapshot) {
  return hashOf(trinaryPgm(snapshot.belief) + probabilityPgm(snapshot.probability) +
                reportJson(snapshot, Config()));
}
inline std::uint64_t hashOf(const Mapper& mapper) { return hashOf(*mapper.infer()); }

/// A drive along a wall at y = 0.5 that stands on the ray of every other pose.
inline std::vector<Reading> drive() {
  std::vector<Reading> readings;
  for (int i = 0; i < 40; ++i) {
    readings.push_back(reading(i, 0.1 * i + 0.03, i < 20 ? 1.02 : 2.02, i % 3 == 0 ? -40 : -60));
    readings.push_back(reading(i, 0.1 * i + 0.03, i < 20 ? 1.02 : 2.02, i % 5 == 0 ? -50 : -70, 2));
  }
  return readings;
}

inline Mapper mapperOf(const std::vector<Reading>& readings) {
  Mapper mapper(rawConfig(), {accessPoint(1, 0.02, 0.02), accessPoint(2, 3.02, 0.52)});
  for (const Reading& one : readings) {
    mapper.insert(one);
  }
  return mapper;
}

inline CellState stateAt(const Snapshot& snapshot, const Position& point) {
  return snapshot.belief.state(snapshot.belief.geometry().cellAt(point));
}

}  // namespace sfw::test
