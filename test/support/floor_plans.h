#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace sfw::test {

constexpr const char* kNoFloorPlans =
    "no floor plans: set SFW_SHARED to a folder with data/floorplans";

/// Files of the floor plans that are not part of the repository, in order of their names: in
/// $SFW_SHARED, or beside the repository. Empty if there are none.
inline std::vector<std::string> floorPlans() {
  const char* given = std::getenv("SFW_SHARED");
  const std::filesystem::path shared =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(SFW_SOURCE_DIR) / ".." / "shared";
  const std::filesystem::path folder = shared / "data" / "floorplans";
  std::vector<std::string> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::filesystem::path ending = entry.path().extension();
      if (ending == ".json" || ending == ".yaml") {
        files.push_back(entry.path().string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace sfw::test
