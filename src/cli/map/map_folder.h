#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/map/map_list.h"

namespace sfw {

/// The file of a map's directory that says what the map was made from, with a checksum of each
/// other file. It is the last one written.
constexpr char kRowFile[] = "row.json";

/// Options of a recording as JSON, file names as given.
nlohmann::json optionsJson(const RecordingOptions& recording);

/// What a map depends on: version and program, options, and the hash of each file in place of its
/// name.
struct MapOrigin {
  nlohmann::json made_from;
  nlohmann::json inputs = nlohmann::json::object();  ///< hashes by file name
};

/// Reads every input of a row. @throw InputError naming a file that cannot be read.
MapOrigin originOf(const MapRow& row, const nlohmann::json& work);

/// Whether a directory holds a whole map: every file that its row file names, with that content,
/// and no other.
bool isWhole(const std::string& directory);

/// Whether a directory holds the whole map of an origin.
bool isWhole(const std::string& directory, const MapOrigin& origin);

/// Makes the map of a row in a directory of another name, and renames it when it is whole. A map
/// of another origin and a damaged one are replaced.
/// @param directory  of all maps
/// @throw as makeMap, and InputError if something else is in the way; nothing is left behind then
void makeRow(const MapRow& row, const MapOrigin& origin, const std::string& directory);

/// Removes what killed workers left of the maps of a list. Call it only while no worker is at work.
void removeUnfinished(const std::vector<MapRow>& rows, const std::string& directory);

}  // namespace sfw
