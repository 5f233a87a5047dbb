#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sfw {
namespace {

constexpr double kLongSide = 1000.0;   // of the map in the picture [px]
constexpr double kBorder = 24.0;       // around the map [px]
constexpr double kFooter = 56.0;       // for legend and scale bar [px]
constexpr double kLeastWidth = 520.0;  // so that the footer fits [px]
constexpr Colour kInk{0.15, 0.15, 0.18};
constexpr Colour kAccessPoint{0.55, 0.10, 0.65};

}  // namespace

Canvas::Canvas(const Box& area) : area_(area) {
  const Position size = area_.sizes();
  scale_ = kLongSide / size.maxCoeff();
  width_ = std::max(kLeastWidth, std::ceil(size.x() * scale_) + 2 * kBorder);
  map_height_ = std::ceil(size.y() * scale_);
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width_),
                                            static_cast<int>(map_height_ + 2 * kBorder + kFooter)));
  context_.reset(cairo_create(surface_.get()));
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), 15.0);
  setColour(kUnknown);
  cairo_paint(context_.get());
}

Position Canvas::toPixels(const Position& point) const {
  return {kBorder + (point.x() - area_.min().x()) * scale_,
          kBorder + (area_.max().y() - point.y()) * scale_};
}

void Canvas::setColour(const Colour& colour) {
  cairo_set_source_rgb(context_.get(), colour[0], colour[1], colour[2]);
}

void Canvas::addCell(const GridGeometry& geometry, Cell cell) {
  const double side = geometry.resolution() * scale_;
  const Position centre = toPixels(geometry.centre(cell));
  cairo_rectangle(context_.get(), centre.x() - side / 2, centre.y() - side / 2, side, side);
}

void Canvas::drawDot(const Position& at, const Colour& colour) {
  const Position centre = toPixels(at);
  setColour(colour);
  cairo_arc(context_.get(), centre.x(), centre.y(), 2.5, 0.0, 2.0 * M_PI);
  cairo_fill(context_.get());
}

void Canvas::drawAccessPoint(const Position& at, const std::string& name) {
  const Position centre = toPixels(at);
  setColour(kAccessPoint);
  cairo_arc(context_.get(), centre.x(), centre.y(), 7.0, 0.0, 2.0 * M_PI);
  cairo_fill_preserve(context_.get());
  setColour(kFree);
  cairo_set_line_width(context_.get(), 2.0);
  cairo_stroke(context_.get());
  if (name.empty()) {
    return;
  }
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), name.c_str(), &extents);
  const double rightmost = std::max(2.0, width_ - extents.width - 4.0);
  drawLabel(name, {std::clamp(centre.x() + 11.0, 2.0, rightmost), centre.y() - 8.0});
}

void Canvas::drawLabel(const std::string& text, const Position& at_pixels) {
  // A light rim keeps it readable on any ground.
  cairo_move_to(context_.get(), at_pixels.x(), at_pixels.y());
  cairo_text_path(context_.get(), text.c_str());
  setColour(kFree);
  cairo_set_line_width(context_.get(), 4.0);
  cairo_stroke_preserve(context_.get());
  setColour(kInk);
  cairo_fill(context_.get());
}

void Canvas::drawFooter(const std::string& caption, const std::vector<LegendEntry>& legend) {
  constexpr double kBox = 16.0, kGap = 6.0, kLeastWidth = 48.0, kRow = 24.0, kScaleText = 60.0;
  const double bottom = map_height_ + 2 * kBorder + kFooter / 2;
  drawLabel(caption, {kBorder, bottom - 10.0});
  double x = kBorder;
  double top = caption.empty() ? bottom - kRow : bottom;  // two rows of entries, or caption and one
  for (const LegendEntry& entry : legend) {
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), entry.text.c_str(), &extents);
    const double width = std::max(kLeastWidth, kBox + 3.0 * kGap + extents.x_advance);
    if (top < bottom && x + width > width_ - kBorder - kScaleText) {
      x = kBorder;
      top = bottom;
    }
    setColour(entry.colour);
    cairo_rectangle(context_.get(), x, top, kBox, kBox);
    cairo_fill(context_.get());
    drawLabel(entry.text, {x + kBox + kGap, top + 14.0});
    x += width;
  }
  drawScaleBar(bottom);
}

void Canvas::drawScaleBar(double top) {
  // The longest round length that takes no more than a third of the width.
  double metres = 1.0;
  for (const double longer : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
    metres = longer * scale_ < width_ / 3 ? longer : metres;
  }
  const double right = width_ - kBorder;
  drawLabel(std::to_string(static_cast<int>(metres)) + " m", {right - 48.0, top - 4.0});
  setColour(kInk);
  cairo_rectangle(context_.get(), right - metres * scale_, top + 5.0, metres * scale_, 6.0);
  cairo_fill(context_.get());
}

std::string Canvas::png() const {
  std::string bytes;
  const auto append = [](void* closure, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("the picture cannot be drawn: ") +
                             cairo_status_to_string(status));
  }
  return bytes;
}

}  // namespace sfw
