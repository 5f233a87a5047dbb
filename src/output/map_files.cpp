#include "structure_from_wifi/map_files.h"

#include <octomap/OcTree.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "files/atomic_file.h"
#include "files/pgm.h"
#include "files/text.h"
#include "grid/for_each_cell.h"
#include "output/map_picture.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/octomap_export.h"
#include "structure_from_wifi/version.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

/// The values that map_server reads as free, occupied and unknown.
int toPixel(CellState state) {
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

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
  const int length = std::snprintf(nullptr, 0, format, arguments...);
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), format, arguments...);
  text.pop_back();
  return text;
}

std::string mapYaml(const char* image, const GridGeometry& geometry, const char* mode,
                    const char* thresholds, int negate = 0) {
  return formatted("image: %s\nresolution: %.9g\norigin: [%.9g, %.9g, 0]\nnegate: %d\nmode: %s\n%s",
                   image, geometry.resolution(), geometry.origin().x(), geometry.origin().y(),
                   negate, mode, thresholds);
}

Json describe(const Config& config) {
  Json settings;
  forEachSetting(config, [&](const std::string& name, const auto& value) {
    const std::size_t slash = name.find('/');
    const std::string group = name.substr(0, slash);
    if (slash == std::string::npos) {
      settings[name] = value;
    } else if (group != "ros") {  // where a map came from does not change it
      settings[group][name.substr(slash + 1)] = value;
    }
  });
  return settings;
}

Json describe(const AccessPointSummary& summary, const AccessPointFit* fit) {
  const AccessPoint& access_point = summary.access_point;
  Json json{{"bssid", access_point.bssid.str()},
            {"name", asUtf8(access_point.name)},
            {"readings", summary.readings}};
  if (hasPosition(summary)) {
    json["x"] = access_point.position.x();
    json["y"] = access_point.position.y();
  } else {
    json["left_out"] = "it has no position, and its readings do not tell one";
  }
  if (summary.estimate) {
    const Eigen::Matrix2d& covariance = summary.estimate->covariance;
    json["estimated"] = {{"sd_x_m", std::sqrt(covariance(0, 0))},
                         {"sd_y_m", std::sqrt(covariance(1, 1))},
                         {"ambiguous", summary.estimate->ambiguous}};
  }
  if (fit != nullptr) {
    const Position& better = fit->estimate.position;
    json["fit"] = {{"residual_db", fit->residual_db}, {"suspect", fit->suspect}};
    if (fit->suspect) {
      json["fit"]["seems_to_stand_at"] = {better.x(), better.y()};
    }
  }
  if (summary.wall_counts) {
    json["walls"] = summary.wall_counts->walls();
    json["centroids_dbm"] = summary.wall_counts->centroids_dbm;
    json["thresholds_dbm"] = summary.wall_counts->thresholds_dbm;
  }
  return json;
}

Json describe(const TomographySummary& tomography) {
  using YawSource = TomographySummary::YawSource;
  const char* const source = tomography.yaw_source == YawSource::kHeadings ? "headings"
                             : tomography.yaw_source == YawSource::kSpread ? "spread of the path"
                                                                           : "none";
  const Json style{{"along_walls", tomography.style.along_walls},
                   {"patrol", tomography.style.patrol},
                   {"stroll", tomography.style.stroll}};
  return {{"building_yaw_rad", tomography.building_yaw_rad},
          {"building_yaw_from", source},
          {"driving_style", style},
          {"signals_explained_by_walls", tomography.explained_variance}};
}

Json describe(const Rejections& rejections) {
  Json json{{"by_reason", Json::object()}, {"unknown_access_points", Json::object()}};
  for (const auto& [insertion, count] : rejections.count) {
    json["by_reason"][toString(insertion)] = count;
  }
  for (const auto& [reason, count] : rejections.before_insertion) {
    json["by_reason"][reason] = json["by_reason"].value(reason, std::size_t{0}) + count;
  }
  for (const auto& [bssid, count] : rejections.unknown_access_points) {
    json["unknown_access_points"][bssid.str()] = count;
  }
  return json;
}

Json describe(const DriftFinding& drift) {
  return {{"ratio", drift.ratio}, {"returns", drift.returns}, {"suspect", drift.suspect}};
}

/// Area [m2] of the cells in each state.
Json describe(const BeliefMap& belief) {
  const GridGeometry& geometry = belief.geometry();
  std::size_t free = 0;
  std::size_t occupied = 0;
  forEachCell(geometry, [&](Cell c) {
    const CellState state = belief.state(c);
    free += state == CellState::kFree ? 1 : 0;
    occupied += state == CellState::kOccupied ? 1 : 0;
  });
  const double area = geometry.resolution() * geometry.resolution();
  return {{"width", geometry.width()},
          {"height", geometry.height()},
          {"resolution", geometry.resolution()},
          {"origin", {geometry.origin().x(), geometry.origin().y()}},
          {"free_m2", static_cast<double>(free) * area},
          {"occupied_m2", static_cast<double>(occupied) * area}};
}

/// "stamp,x,y", to the nanosecond and to Mapper's 0.1 mm.
std::string placeCsv(std::int64_t stamp_ns, const Position& position) {
  constexpr std::int64_t kSecond = 1000000000;
  return formatted("%s%lld.%09lld,%.4f,%.4f", stamp_ns < 0 ? "-" : "",
                   std::llabs(stamp_ns / kSecond), std::llabs(stamp_ns % kSecond), position.x(),
                   position.y());
}

/// The number with as few digits as read back the same.
std::string exactText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<double>::digits10, value);
  if (parseNumber(text) != value) {
    std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<double>::max_digits10, value);
  }
  return text;
}

/// Removes files that a map may have and this one has not: they are of an earlier one.
void removeOthers(const std::vector<std::pair<std::string, std::string>>& files,
                  const std::string& directory) {
  for (const char* name : {"map.bt", "map.ot", "wall_loss.pgm", "wall_loss.yaml"}) {
    const std::string path = directory + "/" + name;
    if (std::none_of(files.begin(), files.end(),
                     [&](const auto& file) { return file.first == path; })) {
      std::error_code not_there;
      std::filesystem::remove(path, not_there);
    }
  }
}

}  // namespace

std::string trinaryPgm(const BeliefMap& belief) {
  return encodePgm(belief.geometry(), [&](Cell c) { return toPixel(belief.state(c)); });
}

std::string probabilityPgm(const BeliefMap& belief) {
  return encodePgm(belief.geometry(), [&](Cell c) {
    return std::lround(255.0 * (1.0 - static_cast<double>(belief.occupied(c))));
  });
}

std::string trinaryYaml(const GridGeometry& geometry, const std::string& image) {
  return mapYaml(image.c_str(), geometry, "trinary", "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

std::string probabilityYaml(const GridGeometry& geometry) {
  return mapYaml("probability.pgm", geometry, "scale", "occupied_thresh: 1.0\nfree_thresh: 0.0\n");
}

std::string wallLossPgm(const Grid<float>& wall_loss) {
  return encodePgm(wall_loss.geometry, [&](Cell c) {
    const double steps = static_cast<double>(wall_loss[c]) / kWallLossStep;
    return std::lround(std::clamp(steps, 0.0, 255.0));
  });
}

std::string wallLossYaml(const GridGeometry& geometry) {
  return mapYaml("wall_loss.pgm", geometry, "scale", "occupied_thresh: 1.0\nfree_thresh: 0.0\n",
                 1) +
         formatted("decibels_per_step: %.9g\n", kWallLossStep);
}

std::string readingsCsv(const std::vector<Reading>& readings) {
  std::string text = "stamp,x,y,bssid,rssi_dbm\n";
  for (const Reading& reading : readings) {
    text += placeCsv(reading.stamp_ns, reading.antenna_in_map) +
            formatted(",%s,%.2f\n", reading.bssid.str().c_str(), reading.rssi_dbm);
  }
  return text;
}

std::string contactsCsv(const std::vector<Contact>& contacts) {
  std::string text = "stamp,x,y\n";
  for (const Contact& contact : contacts) {
    text += placeCsv(contact.stamp_ns, contact.point_in_map) + "\n";
  }
  return text;
}

std::string accessPointsYaml(const std::vector<AccessPoint>& access_points) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap << YAML::Key << "access_points" << YAML::Value << YAML::BeginSeq;
  for (const AccessPoint& access_point : access_points) {
    yaml << YAML::Flow << YAML::BeginMap;
    yaml << YAML::Key << "bssid" << YAML::Value << YAML::DoubleQuoted << access_point.bssid.str();
    yaml << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << access_point.name;
    if (access_point.position_known) {
      yaml << YAML::Key << "x" << YAML::Value << exactText(access_point.position.x());
      yaml << YAML::Key << "y" << YAML::Value << exactText(access_point.position.y());
    }
    if (access_point.height_m) {
      yaml << YAML::Key << "z" << YAML::Value << exactText(*access_point.height_m);
    }
    if (access_point.tx_dbm) {
      yaml << YAML::Key << "tx_dbm" << YAML::Value << exactText(*access_point.tx_dbm);
    }
    yaml << YAML::EndMap;
  }
  yaml << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

std::string reportJson(const Snapshot& snapshot, const Config& config,
                       const DataFindings& findings) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < snapshot.path.size(); ++i) {
    length_m += (snapshot.path[i].antenna_in_map - snapshot.path[i - 1].antenna_in_map).norm();
  }
  Json report;
  report["version"] = version();
  report["method"] = config.method;
  report["notes"] = Json::array();
  for (const MapNote& note : mapNotes(snapshot, findings)) {
    report["notes"].push_back(note.text);
  }
  report["map"] = describe(snapshot.belief);
  report["path"] = {{"poses", snapshot.path.size()},
                    {"length_m", length_m},
                    {"stray_poses", snapshot.stray.count},
                    {"jumps", snapshot.motion.jumps},
                    {"usual_speed_m_s", snapshot.motion.usual_speed_m_s}};
  if (findings.drift) {
    report["drift"] = describe(*findings.drift);
  }
  report["access_points"] = Json::array();
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    report["access_points"].push_back(describe(snapshot.access_points[i], findings.fit(i)));
  }
  if (snapshot.tomography) {
    report["tomography"] = describe(*snapshot.tomography);
  }
  report["left_out"] = describe(snapshot.rejections);
  report["settings"] = describe(config);
  return report.dump(2) + "\n";
}

void writeMapFiles(const Snapshot& snapshot, const Config& config, const std::string& directory,
                   const DataFindings& findings) {
  // Everything is made before anything is written, so what cannot be made leaves no trace.
  const BeliefMap& belief = snapshot.belief;
  std::vector<std::pair<std::string, std::string>> files{
      {directory + "/map.pgm", trinaryPgm(belief)},
      {directory + "/map.yaml", trinaryYaml(belief.geometry())},
      {directory + "/probability.pgm", probabilityPgm(belief)},
      {directory + "/probability.yaml", probabilityYaml(belief.geometry())},
      {directory + "/map.png", renderPicture(snapshot)},
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
  }
  makeDirectories(directory);
  writeAtomically(files);
  removeOthers(files, directory);
}

void writePlanFiles(const Grid<CellState>& states, const std::string& directory,
                    const std::string& name) {
  makeDirectories(directory);
  writeAtomically(directory + "/" + name + ".pgm",
                  encodePgm(states.geometry, [&](Cell c) { return toPixel(states[c]); }));
  writeAtomically(directory + "/" + name + ".yaml", trinaryYaml(states.geometry, name + ".pgm"));
}

void writeRecording(const std::vector<Reading>& readings, const std::vector<Contact>& contacts,
                    const Snapshot& snapshot, const std::string& directory) {
  std::vector<AccessPoint> access_points;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    access_points.push_back(summary.access_point);
  }
  makeDirectories(directory);
  writeAtomically({{directory + "/readings.csv", readingsCsv(readings)},
                   {directory + "/contacts.csv", contactsCsv(contacts)},
                   {directory + "/access_points.yaml", accessPointsYaml(access_points)}});
}

}  // namespace sfw
