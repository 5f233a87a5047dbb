#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// What ~save_map and the autosave keep of a session.
struct Session {
  std::vector<Reading> readings;
  std::vector<Contact> contacts;
  std::vector<PathPose> path;  ///< poses between readings
  std::vector<AccessPoint> access_points;
};

/// Reads readings.csv, contacts.csv, access_points.yaml and, if there is one, path.csv of a
/// directory.
/// @param config  its limit of readings also limits the size of files
/// @throw InputError naming the file and why: it is missing, too large, cut short, or has a row
/// that cannot be used.
Session readSession(const std::string& directory, const Config::Map& config);

/// Writes a session, each file whole or not at all.
/// @throw std::system_error naming the file and why
void writeSession(const Session& session, const std::string& directory);

/// Whether a directory holds a recording with readings.
bool holdsReadings(const std::string& directory);

/// Whether a name stays in its parent directory: it has only letters, digits, '.', '_' and '-'.
bool isPlainName(const std::string& name);

/// The first of DIRECTORY, DIRECTORY_2, DIRECTORY_3 and so on without a recording.
std::string withoutRecording(const std::string& directory);

/// Replaces a leading ~/ by the home directory.
std::string withHome(const std::string& directory);

}  // namespace sfw
