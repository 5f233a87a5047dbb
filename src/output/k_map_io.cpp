#include "output/k_map_io.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "files/atomic_file.h"
#include "files/canvas.h"
#include "files/pgm.h"
#include "files/text.h"
#include "k_visibility/k_visibility.h"
#include "output/map_picture.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

KMap parse(const std::string& file) {
  const YAML::Node yaml = YAML::Load(readFile(file));
  const auto origin = yaml["origin"].as<std::vector<double>>();
  const auto access_point = yaml["access_point"].as<std::vector<double>>();
  if (origin.size() < 2 || access_point.size() < 2) {
    throw InputError(file + ": 'origin' and 'access_point' must be [x, y]");
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  const GreyImage image = readPgm((folder / yaml["image"].as<std::string>()).string());
  Grid<std::uint8_t> counts(GridGeometry(yaml["resolution"].as<double>(), {origin[0], origin[1]},
                                         image.width, image.height));
  for (std::int64_t y = 0; y < image.height; ++y) {
    const auto row = image.pixels.begin() + (image.height - 1 - y) * image.width;
    std::copy(row, row + image.width, counts.cells.begin() + y * image.width);
  }
  return {std::move(counts), {access_point[0], access_point[1]}};
}

std::string encodeYaml(const KMap& k_map) {
  const GridGeometry& geometry = k_map.counts.geometry;
  YAML::Emitter yaml;
  yaml.SetDoublePrecision(std::numeric_limits<double>::digits10);
  yaml << YAML::BeginMap << YAML::Key << "image" << YAML::Value << "k.pgm";
  yaml << YAML::Key << "resolution" << YAML::Value << geometry.resolution();
  yaml << YAML::Key << "origin" << YAML::Value << YAML::Flow << YAML::BeginSeq
       << geometry.origin().x() << geometry.origin().y() << 0 << YAML::EndSeq;
  yaml << YAML::Key << "access_point" << YAML::Value << YAML::Flow << YAML::BeginSeq
       << k_map.access_point.x() << k_map.access_point.y() << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

std::string renderPicture(const KMap& k_map) {
  const Grid<std::uint8_t>& counts = k_map.counts;
  Box area = counts.geometry.box();
  area.extend(k_map.access_point);
  Canvas canvas(area);
  canvas.fillCells(counts.geometry, Canvas::kOccupied,
                   [&](Cell c) { return counts[c] == kWallCell; });
  std::vector<LegendEntry> legend;
  for (int walls = 0; walls <= kMostWalls; ++walls) {
    if (std::find(counts.cells.begin(), counts.cells.end(), walls) != counts.cells.end()) {
      const Colour colour = wallCountColour(walls);
      canvas.fillCells(counts.geometry, colour, [&](Cell c) { return counts[c] == walls; });
      legend.push_back({colour, std::to_string(walls)});
    }
  }
  canvas.drawAccessPoint(k_map.access_point, "access point");
  canvas.drawFooter("k, walls to the access point:", legend);
  return canvas.png();
}

}  // namespace

KMap readKMap(const std::string& file) {
  const std::string yaml_file = std::filesystem::path(file).replace_extension(".yaml").string();
  try {
    return parse(yaml_file);
  } catch (const YAML::Exception& error) {
    throw InputError(yaml_file + ": " + error.what() +
                     " (a k map needs image, resolution, origin and access_point)");
  } catch (const std::invalid_argument& error) {
    throw InputError(yaml_file + ": " + error.what());
  }
}

void writeKMap(const KMap& k_map, const std::string& directory) {
  const std::string picture = renderPicture(k_map);
  makeDirectories(directory);
  writeAtomically(directory + "/k.pgm",
                  encodePgm(k_map.counts.geometry, [&](Cell c) { return k_map.counts[c]; }));
  writeAtomically(directory + "/k.yaml", encodeYaml(k_map));
  writeAtomically(directory + "/k.png", picture);
}

}  // namespace sfw
