#include "cli/floor_plan_files.h"

#include <algorithm>
#include <filesystem>

namespace sfw {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> floorPlansIn(const std::string& directory) {
  std::vector<std::string> inside;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == ".json" || entry.path().extension() == ".yaml") {
      inside.push_back(entry.path().string());
    }
  }
  std::sort(inside.begin(), inside.end());
  return inside;
}

}  // namespace

std::vector<std::string> floorPlanFiles(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    if (fs::is_directory(name)) {
      const std::vector<std::string> inside = floorPlansIn(name);
      files.insert(files.end(), inside.begin(), inside.end());
    } else {
      files.push_back(name);
    }
  }
  return files;
}

}  // namespace sfw
