#pragma once

#include <string>
#include <vector>

#include "simulation/building/floor_plan_generator.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/mapper.h"
#include "support/mapper_scene.h"

namespace sfw::test {

/// What a user gives to the mapper.
struct Recording {
  std::string name;
  std::vector<Reading> readings;  ///< in order of arrival
  std::vector<AccessPoint> table;
  FrameFinding frames = {};
};

/// A drive through a generated building.
inline Recording simulated(BuildingKind kind, const char* noise, std::int64_t access_points,
                           std::int64_t seed, const char* path = "sparse") {
  BuildingConfig building;
  building.kind = kind;
  building.area_m2 = 60.0 + 10.0 * static_cast<double>(seed % 7);
  building.seed = static_cast<std::uint64_t>(seed);
  ScenarioConfig config;
  config.noise = noiseLevel(noise);
  config.path = path;
  config.seed = seed;
  config.access_points = access_points;
  const Scenario scenario = makeScenario(generateFloorPlan(building), {}, config);
  return {std::string(noise) + " noise, " + std::to_string(access_points) +
              " access points, seed " + std::to_string(seed),
          simulate(scenario).readings, scenario.access_points};
}

/// Settings that make a coarse map quickly; the checks do not depend on them.
inline Config quickConfig() {
  Config config = rawConfig();
  config.map.resolution_m = 0.5;
  return config;
}

inline std::vector<std::string> notesOf(const Recording& recording,
                                        const Config& config = quickConfig()) {
  Mapper mapper(config, recording.table);
  for (const Reading& reading : recording.readings) {
    mapper.insert(reading);
  }
  mapper.recordFrames(recording.frames);
  const auto snapshot = mapper.infer();
  std::vector<std::string> texts;
  for (const MapNote& note : mapNotes(*snapshot, DataChecker().checkAll(*snapshot))) {
    texts.push_back(note.text);
  }
  return texts;
}

}  // namespace sfw::test
