#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace sfw {

/// A strict stand-in for costmap_2d's static layer: takes each map as the layer would, and is
/// stricter where the layer would silently make something of a bad one.
///
/// A changed geometry makes the layer clear all its costmaps, so after the first map only growth by
/// whole cells in all directions is taken, and none at all once `holdGeometry()` was called.
class StaticLayer {
 public:
  /// @param global_frame the costmap's frame: a map in any other is dropped by the layer
  explicit StaticLayer(std::string global_frame = "map") : global_frame_(std::move(global_frame)) {}

  testing::AssertionResult accept(const nav_msgs::OccupancyGrid& map) {
    const std::string fault = faultOf(map);
    if (!fault.empty()) {
      return testing::AssertionFailure() << "map " << maps_ << ": " << fault;
    }
    info_ = map.info;
    ++maps_;
    return testing::AssertionSuccess();
  }

  /// From here on even growth is a fault.
  void holdGeometry() { may_grow_ = false; }

  std::size_t maps() const { return maps_; }

 private:
  std::string faultOf(const nav_msgs::OccupancyGrid& map) const {
    const nav_msgs::MapMetaData& info = map.info;
    if (map.header.frame_id != global_frame_) {
      return "frame is '" + map.header.frame_id + "'";
    }
    if (!(info.resolution > 0.0F && std::isfinite(info.resolution))) {
      return "resolution is not positive";
    }
    if (info.width == 0 || info.height == 0 ||
        map.data.size() != std::size_t{info.width} * info.height) {
      return "size is 0 or does not match the data";
    }
    if (!isFlat(info.origin)) {
      return "origin is not finite, is off the floor or is turned";
    }
    // 1..99 would become free, and anything below -1 or above 100 lethal.
    if (!std::all_of(map.data.begin(), map.data.end(),
                     [](std::int8_t value) { return value == -1 || value == 0 || value == 100; })) {
      return "a cell is neither -1, 0 nor 100";
    }
    return info_ ? changeOf(info) : "";
  }

  static bool isFlat(const geometry_msgs::Pose& origin) {
    const geometry_msgs::Quaternion& turn = origin.orientation;
    return std::isfinite(origin.position.x) && std::isfinite(origin.position.y) &&
           origin.position.z == 0.0 && turn.x == 0.0 && turn.y == 0.0 && turn.z == 0.0 &&
           turn.w == 1.0;
  }

  /// What is wrong with the step from the last geometry to this one.
  std::string changeOf(const nav_msgs::MapMetaData& info) const {
    if (info.resolution != info_->resolution) {
      return "resolution changed";
    }
    const auto& from = info_->origin.position;
    const auto& to = info.origin.position;
    const bool same = from.x == to.x && from.y == to.y && info.width == info_->width &&
                      info.height == info_->height;
    if (same) {
      return "";
    }
    if (!may_grow_) {
      return "geometry changed";
    }
    return grew(from.x, info_->width, to.x, info.width) &&
                   grew(from.y, info_->height, to.y, info.height)
               ? ""
               : "geometry changed, but not by whole cells outwards";
  }

  /// True if the new extent holds the old one and is off by whole cells, along one axis.
  bool grew(double old_origin, std::uint32_t old_size, double origin, std::uint32_t size) const {
    const double cells = (old_origin - origin) / static_cast<double>(info_->resolution);
    const double whole = std::round(cells);
    return std::abs(cells - whole) < 1e-3 && whole >= 0.0 && size >= old_size + whole;
  }

  std::string global_frame_;
  std::optional<nav_msgs::MapMetaData> info_;
  std::size_t maps_ = 0;
  bool may_grow_ = true;
};

}  // namespace sfw
