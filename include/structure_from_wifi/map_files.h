#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// map.pgm and map.yaml as map_server reads them: 254 free, 0 occupied, 205 unknown.
SFW_EXPORT std::string trinaryPgm(const BeliefMap& belief);
/// Probability of being occupied: 255 (1 - p), 128 where nothing is known.
SFW_EXPORT std::string probabilityPgm(const BeliefMap& belief);
SFW_EXPORT std::string trinaryYaml(const GridGeometry& geometry,
                                   const std::string& image = "map.pgm");
SFW_EXPORT std::string probabilityYaml(const GridGeometry& geometry);

/// Loss of signals through each cell in steps of kWallLossStep from 0 (black) on, at most 255: what
/// the radio alone says of walls. map_server's scale mode, negated.
SFW_EXPORT std::string wallLossPgm(const Grid<float>& wall_loss);
SFW_EXPORT std::string wallLossYaml(const GridGeometry& geometry);
constexpr double kWallLossStep = 0.05;  // [dB]

/// A table that readReadings reads back to the same readings.
SFW_EXPORT std::string readingsCsv(const std::vector<Reading>& readings);
/// A table that readContacts reads back.
SFW_EXPORT std::string contactsCsv(const std::vector<Contact>& contacts);

/// A table that readAccessPoints reads back.
SFW_EXPORT std::string accessPointsYaml(const std::vector<AccessPoint>& access_points);

/// Settings, access points with their thresholds, what was left out and why, and areas; no time of
/// day, so that it repeats.
SFW_EXPORT std::string reportJson(const Snapshot& snapshot, const Config& config,
                                  const DataFindings& findings = {});

/// Writes map.pgm, map.yaml, probability.pgm, probability.yaml, map.png and report.json, of maps
/// that octomapReaches map.bt and map.ot, and of tomography wall_loss.pgm and wall_loss.yaml, into
/// a directory that is made if missing. No old file is replaced before all new ones are written
/// whole; then those are removed that this map has none of.
/// @throw std::system_error or std::invalid_argument naming the file and why.
SFW_EXPORT void writeMapFiles(const Snapshot& snapshot, const Config& config,
                              const std::string& directory, const DataFindings& findings = {});

/// Writes NAME.pgm and NAME.yaml of states that are known rather than believed.
/// @throw std::system_error naming the file and why
SFW_EXPORT void writePlanFiles(const Grid<CellState>& states, const std::string& directory,
                               const std::string& name);

/// Writes readings.csv, contacts.csv and access_points.yaml: what `sfw map` needs to make the map
/// again.
/// @throw as writeMapFiles
SFW_EXPORT void writeRecording(const std::vector<Reading>& readings,
                               const std::vector<Contact>& contacts, const Snapshot& snapshot,
                               const std::string& directory);

}  // namespace sfw
