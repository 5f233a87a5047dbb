#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Rows of a file that were skipped for one reason.
struct SkippedRows {
  std::size_t count = 0;  ///< number of rows
  std::string first;      ///< line and content of the first one: "line 7: rssi_dbm 'abc'"
};

/// The readings of a file, and the rows that were skipped.
struct ReadingFile {
  std::vector<Reading> readings;               ///< in the order of the file
  std::map<std::string, SkippedRows> skipped;  ///< by reason
};

/// Reads a CSV by RFC 4180 with the columns stamp, x, y, bssid, rssi_dbm in any order (seconds or
/// a date and time, metres, dBm; map frame). With several robots, a column `robot` names that of
/// each row. Other columns are ignored. Columns may be separated by
/// semicolons or tabs too, and then have decimal commas. The CSV of WiGLE, and that of Kismet's
/// packets, have no positions: they need a path.
/// @param path  CSV with the columns stamp, x, y. Readings without positions are placed between its
/// rows, but not in gaps of over 5 s. Empty: the positions are in the file itself.
/// @throw InputError naming the file if it cannot be read, lacks a column or has no usable row, or
/// if an unusable pose is in the path.
SFW_EXPORT ReadingFile readReadings(const std::string& file, const std::string& path = "");

/// Reads a CSV of contacts of the robot with obstacles, with the columns stamp, x, y and, with
/// several robots, robot.
/// @throw InputError as readReadings, naming the line of the first unusable row.
SFW_EXPORT std::vector<Contact> readContacts(const std::string& file);

/// Reads a CSV of poses of the path between readings, with the columns of readContacts.
/// @throw InputError as readContacts.
SFW_EXPORT std::vector<PathPose> readPath(const std::string& file);

/// Reads a CSV of way points with the columns x, y (metres, map frame), in driving order.
/// @throw InputError as readContacts.
SFW_EXPORT std::vector<Position> readWayPoints(const std::string& file);

/// Formats a CSV, with a column `robot` only if a reading has one. readReadings reads the text back
/// to the same readings.
SFW_EXPORT std::string readingsCsv(const std::vector<Reading>& readings);

/// Formats a CSV likewise. readContacts reads the text back to the same contacts.
SFW_EXPORT std::string contactsCsv(const std::vector<Contact>& contacts);

/// Formats a CSV likewise. readPath reads the text back to the same poses.
SFW_EXPORT std::string pathCsv(const std::vector<PathPose>& path);

}  // namespace sfw
