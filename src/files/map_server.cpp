#include "files/map_server.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include "files/atomic_file.h"
#include "files/image.h"
#include "files/pgm.h"
#include "files/text.h"
#include "files/yaml.h"
#include "grid/for_each_cell.h"
#include "grid/robot_evidence.h"
#include "grid/turned.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

enum class Mode { kTrinary, kScale, kRaw };

/// The content of the YAML and the image of a map.
struct MapFile {
  GridGeometry geometry;
  double yaw_rad;  // about the origin, snapped to quarter turns
  TranslucentImage image;
  Mode mode;
  bool negate;
  double occupied_threshold;
  double free_threshold;
  double decibels_per_step;    // 0 if the file has none
  bool is_saver_grey_unknown;  // a pixel of kSaverUnknown is unknown, whatever the thresholds say

  std::size_t pixel(Cell c) const {
    return static_cast<std::size_t>((image.grey.height - 1 - c.y) * image.grey.width + c.x);
  }

  int value(Cell c) const {
    const int grey = image.grey.pixels[pixel(c)];
    return negate ? kWhite - grey : grey;
  }

  bool known(Cell c) const {
    return (image.opacity.empty() || image.opacity[pixel(c)] != 0) &&
           (mode != Mode::kRaw || value(c) <= kCertain);
  }

  double occupied(Cell c) const {
    return mode == Mode::kRaw ? static_cast<double>(value(c)) / kCertain
                              : 1.0 - static_cast<double>(value(c)) / kWhite;
  }

  static constexpr int kWhite = 255;
  static constexpr int kCertain = 100;  // the largest value of mode raw that is not unknown
};

constexpr int kSaverUnknown = 205;  // the grey that every map_saver writes for unknown

/// Whether a free_thresh makes unknown cells free. Nav2 and slam_toolbox write 0.25 beside maps in
/// which 205, of 0.196, is unknown.
bool isSaverGreyUnknown(const MapFile& map) {
  const std::vector<std::uint8_t>& pixels = map.image.grey.pixels;
  return map.mode == Mode::kTrinary && !map.negate &&
         std::any_of(pixels.begin(), pixels.end(),
                     [](std::uint8_t grey) { return grey > kSaverUnknown; });
}

/// @return the value of the key; `absent` only if the key is missing
double numberOr(const YAML::Node& yaml, const char* key, double absent) {
  return yaml[key] ? yaml[key].as<double>() : absent;
}

/// Reads 0, 1, false or true.
bool flagOf(const YAML::Node& yaml, const char* key) {
  bool flag = false;
  return yaml[key] && (readScalar(yaml[key], flag) ? flag : yaml[key].as<double>() != 0.0);
}

Mode modeOf(const YAML::Node& yaml, const std::string& yaml_file) {
  std::string name = yaml["mode"] ? yaml["mode"].as<std::string>() : "trinary";
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [known, mode] :
       {std::pair("trinary", Mode::kTrinary), {"scale", Mode::kScale}, {"raw", Mode::kRaw}}) {
    if (name == known) {
      return mode;
    }
  }
  throw InputError(yaml_file + ": 'mode' must be trinary, scale or raw; it is '" + name + "'");
}

void requireUnderstood(const std::string& yaml_file, const MapFile& map) {
  if (!(map.free_threshold >= 0.0 && map.free_threshold <= map.occupied_threshold &&
        map.occupied_threshold <= 1.0)) {
    throw InputError(yaml_file + ": 0 <= free_thresh <= occupied_thresh <= 1 must hold");
  }
}

/// Reads [x, y, yaw].
std::vector<double> originOf(const YAML::Node& yaml, const std::string& yaml_file) {
  std::vector<double> origin;
  for (const YAML::Node& part : yaml["origin"]) {
    double number = 0.0;
    if (!readScalar(part, number)) {
      origin.clear();
      break;
    }
    origin.push_back(number);
  }
  if (origin.size() < 2) {
    throw InputError(yaml_file + ": 'origin' must be [x, y, yaw], in metres and radians");
  }
  origin.resize(std::max<std::size_t>(origin.size(), 3), 0.0);
  if (!std::isfinite(origin[2])) {
    throw InputError(yaml_file +
                     ": the yaw in 'origin' is no number, as map_saver writes it for an invalid "
                     "orientation; write 0 in its place");
  }
  return origin;
}

MapFile parseMapFile(const std::string& yaml_file) {
  const YAML::Node yaml = YAML::Load(readFile(yaml_file));
  const std::vector<double> origin = originOf(yaml, yaml_file);
  const std::filesystem::path folder = std::filesystem::path(yaml_file).parent_path();
  TranslucentImage image = readImage((folder / yaml["image"].as<std::string>()).string());
  const GridGeometry geometry(yaml["resolution"].as<double>(), {origin[0], origin[1]},
                              image.grey.width, image.grey.height);
  MapFile map{geometry,
              snappedYaw(origin[2], geometry),
              std::move(image),
              modeOf(yaml, yaml_file),
              flagOf(yaml, "negate"),
              numberOr(yaml, "occupied_thresh", 0.65),
              numberOr(yaml, "free_thresh", 0.196),
              numberOr(yaml, "decibels_per_step", 0.0),
              false};
  map.is_saver_grey_unknown = isSaverGreyUnknown(map);
  requireUnderstood(yaml_file, map);
  return map;
}

MapFile readMapFile(const std::string& yaml_file) {
  try {
    return parseMapFile(yaml_file);
  } catch (const YAML::Exception& error) {
    throw InputError(yaml_file + ": " + error.what() +
                     " (a map needs image, resolution and origin)");
  } catch (const std::invalid_argument& error) {
    throw InputError(yaml_file + ": " + error.what());
  }
}

/// @param outside  of cells beside a turned map
template <class T, class Convert>
Grid<T> converted(const std::string& yaml_file, const T& outside, Convert&& convert) {
  const MapFile file = readMapFile(yaml_file);
  Grid<T> grid(file.geometry);
  forEachCell(file.geometry, [&](Cell c) { grid[c] = convert(file, c); });
  if (file.yaw_rad == 0.0) {
    return grid;
  }
  try {
    return turned(grid, file.yaw_rad, outside);
  } catch (const std::invalid_argument& error) {
    throw InputError(yaml_file + ": turned by the yaw of its origin, " + error.what());
  }
}

std::string mapYaml(const char* image, const GridGeometry& geometry, const char* mode,
                    const char* thresholds, int negate = 0) {
  return formatted(
      "image: %s\nresolution: %.9g\norigin: [%.12g, %.12g, 0]\nnegate: %d\nmode: %s\n%s", image,
      geometry.resolution(), geometry.origin().x(), geometry.origin().y(), negate, mode,
      thresholds);
}

}  // namespace

Grid<CellState> readMap(const std::string& yaml_file) {
  return converted(yaml_file, CellState::kUnknown, [](const MapFile& file, Cell c) {
    if (!file.known(c) || (file.is_saver_grey_unknown && file.value(c) == kSaverUnknown)) {
      return CellState::kUnknown;
    }
    const double occupied = file.occupied(c);
    if (occupied > file.occupied_threshold) {
      return CellState::kOccupied;
    }
    return occupied < file.free_threshold ? CellState::kFree : CellState::kUnknown;
  });
}

Grid<float> readProbabilities(const std::string& yaml_file) {
  return converted(yaml_file, kUnknownOccupancy, [](const MapFile& file, Cell c) {
    return file.known(c) ? static_cast<float>(file.occupied(c)) : kUnknownOccupancy;
  });
}

Grid<float> readWallLoss(const std::string& yaml_file) {
  return converted(yaml_file, 0.0F, [&](const MapFile& file, Cell c) {
    if (!(file.decibels_per_step > 0.0 && std::isfinite(file.decibels_per_step))) {
      throw InputError(yaml_file + ": 'decibels_per_step' must be a positive number");
    }
    constexpr double kSteps = 255.0;
    return static_cast<float>(kSteps * file.occupied(c) * file.decibels_per_step);
  });
}

int pixelOf(CellState state) {
  switch (state) {
    case CellState::kFree:
      return 254;
    case CellState::kOccupied:
      return 0;
    case CellState::kUnknown:
      break;
  }
  return 205;
}

std::string trinaryYaml(const GridGeometry& geometry, const std::string& image) {
  return mapYaml(image.c_str(), geometry, "trinary", "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

std::string probabilityYaml(const GridGeometry& geometry) {
  return mapYaml("probability.png", geometry, "scale", "occupied_thresh: 1.0\nfree_thresh: 0.0\n");
}

std::string costsYaml(const GridGeometry& geometry) {
  return mapYaml("costs.png", geometry, "scale", "occupied_thresh: 0.998\nfree_thresh: 0.002\n");
}

std::string wallLossPgm(const Grid<float>& wall_loss) {
  return encodePgm(wall_loss.geometry, [&](Cell c) {
    const double steps = static_cast<double>(wall_loss[c]) / kWallLossStepDb;
    return std::lround(std::clamp(steps, 0.0, 255.0));
  });
}

std::string wallLossYaml(const GridGeometry& geometry) {
  return mapYaml("wall_loss.pgm", geometry, "scale", "occupied_thresh: 1.0\nfree_thresh: 0.0\n",
                 1) +
         formatted("decibels_per_step: %.9g\n", kWallLossStepDb);
}

void writeMap(const Grid<CellState>& states, const std::string& directory,
              const std::string& name) {
  makeDirectories(directory);
  writeAtomically(directory + "/" + name + ".pgm",
                  encodePgm(states.geometry, [&](Cell c) { return pixelOf(states[c]); }));
  writeAtomically(directory + "/" + name + ".yaml", trinaryYaml(states.geometry, name + ".pgm"));
}

}  // namespace sfw
