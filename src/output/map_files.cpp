#include "structure_from_wifi/map_files.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "files/atomic_file.h"
#include "files/map_server.h"
#include "files/pgm.h"
#include "files/png.h"
#include "output/map_picture.h"
#include "output/report.h"
#include "output/wall_files.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/octomap_export.h"
#include "structure_from_wifi/planning_costs.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

/// Removes files of an earlier map that this map lacks.
void removeOthers(const std::vector<std::pair<std::string, std::string>>& files,
                  const std::string& directory) {
  for (const char* name :
       {"map.bt", "map.ot", "wall_loss.pgm", "wall_loss.yaml", "wall_loss.png"}) {
    const std::string path = directory + "/" + name;
    if (std::none_of(files.begin(), files.end(),
                     [&](const auto& file) { return file.first == path; })) {
      std::error_code not_there;
      std::filesystem::remove(path, not_there);
    }
  }
}

/// The grey values of probabilities: 0 is certainly occupied, 255 certainly free.
std::vector<std::uint8_t> greysOf(const BeliefMap& belief) {
  return belief.converted([](const CellBelief& cell) {
    return static_cast<std::uint8_t>(
        std::lround(255.0 * (1.0 - static_cast<double>(cell.occupied))));
  });
}

/// Costs as grey values, which map_server in mode scale turns into the same costs within 2.
std::string costsPng(const Grid<std::int8_t>& costs) {
  return encodeTransparentPng(costs.geometry, [&](Cell c) -> std::optional<std::uint8_t> {
    if (costs[c] == kUnknownCost) {
      return std::nullopt;
    }
    return static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - costs[c] / 100.0)));
  });
}

}  // namespace

std::string trinaryPgm(const BeliefMap& belief) {
  return encodePgm(belief.geometry(), [&](Cell c) { return pixelOf(belief.state(c)); });
}

std::string probabilityPgm(const BeliefMap& belief) {
  const GridGeometry& geometry = belief.geometry();
  const std::vector<std::uint8_t> greys = greysOf(belief);
  return encodePgm(geometry, [&](Cell c) { return greys[geometry.index(c)]; });
}

std::string probabilityPng(const BeliefMap& belief) {
  const GridGeometry& geometry = belief.geometry();
  const std::vector<std::uint8_t> greys = greysOf(belief);
  return encodeTransparentPng(geometry, [&](Cell c) {
    return belief.known(c) ? std::optional(greys[geometry.index(c)]) : std::nullopt;
  });
}

void writeMapFiles(const Snapshot& snapshot, const Config& config, const std::string& directory,
                   const DataFindings& findings) {
  // All files are encoded before the first is written, so an error leaves no new file.
  const BeliefMap& belief = snapshot.belief;
  const FloorDrawing drawing = floorDrawing(snapshot);
  std::vector<std::pair<std::string, std::string>> files{
      {directory + "/map.pgm", trinaryPgm(belief)},
      {directory + "/map.yaml", trinaryYaml(belief.geometry())},
      {directory + "/probability.pgm", probabilityPgm(snapshot.probability)},
      {directory + "/probability.png", probabilityPng(snapshot.probability)},
      {directory + "/probability.yaml", probabilityYaml(belief.geometry())},
      {directory + "/costs.png", costsPng(planningCosts(snapshot, config.path.footprint_radius_m))},
      {directory + "/costs.yaml", costsYaml(belief.geometry())},
      {directory + "/map.png", renderPicture(snapshot)},
      {directory + "/walls.yaml", wallsYaml(snapshot.walls)},
      {directory + "/walls.svg", wallsSvg(drawing)},
      {directory + "/walls.dxf", wallsDxf(drawing)},
      {directory + "/report.json", reportJson(snapshot, config, findings)}};
  if (octomapReaches(belief.geometry())) {
    const auto tree = toOctomap(belief, config.octomap);
    files.emplace_back(directory + "/map.bt", encodeBinaryFile(*tree));
    files.emplace_back(directory + "/map.ot", encodeFullFile(*tree));
  }
  if (snapshot.tomography) {
    const Grid<float>& wall_loss = snapshot.tomography->wall_loss;
    files.emplace_back(directory + "/wall_loss.pgm", wallLossPgm(wall_loss));
    files.emplace_back(directory + "/wall_loss.yaml", wallLossYaml(wall_loss.geometry));
    files.emplace_back(directory + "/wall_loss.png", renderWallLoss(wall_loss, snapshot));
  }
  makeDirectories(directory);
  writeAtomically(files);
  removeOthers(files, directory);
}

void writeRecording(const std::vector<Reading>& readings, const std::vector<Contact>& contacts,
                    const Snapshot& snapshot, const std::string& directory,
                    const std::vector<PathPose>& path) {
  std::vector<AccessPoint> access_points;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    access_points.push_back(summary.access_point);
  }
  writeRecording(readings, contacts, access_points, directory, path);
}

void writeRecording(const std::vector<Reading>& readings, const std::vector<Contact>& contacts,
                    const std::vector<AccessPoint>& access_points, const std::string& directory,
                    const std::vector<PathPose>& path) {
  makeDirectories(directory);
  writeAtomically({{directory + "/readings.csv", readingsCsv(readings)},
                   {directory + "/contacts.csv", contactsCsv(contacts)},
                   {directory + "/path.csv", pathCsv(path)},
                   {directory + "/access_points.yaml", accessPointsYaml(access_points)}});
}

}  // namespace sfw
