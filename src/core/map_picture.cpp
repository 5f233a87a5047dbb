#include "structure_from_wifi/map_picture.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

namespace sfw {
namespace {

constexpr double kLongSide = 1000.0;  // of the map in the picture [px]
constexpr double kBorder = 24.0;      // around the map [px]
constexpr double kFooter = 56.0;      // for legend and scale bar [px]
constexpr double kLeastWidth = 520.0; // so that the footer fits [px]
constexpr Colour kFree{1.0, 1.0, 1.0};
constexpr Colour kOccupied{0.10, 0.10, 0.12};
constexpr Colour kUnknown{0.80, 0.81, 0.83};
constexpr Colour kInk{0.15, 0.15, 0.18};
constexpr Colour kAccessPoint{0.55, 0.10, 0.65};

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

void setColour(cairo_t* context, const Colour& colour) {
  cairo_set_source_rgb(context, colour[0], colour[1], colour[2]);
}

/// The part of the map worth showing: known cells, path and access points, with some air.
Box shownArea(const Snapshot& snapshot) {
  const GridGeometry& geometry = snapshot.belief.geometry();
  Box area;
  for (const PathPose& pose : snapshot.path) {
    area.extend(pose.antenna_in_map);
  }
  for (const AccessPointSummary& summary : snapshot.access_points) {
    area.extend(summary.access_point.position);
  }
  Cell c;
  for (c.y = 0; c.y < geometry.height(); ++c.y) {
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      if (snapshot.belief.state(c) != CellState::kUnknown) {
        area.extend(geometry.centre(c));
      }
    }
  }
  constexpr double kAir = 0.5;  // [m]
  return {area.min().array() - kAir, area.max().array() + kAir};
}

/// Draws one picture: metres in, pixels out.
class Picture {
 public:
  explicit Picture(const Snapshot& snapshot) : snapshot_(snapshot), area_(shownArea(snapshot)) {
    const Position size = area_.sizes();
    scale_ = kLongSide / size.maxCoeff();
    width_ = std::max(kLeastWidth, std::ceil(size.x() * scale_) + 2 * kBorder);
    map_height_ = std::ceil(size.y() * scale_);
    surface_.reset(cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, static_cast<int>(width_),
        static_cast<int>(map_height_ + 2 * kBorder + kFooter)));
    context_.reset(cairo_create(surface_.get()));
    cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_.get(), 15.0);
  }

  std::string png() {
    setColour(context_.get(), kUnknown);
    cairo_paint(context_.get());
    drawCells();
    drawPath();
    drawAccessPoints();
    drawFooter();
    return encoded();
  }

 private:
  Position toPixels(const Position& point) const {
    return {kBorder + (point.x() - area_.min().x()) * scale_,
            kBorder + (area_.max().y() - point.y()) * scale_};
  }

  void drawCells() {
    const GridGeometry& geometry = snapshot_.belief.geometry();
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);  // no seams between cells
    for (const CellState state : {CellState::kFree, CellState::kOccupied}) {
      setColour(context_.get(), state == CellState::kFree ? kFree : kOccupied);
      Cell c;
      for (c.y = 0; c.y < geometry.height(); ++c.y) {
        for (c.x = 0; c.x < geometry.width(); ++c.x) {
          if (snapshot_.belief.state(c) == state) {
            const Position low = toPixels(geometry.centre(c).array() - geometry.resolution() / 2);
            const double side = geometry.resolution() * scale_;
            cairo_rectangle(context_.get(), low.x(), low.y() - side, side, side);
          }
        }
      }
      cairo_fill(context_.get());
    }
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_DEFAULT);
  }

  void drawPath() {
    for (const PathPose& pose : snapshot_.path) {
      const Position at = toPixels(pose.antenna_in_map);
      setColour(context_.get(), wallCountColour(pose.walls));
      cairo_arc(context_.get(), at.x(), at.y(), 2.5, 0.0, 2.0 * M_PI);
      cairo_fill(context_.get());
    }
  }

  void drawAccessPoints() {
    for (const AccessPointSummary& summary : snapshot_.access_points) {
      const AccessPoint& access_point = summary.access_point;
      const Position at = toPixels(access_point.position);
      setColour(context_.get(), kAccessPoint);
      cairo_arc(context_.get(), at.x(), at.y(), 7.0, 0.0, 2.0 * M_PI);
      cairo_fill_preserve(context_.get());
      setColour(context_.get(), kFree);
      cairo_set_line_width(context_.get(), 2.0);
      cairo_stroke(context_.get());
    }
    drawNames();
  }

  /// Radios at one place (the bands of one router) share a label.
  void drawNames() {
    std::set<std::pair<double, double>> named;
    for (const AccessPointSummary& summary : snapshot_.access_points) {
      const AccessPoint& access_point = summary.access_point;
      if (!named.emplace(access_point.position.x(), access_point.position.y()).second) {
        continue;
      }
      const std::string name =
          access_point.name.empty() ? access_point.bssid.str() : access_point.name;
      cairo_text_extents_t extents;
      cairo_text_extents(context_.get(), name.c_str(), &extents);
      const Position at = toPixels(access_point.position);
      const double x = std::clamp(at.x() + 11.0, 2.0, width_ - extents.width - 4.0);
      drawLabel(name, {x, at.y() - 8.0});
    }
  }

  /// Text with a light rim, readable on any ground.
  void drawLabel(const std::string& text, const Position& at) {
    cairo_move_to(context_.get(), at.x(), at.y());
    cairo_text_path(context_.get(), text.c_str());
    setColour(context_.get(), kFree);
    cairo_set_line_width(context_.get(), 4.0);
    cairo_stroke_preserve(context_.get());
    setColour(context_.get(), kInk);
    cairo_fill(context_.get());
  }

  void drawFooter() {
    const double y = map_height_ + 2 * kBorder + kFooter / 2;
    int most = 0;
    for (const PathPose& pose : snapshot_.path) {
      most = std::max(most, pose.walls);
    }
    drawLabel("walls to the nearest access point:", {kBorder, y - 10.0});
    for (int walls = 0; walls <= most; ++walls) {
      const double x = kBorder + walls * 48.0;
      setColour(context_.get(), wallCountColour(walls));
      cairo_rectangle(context_.get(), x, y, 16.0, 16.0);
      cairo_fill(context_.get());
      drawLabel(std::to_string(walls), {x + 22.0, y + 14.0});
    }
    // The longest of 1, 2, 5, 10, ... metres that fits a third of the width.
    double metres = 1.0;
    for (const double longer : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
      metres = longer * scale_ < width_ / 3 ? longer : metres;
    }
    const double right = width_ - kBorder;
    drawLabel(std::to_string(static_cast<int>(metres)) + " m", {right - 40.0, y - 4.0});
    setColour(context_.get(), kInk);
    cairo_rectangle(context_.get(), right - metres * scale_, y + 5.0, metres * scale_, 6.0);
    cairo_fill(context_.get());
  }

  std::string encoded() {
    std::string bytes;
    const auto append = [](void* closure, const unsigned char* data, unsigned int length) {
      static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
      return CAIRO_STATUS_SUCCESS;
    };
    const cairo_status_t status =
        cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(std::string("the picture cannot be drawn: ") +
                               cairo_status_to_string(status));
    }
    return bytes;
  }

  const Snapshot& snapshot_;
  Box area_;
  double scale_ = 1.0;  // [px/m]
  double width_ = 0.0;
  double map_height_ = 0.0;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace

Colour wallCountColour(int walls) {
  if (walls < 0) {
    return {0.5, 0.5, 0.5};
  }
  constexpr std::array<Colour, 8> kScale{{{0.90, 0.10, 0.10},
                                          {0.10, 0.70, 0.15},
                                          {0.10, 0.30, 0.95},
                                          {0.95, 0.80, 0.05},
                                          {0.95, 0.50, 0.05},
                                          {0.05, 0.75, 0.80},
                                          {0.85, 0.30, 0.75},
                                          {0.45, 0.30, 0.20}}};
  return kScale[std::min(static_cast<std::size_t>(walls), kScale.size() - 1)];
}

std::string renderPicture(const Snapshot& snapshot) { return Picture(snapshot).png(); }

}  // namespace sfw
