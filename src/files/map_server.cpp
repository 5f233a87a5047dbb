#include "files/map_server.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "files/atomic_file.h"
#include "files/pgm.h"
#include "files/png.h"
#include "files/text.h"
#include "grid/for_each_cell.h"
#include "grid/robot_evidence.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The content of the YAML and the image of a map.
struct MapFile {
  GridGeometry geometry;
  TranslucentImage image;
  bool negate;
  double occupied_threshold;
  double free_threshold;
  double decibels_per_step;  // 0 if the file has none

  std::size_t pixel(Cell c) const {
    return static_cast<std::size_t>((image.grey.height - 1 - c.y) * image.grey.width + c.x);
  }

  bool known(Cell c) const { return image.opacity.empty() || image.opacity[pixel(c)] != 0; }

  double occupied(Cell c) const {
    const double white = image.grey.pixels[pixel(c)] / 255.0;
    return negate ? white : 1.0 - white;
  }
};

TranslucentImage readImage(const std::filesystem::path& file) {
  return file.extension() == ".png" ? readPng(file.string())
                                    : TranslucentImage{readPgm(file.string()), {}};
}

/// @return the value of the key; `absent` only if the key is missing
double numberOr(const YAML::Node& yaml, const char* key, double absent) {
  return yaml[key] ? yaml[key].as<double>() : absent;
}

void requireUnderstood(const std::string& yaml_file, const MapFile& map, const std::string& mode) {
  if (mode != "trinary" && mode != "scale") {
    throw InputError(yaml_file + ": 'mode' must be trinary or scale; it is '" + mode + "'");
  }
  if (!(map.free_threshold >= 0.0 && map.free_threshold <= map.occupied_threshold &&
        map.occupied_threshold <= 1.0)) {
    throw InputError(yaml_file + ": 0 <= free_thresh <= occupied_thresh <= 1 must hold");
  }
}

MapFile parseMapFile(const std::string& yaml_file) {
  const YAML::Node yaml = YAML::Load(readFile(yaml_file));
  const auto origin = yaml["origin"].as<std::vector<double>>();
  if (origin.size() < 2 || (origin.size() > 2 && origin[2] != 0.0)) {
    throw InputError(yaml_file + ": 'origin' must be [x, y, 0]: rotated maps are not supported");
  }
  const std::filesystem::path folder = std::filesystem::path(yaml_file).parent_path();
  TranslucentImage image = readImage(folder / yaml["image"].as<std::string>());
  const GridGeometry geometry(yaml["resolution"].as<double>(), {origin[0], origin[1]},
                              image.grey.width, image.grey.height);
  MapFile map{geometry,
              std::move(image),
              numberOr(yaml, "negate", 0.0) != 0.0,
              numberOr(yaml, "occupied_thresh", 0.65),
              numberOr(yaml, "free_thresh", 0.196),
              numberOr(yaml, "decibels_per_step", 0.0)};
  requireUnderstood(yaml_file, map, yaml["mode"] ? yaml["mode"].as<std::string>() : "trinary");
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

template <class T, class Convert>
Grid<T> converted(const std::string& yaml_file, Convert&& convert) {
  const MapFile file = readMapFile(yaml_file);
  Grid<T> grid(file.geometry);
  forEachCell(file.geometry, [&](Cell c) { grid[c] = convert(file, c); });
  return grid;
}

std::string mapYaml(const char* image, const GridGeometry& geometry, const char* mode,
                    const char* thresholds, int negate = 0) {
  return formatted("image: %s\nresolution: %.9g\norigin: [%.9g, %.9g, 0]\nnegate: %d\nmode: %s\n%s",
                   image, geometry.resolution(), geometry.origin().x(), geometry.origin().y(),
                   negate, mode, thresholds);
}

}  // namespace

Grid<CellState> readMap(const std::string& yaml_file) {
  return converted<CellState>(yaml_file, [](const MapFile& file, Cell c) {
    if (!file.known(c)) {
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
  return converted<float>(yaml_file, [](const MapFile& file, Cell c) {
    return file.known(c) ? static_cast<float>(file.occupied(c)) : kUnknownOccupancy;
  });
}

Grid<float> readWallLoss(const std::string& yaml_file) {
  return converted<float>(yaml_file, [&](const MapFile& file, Cell c) {
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
