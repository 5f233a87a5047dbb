#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The image of a map as map_server reads it: 254 free, 0 occupied, 205 unknown.
SFW_EXPORT std::string trinaryPgm(const BeliefMap& belief);
/// The image of the probabilities p of being occupied: 255 (1 - p), 128 where nothing is known.
SFW_EXPORT std::string probabilityPgm(const BeliefMap& belief);
/// The same as PNG, transparent where nothing is known, which map_server reads as unknown.
SFW_EXPORT std::string probabilityPng(const BeliefMap& belief);

/// Writes the files of a map into a directory. Makes the directory if it is missing.
///
/// Every map has map.pgm, map.yaml, probability.pgm, probability.png, probability.yaml, costs.png,
/// costs.yaml, map.png, report.json, and its walls as walls.yaml, walls.svg and walls.dxf. Maps
/// that octomapReaches have map.bt and map.ot. Maps of tomography have wall_loss.pgm,
/// wall_loss.yaml and wall_loss.png. Old files stay until all new ones are complete; then files
/// that this map lacks are removed.
/// @throw std::system_error or std::invalid_argument naming the file and why.
SFW_EXPORT void writeMapFiles(const Snapshot& snapshot, const Config& config,
                              const std::string& directory, const DataFindings& findings = {});

/// Writes readings.csv, contacts.csv, path.csv and access_points.yaml. `sfw map` makes the same map
/// from them.
/// @param path  the poses between readings
/// @throw as writeMapFiles
/// @{
SFW_EXPORT void writeRecording(const std::vector<Reading>& readings,
                               const std::vector<Contact>& contacts,
                               const std::vector<AccessPoint>& access_points,
                               const std::string& directory,
                               const std::vector<PathPose>& path = {});
SFW_EXPORT void writeRecording(const std::vector<Reading>& readings,
                               const std::vector<Contact>& contacts, const Snapshot& snapshot,
                               const std::string& directory,
                               const std::vector<PathPose>& path = {});
/// @}

}  // namespace sfw
