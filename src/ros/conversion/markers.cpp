#include "ros/conversion/markers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "output/map_picture.h"
#include "ros/conversion/message_conversion.h"

namespace sfw {
namespace {

constexpr Colour kViolet{0.75, 0.20, 0.90};   // legible on free and occupied cells alike
constexpr Colour kOrange{0.95, 0.40, 0.00};   // likewise, and distinct from violet
constexpr Colour kDarkRed{0.55, 0.00, 0.00};  // of walls
constexpr Colour kPaleRed{0.90, 0.45, 0.40};  // of outer walls, which no ray confirms
constexpr double kAboveMap = 0.03;            // [m]
constexpr double kLetterHeight = 0.3;         // [m]
constexpr double kDeviations = 2.0;           // from the centre to the rim of an ellipse

std_msgs::ColorRGBA toColour(const Colour& colour, float opacity = 1.0F) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(colour[0]);
  message.g = static_cast<float>(colour[1]);
  message.b = static_cast<float>(colour[2]);
  message.a = opacity;
  return message;
}

}  // namespace

visualization_msgs::Marker marker(const std_msgs::Header& header, const char* name, int id,
                                  int type, double size, const Colour& colour) {
  visualization_msgs::Marker message;
  message.header = header;
  message.ns = name;
  message.id = id;
  message.type = type;
  message.pose.orientation.w = 1.0;
  message.scale.x = message.scale.y = message.scale.z = size;
  message.color = toColour(colour);
  return message;
}

visualization_msgs::Marker label(const std_msgs::Header& header, const char* name, int id,
                                 const std::string& text, const geometry_msgs::Point& at,
                                 const Colour& colour, double letter_height_m) {
  visualization_msgs::Marker message = marker(
      header, name, id, visualization_msgs::Marker::TEXT_VIEW_FACING, letter_height_m, colour);
  message.text = text;
  message.pose.position = at;
  return message;
}

namespace {

visualization_msgs::Marker pathMarker(const Snapshot& snapshot, const std_msgs::Header& header) {
  constexpr double kDot = 0.08;  // [m]
  visualization_msgs::Marker dots =
      marker(header, "path", 0, visualization_msgs::Marker::SPHERE_LIST, kDot, {1.0, 1.0, 1.0});
  for (const PathPose& pose : snapshot.path) {
    dots.points.push_back(toPoint(pose.antenna_in_map, kAboveMap));
    dots.colors.push_back(toColour(wallCountColour(pose.walls)));
  }
  return dots;
}

visualization_msgs::Marker wallMarker(const Snapshot& snapshot, const std_msgs::Header& header) {
  constexpr double kWidth = 0.12;  // [m]
  visualization_msgs::Marker lines =
      marker(header, "walls", 0, visualization_msgs::Marker::LINE_LIST, kWidth, kDarkRed);
  for (const WallSegment& wall : snapshot.walls) {
    for (const Position& end : {wall.from, wall.to}) {
      lines.points.push_back(toPoint(end, kAboveMap));
      lines.colors.push_back(
          toColour(wall.is_outer ? kPaleRed : kDarkRed, static_cast<float>(wall.confidence)));
    }
  }
  return lines;
}

/// Half axes of the ellipse of an estimate, and the direction of the longer one.
struct Ellipse {
  double longer_m;
  double shorter_m;
  double yaw_rad;
};

Ellipse ellipseOf(const AccessPointEstimate& estimate) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(estimate.covariance);  // by size
  const Eigen::Vector2d half = kDeviations * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d along = axes.eigenvectors().col(1);
  return {half.y(), half.x(), std::atan2(along.y(), along.x())};
}

visualization_msgs::Marker ellipseMarker(const AccessPointSummary& summary,
                                         const std_msgs::Header& header, int id) {
  constexpr double kThinnest = 0.05;  // [m]
  constexpr float kFaint = 0.15F;
  const Ellipse ellipse = ellipseOf(*summary.estimate);
  visualization_msgs::Marker disc =
      marker(header, "uncertainty", id, visualization_msgs::Marker::CYLINDER, kAboveMap, kViolet);
  disc.pose.position = toPoint(summary.access_point.position, kAboveMap);
  disc.pose.orientation.z = std::sin(0.5 * ellipse.yaw_rad);
  disc.pose.orientation.w = std::cos(0.5 * ellipse.yaw_rad);
  disc.scale.x = std::max(2.0 * ellipse.longer_m, kThinnest);
  disc.scale.y = std::max(2.0 * ellipse.shorter_m, kThinnest);
  disc.color = toColour(kViolet, kFaint);
  return disc;
}

/// An access point with its check.
struct CheckedAccessPoint {
  const AccessPointSummary* summary;
  const AccessPointFit* fit;  // nullptr without a check

  bool isSuspect() const { return fit != nullptr && fit->suspect; }
};

std::vector<CheckedAccessPoint> withChecks(const Snapshot& snapshot, const DataFindings& findings) {
  std::vector<CheckedAccessPoint> all;
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    all.push_back({&snapshot.access_points[i], findings.fit(i)});
  }
  return all;
}

/// Where the table puts an access point [m], whether the map uses that position or an estimate.
const Position& givenPosition(const AccessPointSummary& summary) {
  return summary.given_position ? *summary.given_position : summary.access_point.position;
}

/// A line from the given position to the one that the map uses.
visualization_msgs::Marker givenMarker(const AccessPointSummary& summary,
                                       const std_msgs::Header& header, int id, double height) {
  constexpr double kLine = 0.05;  // [m]
  visualization_msgs::Marker line =
      marker(header, "given", id, visualization_msgs::Marker::LINE_LIST, kLine, kViolet);
  line.points = {toPoint(givenPosition(summary), height),
                 toPoint(summary.access_point.position, height)};
  return line;
}

/// A line from the given position of a suspect access point to its estimate.
visualization_msgs::Marker doubtMarker(const CheckedAccessPoint& checked,
                                       const std_msgs::Header& header, int id, double height) {
  constexpr double kLine = 0.05;  // [m]
  visualization_msgs::Marker line =
      marker(header, "doubts", id, visualization_msgs::Marker::LINE_LIST, kLine, kOrange);
  line.points = {toPoint(givenPosition(*checked.summary), height),
                 toPoint(checked.fit->estimate.position, height)};
  return line;
}

std::string inMetres(const char* format, double metres) {
  char text[96];
  std::snprintf(text, sizeof text, format, metres);
  return text;
}

std::string labelOf(const CheckedAccessPoint& checked) {
  const AccessPoint& access_point = checked.summary->access_point;
  const std::optional<AccessPointEstimate>& estimate = checked.summary->estimate;
  std::string text = access_point.name.empty() ? access_point.bssid.str() : access_point.name;
  if (estimate) {
    text += inMetres("\nestimated, ± %.1f m", ellipseOf(*estimate).longer_m);
    text += estimate->ambiguous ? "\none place of several" : "";
  }
  if (checked.isSuspect()) {
    text += inMetres("\nreadings fit %.1f m away", checked.fit->distance_m);
  }
  return text;
}

/// A name that is to stand beside an access point.
struct Name {
  const CheckedAccessPoint* checked;
  int id;
  geometry_msgs::Point above;  // the access point
};

/// The name beside an access point. No line of the text covers the access point.
visualization_msgs::Marker nameMarker(const Name& name, const std_msgs::Header& header,
                                      const std::string& text, double letter_height_m) {
  const auto more_lines = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
  geometry_msgs::Point at = name.above;
  at.y += 0.4 + 0.5 * letter_height_m * more_lines;
  return label(header, "names", name.id, text, at, name.checked->isSuspect() ? kOrange : kViolet,
               letter_height_m);
}

/// The name of the table, or the last two bytes of the address.
std::string shortLabelOf(const CheckedAccessPoint& checked) {
  constexpr std::size_t kLastBytes = 5;  // characters
  const AccessPoint& access_point = checked.summary->access_point;
  const std::string bssid = access_point.bssid.str();
  return access_point.name.empty() ? ".." + bssid.substr(bssid.size() - kLastBytes)
                                   : access_point.name;
}

/// The part of the floor that a line of text covers, seen from above.
Box boxOf(const visualization_msgs::Marker& line) {
  constexpr double kWidth = 0.6;  // of a letter, in letter heights
  const Position centre(line.pose.position.x, line.pose.position.y);
  const Position half =
      0.5 * line.scale.z * Position(kWidth * static_cast<double>(line.text.size()), 1.0);
  return {centre - half, centre + half};
}

/// Adds the names. Many of them would cover the map: then they are short and small, and a name that
/// would cover another one is left out, unless its access point is suspect and the other one is
/// not.
void addNames(std::vector<Name> names, const std_msgs::Header& header,
              std::vector<visualization_msgs::Marker>& markers) {
  constexpr std::size_t kMostWhole = 12;
  constexpr double kSmall = 0.2;  // [m]
  if (names.size() <= kMostWhole) {
    for (const Name& name : names) {
      markers.push_back(nameMarker(name, header, labelOf(*name.checked), kLetterHeight));
    }
    return;
  }
  std::stable_partition(names.begin(), names.end(),
                        [](const Name& name) { return name.checked->isSuspect(); });
  std::vector<Box> taken;
  for (const Name& name : names) {
    visualization_msgs::Marker line = nameMarker(name, header, shortLabelOf(*name.checked), kSmall);
    const Box box = boxOf(line);
    if (std::none_of(taken.begin(), taken.end(),
                     [&](const Box& other) { return other.intersects(box); })) {
      taken.push_back(box);
      markers.push_back(std::move(line));
    }
  }
}

bool shareAPosition(const CheckedAccessPoint& a, const CheckedAccessPoint& b) {
  return hasPosition(*a.summary) && hasPosition(*b.summary) &&
         a.summary->access_point.position == b.summary->access_point.position;
}

/// The radio in the label of a position. Among radios there that follow each other in the table, it
/// is the first suspect one, or else the first. Nullptr if the position has a label already.
const CheckedAccessPoint* labelled(const std::vector<CheckedAccessPoint>& all, std::size_t first) {
  if (first > 0 && shareAPosition(all[first - 1], all[first])) {
    return nullptr;
  }
  for (std::size_t i = first; i < all.size() && shareAPosition(all[first], all[i]); ++i) {
    if (all[i].isSuspect()) {
      return &all[i];
    }
  }
  return &all[first];
}

void addAccessPoints(const std::vector<CheckedAccessPoint>& all, const std_msgs::Header& header,
                     visualization_msgs::MarkerArray& array) {
  constexpr double kBall = 0.3;         // [m]
  constexpr double kUsualHeight = 1.0;  // [m], where the table gives none
  std::vector<visualization_msgs::Marker>& markers = array.markers;
  std::vector<Name> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const AccessPointSummary& summary = *all[i].summary;
    if (!isPlaced(summary) || summary.radio) {
      continue;
    }
    const AccessPoint& access_point = summary.access_point;
    const double height = access_point.height_m.value_or(kUsualHeight);
    const int id = static_cast<int>(i);
    markers.push_back(marker(header, "access_points", id, visualization_msgs::Marker::SPHERE, kBall,
                             all[i].isSuspect() ? kOrange : kViolet));
    markers.back().pose.position = toPoint(access_point.position, height);
    if (const CheckedAccessPoint* const named = labelled(all, i)) {
      names.push_back({named, id, toPoint(access_point.position, height + kBall)});
    }
    if (summary.estimate) {
      markers.push_back(ellipseMarker(summary, header, id));
    }
    if (summary.given_position) {
      markers.push_back(givenMarker(summary, header, id, height));
    }
    if (all[i].isSuspect()) {
      markers.push_back(doubtMarker(all[i], header, id, height));
    }
  }
  addNames(std::move(names), header, markers);
}

void addLegend(const Snapshot& snapshot, const std_msgs::Header& header,
               visualization_msgs::MarkerArray& markers) {
  int most = -1;
  Box area;
  for (const PathPose& pose : snapshot.path) {
    most = std::max(most, pose.walls);
    area.extend(pose.antenna_in_map);
  }
  for (int walls = 0; walls <= most; ++walls) {
    const Position at(area.min().x() + 1.1 * walls, area.min().y() - 1.0);
    markers.markers.push_back(label(header, "legend", walls, "k = " + std::to_string(walls),
                                    toPoint(at, 0.1), wallCountColour(walls), kLetterHeight));
  }
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Snapshot& snapshot, const DataFindings& findings,
                                          const std_msgs::Header& header) {
  visualization_msgs::MarkerArray markers;
  visualization_msgs::Marker clear;
  clear.header = header;
  clear.action = visualization_msgs::Marker::DELETEALL;
  markers.markers.push_back(clear);
  if (!snapshot.path.empty()) {
    markers.markers.push_back(pathMarker(snapshot, header));
  }
  if (!snapshot.walls.empty()) {
    markers.markers.push_back(wallMarker(snapshot, header));
  }
  addAccessPoints(withChecks(snapshot, findings), header, markers);
  addLegend(snapshot, header, markers);
  return markers;
}

}  // namespace sfw
