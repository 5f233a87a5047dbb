#include "mapping/map_extent.h"

#include <stdexcept>
#include <string>

#include "base/map_too_large.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

Box withMargin(const Box& extent, double margin_m) {
  const Position margin(margin_m, margin_m);
  return {extent.min() - margin, extent.max() + margin};
}

GridGeometry geometryAround(const Box& extent, const Config::Map& config) {
  return GridGeometry::covering(withMargin(extent, config.margin_m), config.resolution_m,
                                config.growth_step_m, config.max_cells);
}

Box extentOf(const std::vector<AccessPoint>& access_points) {
  Box box;
  for (const AccessPoint& access_point : access_points) {
    if (access_point.position_known) {
      box.extend(access_point.position);
    }
  }
  if (box.isEmpty()) {
    box.extend(Position::Zero());  // a map needs a position before the first reading
  }
  return box;
}

/// The extent of a map without readings.
/// @throw InputError if no map can hold its positions.
Box leastExtent(const Config::Map& config, const std::vector<AccessPoint>& access_points) {
  for (const AccessPoint& access_point : access_points) {
    if (!access_point.position.allFinite()) {
      throw InputError("access_points: the position of " + access_point.bssid.str() +
                       " must be finite");
    }
  }
  const Box extent = extentOf(access_points);
  try {
    geometryAround(extent, config);
  } catch (const std::invalid_argument& error) {
    throw InputError("no map can hold the access points: " + std::string(error.what()) +
                     "; correct their positions, or raise map/max_cells (" +
                     std::to_string(config.max_cells) +
                     "), raise map/resolution, or lower map/growth_step");
  }
  return extent;
}

}  // namespace

MapExtent::MapExtent(const Config::Map& config, const std::vector<AccessPoint>& access_points)
    : config_(config), least_(leastExtent(config, access_points)), reserved_(least_) {}

bool MapExtent::fits(const Box& extent) const {
  return GridGeometry::canCover(withMargin(extent, config_.margin_m), config_.resolution_m,
                                config_.growth_step_m, config_.max_cells);
}

InsertResult MapExtent::reserve(const Position& point) {
  if (!point.allFinite()) {
    return InsertResult::kPositionNotFinite;
  }
  if (!reserved_.contains(point)) {
    const Box extent = reserved_.merged(Box(point));
    if (!fits(extent)) {
      return InsertResult::kPositionTooFar;
    }
    reserved_ = extent;
  }
  return InsertResult::kAccepted;
}

InsertResult MapExtent::makeRoomFor(const Position& point, const Extent& of_inliers) {
  InsertResult result = reserve(point);
  if (result == InsertResult::kPositionTooFar && holds_stray_room_) {
    reserved_ = of_inliers();
    holds_stray_room_ = false;
    result = reserve(point);
  }
  // The point may be stray itself, or make other poses stray.
  holds_stray_room_ = holds_stray_room_ || result == InsertResult::kAccepted;
  return result;
}

bool MapExtent::reserveMoved(const Box& all) {
  holds_stray_room_ = true;
  const Box extent = reserved_.merged(all);
  if (!fits(extent)) {
    return false;
  }
  reserved_ = extent;
  return true;
}

void MapExtent::release(const Box& of_inliers) {
  reserved_ = fits(of_inliers) ? of_inliers : least_;
}

void MapExtent::growTo(const Box& extent) {
  if (fits(reserved_.merged(extent))) {
    least_.extend(extent);
    reserved_.extend(extent);
  }
}

void MapExtent::restart(const Box& of_inliers) {
  least_ = of_inliers;
  reserved_ = of_inliers;
  holds_stray_room_ = false;
}

void MapExtent::extendTo(const std::vector<AccessPoint>& access_points) {
  const Box least = leastExtent(config_, access_points);
  const Box extent = least.merged(reserved_);
  if (!fits(extent)) {
    throw InputError("no map can hold the access points and the path: " +
                     tooLargeText(extent, config_));
  }
  least_.extend(least);
  reserved_ = extent;
}

GridGeometry MapExtent::geometryOf(const Box& extent) const {
  try {
    return geometryAround(extent, config_);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(extent, config_));
  }
}

}  // namespace sfw
