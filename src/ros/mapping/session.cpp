#include "ros/mapping/session.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

/// Refuses what a reader would hang on, run out of memory with, or misread: other things than
/// files, huge files, and files whose last line was cut.
void requireWholeFile(const std::string& file, std::uintmax_t largest) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError(file + ": there is no such file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > largest) {
    throw InputError(file + ": the file is too large");
  }
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(-1, std::ios::end);
  char last = 0;
  if (!stream.get(last) || last != '\n') {
    throw InputError(file + ": the file is cut short");
  }
}

}  // namespace

Session readSession(const std::string& directory, const Config::Map& config) {
  constexpr std::uintmax_t kLongestRow = 200;           // [bytes]
  constexpr std::uintmax_t kLargestTable = 10'000'000;  // [bytes]
  const auto most_rows = static_cast<std::uintmax_t>(config.max_readings) + 1;
  const std::string readings_file = directory + "/readings.csv";
  const std::string contacts_file = directory + "/contacts.csv";
  const std::string table_file = directory + "/access_points.yaml";
  requireWholeFile(readings_file, most_rows * kLongestRow);
  requireWholeFile(contacts_file, most_rows * kLongestRow);
  requireWholeFile(table_file, kLargestTable);
  const std::string path_file = directory + "/path.csv";
  std::vector<PathPose> path;
  if (std::filesystem::exists(path_file)) {  // sessions of old versions have none
    requireWholeFile(path_file, most_rows * kLongestRow);
    path = readPath(path_file);
  }
  ReadingFile readings = readReadings(readings_file);
  if (!readings.skipped.empty()) {
    const auto& [reason, rows] = *readings.skipped.begin();
    throw InputError(readings_file + ": " + reason + " (" + rows.first + ")");
  }
  return {std::move(readings.readings), readContacts(contacts_file), std::move(path),
          readAccessPoints(table_file).access_points};
}

void writeSession(const Session& session, const std::string& directory) {
  writeRecording(session.readings, session.contacts, session.access_points, directory,
                 session.path);
}

bool holdsReadings(const std::string& directory) {
  std::ifstream file(directory + "/readings.csv");
  std::string line;
  return std::getline(file, line) && std::getline(file, line);
}

bool isPlainName(const std::string& name) {
  constexpr char kAllowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  constexpr std::size_t kLongest = 200;
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         name.find_first_not_of(kAllowed) == std::string::npos;
}

std::string withoutRecording(const std::string& directory) {
  std::string numbered = directory;
  for (int i = 2; holdsReadings(numbered); ++i) {
    numbered = directory + "_" + std::to_string(i);
  }
  return numbered;
}

std::string withHome(const std::string& directory) {
  const char* home = std::getenv("HOME");
  const bool starts_at_home = directory.compare(0, 2, "~/") == 0;
  return starts_at_home && home != nullptr ? home + directory.substr(1) : directory;
}

}  // namespace sfw
