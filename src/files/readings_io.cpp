#include "structure_from_wifi/readings_io.h"

#include <cstdlib>
#include <optional>

#include "files/csv_fields.h"
#include "files/pose_track.h"
#include "files/scan_table.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Reads a table of the columns stamp, x, y, robot.
/// @throw InputError naming the line of the first unusable row.
template <class Visitor>
void forEachPlace(const std::string& file, const Visitor& visit) {
  CsvTable table(file, placeColumns());
  while (table.next()) {
    std::int64_t stamp_ns = 0;
    Position position = Position::Zero();
    if (const auto fault = readPlace(table, stamp_ns, position)) {
      throw unusable(table, *fault);
    }
    visit(stamp_ns, position, robotOf(table));
  }
}

/// "stamp,x,y", to the nanosecond and to Mapper's 0.1 mm.
std::string placeCsv(std::int64_t stamp_ns, const Position& position) {
  constexpr std::int64_t kSecond = 1000000000;
  return formatted("%s%lld.%09lld,%.4f,%.4f", stamp_ns < 0 ? "-" : "",
                   std::llabs(stamp_ns / kSecond), std::llabs(stamp_ns % kSecond), position.x(),
                   position.y());
}

/// The rows of a table. If there are several robots, each row ends with its own.
/// @param header  without the column `robot`
/// @param rowOf   of an item, without its robot
template <class Item, class RowOf>
std::string csvOf(const std::string& header, const std::vector<Item>& items, const RowOf& rowOf) {
  const bool has_robots =
      std::any_of(items.begin(), items.end(), [](const Item& item) { return !item.robot.empty(); });
  std::string text = header + (has_robots ? ",robot\n" : "\n");
  for (const Item& item : items) {
    text += rowOf(item) + (has_robots ? "," + csvField(item.robot) : "") + "\n";
  }
  return text;
}

}  // namespace

ReadingFile readReadings(const std::string& file, const std::string& path) {
  ScanTable table(file, path.empty());
  std::optional<PoseTrack> track;
  if (!table.hasPositions()) {
    track.emplace(path);
  }
  ReadingFile result;
  result.readings.reserve(table.mostRows());
  while (table.next()) {
    Reading reading;
    std::optional<RowFault> fault = table.read(reading);
    if (!fault && track) {
      fault = track->locate(reading);
    }
    if (fault) {
      SkippedRows& skipped = result.skipped[fault->reason];
      if (skipped.count++ == 0) {
        skipped.first = table.line() + ": " + fault->detail;
      }
      continue;
    }
    result.readings.push_back(std::move(reading));
  }
  if (track && result.readings.empty()) {
    track->requireMeeting(file);
  }
  if (result.readings.empty()) {
    std::string why = result.skipped.empty() ? "it has no rows" : "";
    for (const auto& [reason, skipped] : result.skipped) {
      why += (why.empty() ? "" : "; ") + reason + " (" + skipped.first + ")";
    }
    throw InputError(file + ": no row can be used: " + why);
  }
  return result;
}

std::vector<Contact> readContacts(const std::string& file) {
  std::vector<Contact> contacts;
  forEachPlace(file, [&](std::int64_t stamp_ns, const Position& position, std::string robot) {
    contacts.push_back({stamp_ns, position, std::move(robot)});
  });
  return contacts;
}

std::vector<PathPose> readPath(const std::string& file) {
  std::vector<PathPose> path;
  forEachPlace(file, [&](std::int64_t stamp_ns, const Position& position, std::string robot) {
    path.push_back({stamp_ns, position, PathPose::kNoWallCount, std::move(robot)});
  });
  return path;
}

std::vector<Position> readWayPoints(const std::string& file) {
  CsvTable table(file, {{"x"}, {"y"}});
  std::vector<Position> way_points;
  while (table.next()) {
    Position way_point = Position::Zero();
    std::optional<RowFault> fault = faultOfRow(table);
    if (!fault) {
      fault = readPosition(table, 0, way_point);
    }
    if (fault) {
      throw unusable(table, *fault);
    }
    way_points.push_back(way_point);
  }
  return way_points;
}

std::string readingsCsv(const std::vector<Reading>& readings) {
  return csvOf("stamp,x,y,bssid,rssi_dbm", readings, [](const Reading& reading) {
    return placeCsv(reading.stamp_ns, reading.antenna_in_map) +
           formatted(",%s,%.2f", reading.bssid.str().c_str(), reading.rssi_dbm);
  });
}

std::string contactsCsv(const std::vector<Contact>& contacts) {
  return csvOf("stamp,x,y", contacts, [](const Contact& contact) {
    return placeCsv(contact.stamp_ns, contact.point_in_map);
  });
}

std::string pathCsv(const std::vector<PathPose>& path) {
  return csvOf("stamp,x,y", path,
               [](const PathPose& pose) { return placeCsv(pose.stamp_ns, pose.antenna_in_map); });
}

}  // namespace sfw
