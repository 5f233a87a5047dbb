#include "output/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "grid/for_each_cell.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/version.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

Json describe(const Config& config) {
  Json settings;
  forEachSetting(config, [&](const std::string& name, const auto& value) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) {
      settings[name] = value;
    } else {
      settings[name.substr(0, slash)][name.substr(slash + 1)] = value;
    }
  });
  return settings;
}

Json describe(const AccessPointSummary& summary, const AccessPointFit* fit) {
  const AccessPoint& access_point = summary.access_point;
  Json json{{"bssid", access_point.bssid.str()},
            {"name", access_point.name},
            {"readings", summary.readings}};
  if (summary.radio) {
    json["radio"] = summary.radio->str();
  }
  if (hasPosition(summary)) {
    json["x"] = access_point.position.x();
    json["y"] = access_point.position.y();
  }
  if (!hasPosition(summary)) {
    json["left_out"] = "it has no position, and its readings do not suffice to estimate one";
  } else if (!isPlaced(summary)) {
    json["left_out"] = "its estimated position is too uncertain";
  }
  if (summary.given_position) {
    json["given"] = {{"x", summary.given_position->x()},
                     {"y", summary.given_position->y()},
                     {"sd_m", access_point.position_sd_m.value_or(0.0)}};
  }
  if (summary.estimate) {
    const Eigen::Matrix2d& covariance = summary.estimate->covariance;
    json["estimated"] = {{"sd_x_m", std::sqrt(covariance(0, 0))},
                         {"sd_y_m", std::sqrt(covariance(1, 1))},
                         {"ambiguous", summary.estimate->ambiguous}};
  }
  if (fit != nullptr) {
    const Position& better = fit->estimate.position;
    json["fit"] = {{"residual_db", fit->residual_db},
                   {"log_ratio", fit->log_ratio},
                   {"suspect", fit->suspect}};
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

}  // namespace

std::string reportJson(const Snapshot& snapshot, const Config& config,
                       const DataFindings& findings) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < snapshot.path.size(); ++i) {
    length_m +=
        snapshot.path[i].robot != snapshot.path[i - 1].robot
            ? 0.0
            : (snapshot.path[i].antenna_in_map - snapshot.path[i - 1].antenna_in_map).norm();
  }
  Json report;
  report["version"] = version();
  report["method"] = config.method;
  report["notes"] = Json::array();
  for (const MapNote& note : mapNotes(snapshot, findings)) {
    report["notes"].push_back(note.text);
  }
  report["map"] = describe(snapshot.belief);
  if (!snapshot.offset.isZero()) {
    report["map"]["offset"] = {snapshot.offset.x(), snapshot.offset.y()};
  }
  report["path"] = {{"poses", snapshot.path.size()},
                    {"length_m", length_m},
                    {"stray_poses", snapshot.stray.count},
                    {"jumps", snapshot.motion.jumps},
                    {"usual_speed_m_s", snapshot.motion.usual_speed_m_s}};
  if (findings.drift) {
    report["drift"] = describe(*findings.drift);
  }
  report["has_table"] = snapshot.has_table;
  report["access_points"] = Json::array();
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    report["access_points"].push_back(describe(snapshot.access_points[i], findings.fit(i)));
  }
  if (snapshot.tomography) {
    report["tomography"] = describe(*snapshot.tomography);
  }
  report["left_out"] = describe(snapshot.rejections);
  report["settings"] = describe(config);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sfw
