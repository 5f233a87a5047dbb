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

/// Writes map.pgm, map.yaml, probability.pgm, probability.yaml, map.png and report.json, of maps
/// that octomapReaches map.bt and map.ot, and of tomography wall_loss.pgm and wall_loss.yaml, into
/// a directory that is made if missing. No old file is replaced before all new ones are written
/// whole; then those are removed that this map has none of.
/// @throw std::system_error or std::invalid_argument naming the file and why.
SFW_EXPORT void writeMapFiles(const Snapshot& snapshot, const Config& config,
                              const std::string& directory, const DataFindings& findings = {});

/// Writes readings.csv, contacts.csv and access_points.yaml: what `sfw map` needs to make the map
/// again.
/// @throw as writeMapFiles
SFW_EXPORT void writeRecording(const std::vector<Reading>& readings,
                               const std::vector<Contact>& contacts, const Snapshot& snapshot,
                               const std::string& directory);

}  // namespace sfw
