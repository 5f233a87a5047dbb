#include "files/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "base/constants.h"
#include "files/png.h"
#include "files/round_length.h"
#include "files/text.h"

namespace sfw {
namespace {

constexpr double kLongSide = 1000.0;   // of the map in the picture [px]
constexpr double kBorder = 40.0;       // around the map, with room for coordinates [px]
constexpr double kFooter = 56.0;       // for legend and scale bar [px]
constexpr double kLeastWidth = 600.0;  // so that header and footer fit [px]
constexpr double kTextSize = 15.0;     // [px]
constexpr Colour kInk{0.15, 0.15, 0.18};

// Panels are drawn larger than their size on a page, so that thin walls and small letters stay
// visible.
namespace panel {
constexpr double kWidth = 388.0;   // [px]
constexpr double kHeight = 440.0;  // largest [px]
constexpr double kGap = 16.0;      // between and around them [px]
constexpr double kHead = 62.0;     // for title and note [px]
constexpr double kFooter = 44.0;   // [px]
constexpr double kTextSize = 20.0;
}  // namespace panel

/// The area with as much beside it as fills a panel's width.
Box filling(const Box& area) {
  const Position size = area.sizes();
  const double width = std::max(size.x(), size.y() * panel::kWidth / panel::kHeight);
  const Position beside((width - size.x()) / 2, 0.0);
  return {area.min() - beside, area.max() + beside};
}

}  // namespace

Canvas::Canvas(const Box& area) : area_(area), corner_(kBorder, kBorder) {
  const Position size = area_.sizes();
  scale_ = kLongSide / size.maxCoeff();
  map_width_ = std::ceil(size.x() * scale_);
  map_height_ = std::ceil(size.y() * scale_);
  makePage(std::max(kLeastWidth, map_width_ + 2 * kBorder), map_height_ + 2 * kBorder + kFooter,
           kTextSize, kUnknown);
}

Canvas::Canvas(const Box& area, int panels) : area_(filling(area)), one_row_(true) {
  scale_ = panel::kWidth / area_.sizes().x();
  map_width_ = panel::kWidth;
  map_height_ = std::ceil(area_.sizes().y() * scale_);
  makePage(panels * (panel::kWidth + panel::kGap) + panel::kGap,
           panel::kHead + map_height_ + panel::kFooter, panel::kTextSize, kFree);
}

void Canvas::makePage(double width, double height, double text_size, const Colour& ground) {
  width_ = width;
  height_ = height;
  text_size_ = text_size;
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width_),
                                            static_cast<int>(height_)));
  context_.reset(cairo_create(surface_.get()));
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), text_size_);
  setColour(ground);
  cairo_paint(context_.get());
}

void Canvas::beginPanel(int panel, const std::string& title, const std::string& note) {
  constexpr double kTitleLine = 26.0, kNoteLine = 52.0;
  corner_ = {panel::kGap + panel * (panel::kWidth + panel::kGap), panel::kHead};
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_BOLD);
  drawLabel(title, {corner_.x(), kTitleLine});
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  drawLabel(note, {corner_.x(), kNoteLine});
  cairo_rectangle(context_.get(), corner_.x(), corner_.y(), map_width_, map_height_);
  cairo_clip(context_.get());
  fillArea(kUnknown);
}

void Canvas::endPanel() { cairo_reset_clip(context_.get()); }

Position Canvas::toPixels(const Position& point) const {
  return {corner_.x() + (point.x() - area_.min().x()) * scale_,
          corner_.y() + (area_.max().y() - point.y()) * scale_};
}

void Canvas::setColour(const Colour& colour) {
  cairo_set_source_rgb(context_.get(), colour[0], colour[1], colour[2]);
}

void Canvas::addCells(const GridGeometry& geometry, Cell first, std::int64_t count) {
  constexpr double kLeast = 1.0;         // smaller ones would vanish [px]
  constexpr double kOverlap = 1 / 64.0;  // Cairo rounds each to 1/256 px, which leaves seams
  const double side = std::max(kLeast, geometry.resolution() * scale_ + kOverlap);
  const Position low = toPixels(geometry.centre(first));
  const Position high = toPixels(geometry.centre({first.x + count - 1, first.y}));
  cairo_rectangle(context_.get(), low.x() - side / 2, low.y() - side / 2, high.x() - low.x() + side,
                  side);
}

void Canvas::fillArea(const Colour& colour) {
  setColour(colour);
  cairo_rectangle(context_.get(), corner_.x(), corner_.y(), map_width_, map_height_);
  cairo_fill(context_.get());
}

void Canvas::drawDots(const std::vector<std::pair<Position, Colour>>& dots) {
  std::vector<Colour> palette;
  const auto width = static_cast<std::size_t>(width_) + 1;
  std::vector<std::uint16_t> last(width * (static_cast<std::size_t>(height_) + 1));  // by pixel
  for (const auto& [at, colour] : dots) {
    const Position centre = toPixels(at);
    const auto found = std::find(palette.begin(), palette.end(), colour);
    const auto number = static_cast<std::uint16_t>(1 + (found - palette.begin()));
    if (found == palette.end()) {
      palette.push_back(colour);
    }
    std::uint16_t& before = last.at(static_cast<std::size_t>(centre.y()) * width +
                                    static_cast<std::size_t>(centre.x()));
    if (before == number) {
      continue;
    }
    before = number;
    setColour(colour);
    cairo_arc(context_.get(), centre.x(), centre.y(), one_row_ ? 2.0 : 2.5, 0.0, 2.0 * kPi);
    cairo_fill(context_.get());
  }
}

void Canvas::drawLine(const Position& from, const Position& to, const Colour& colour,
                      double width_px) {
  const Position start = toPixels(from);
  const Position end = toPixels(to);
  setColour(colour);
  cairo_set_line_width(context_.get(), width_px);
  cairo_move_to(context_.get(), start.x(), start.y());
  cairo_line_to(context_.get(), end.x(), end.y());
  cairo_stroke(context_.get());
}

void Canvas::drawNetLine(const Position& from_pixels, const Position& to_pixels) {
  constexpr double kFaint = 0.2;  // opacity
  cairo_set_source_rgba(context_.get(), kInk[0], kInk[1], kInk[2], kFaint);
  cairo_set_line_width(context_.get(), 1.0);
  cairo_move_to(context_.get(), from_pixels.x(), from_pixels.y());
  cairo_line_to(context_.get(), to_pixels.x(), to_pixels.y());
  cairo_stroke(context_.get());
}

void Canvas::drawAxes() {
  constexpr double kWidestStep = 120.0;  // [px]
  constexpr double kNumberSize = 12.0;   // [px]
  constexpr double kGap = 5.0;           // [px]
  const double step = roundLength(kWidestStep / scale_);
  const Position low = toPixels(area_.min());
  const Position high = toPixels(area_.max());
  cairo_set_font_size(context_.get(), kNumberSize);
  for (double i = std::ceil(area_.min().x() / step); i * step <= area_.max().x(); ++i) {
    const double x = toPixels({i * step, 0.0}).x();
    const std::string number = formatted("%.0f", i * step + 0.0);  // without the sign of -0
    drawNetLine({x, low.y()}, {x, high.y()});
    drawLabel(number, {x - textWidth(number) / 2, low.y() + kNumberSize + kGap});
  }
  for (double i = std::ceil(area_.min().y() / step); i * step <= area_.max().y(); ++i) {
    const double y = toPixels({0.0, i * step}).y();
    const std::string number = formatted("%.0f", i * step + 0.0);
    drawNetLine({low.x(), y}, {high.x(), y});
    drawLabel(number, {low.x() - textWidth(number) - kGap, y + kNumberSize / 3});
  }
  drawLabel("x [m]", {high.x() - textWidth("x [m]") - kGap, low.y() - kGap});
  drawLabel("y [m]", {low.x() + kGap, high.y() + kNumberSize + kGap});
  cairo_set_font_size(context_.get(), text_size_);
}

void Canvas::drawAccessPoint(const Position& at, const std::string& name) {
  const Position centre = toPixels(at);
  setColour(kAccessPoint);
  cairo_arc(context_.get(), centre.x(), centre.y(), 7.0, 0.0, 2.0 * kPi);
  cairo_fill_preserve(context_.get());
  setColour(kFree);
  cairo_set_line_width(context_.get(), 2.0);
  cairo_stroke(context_.get());
  if (!name.empty()) {
    const double rightmost = std::max(2.0, width_ - textWidth(name) - 4.0);
    drawLabel(name, {std::clamp(centre.x() + 11.0, 2.0, rightmost), centre.y() - 8.0});
  }
}

double Canvas::textWidth(const std::string& text) const {
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::drawLabel(const std::string& text, const Position& at_pixels) {
  // A light rim keeps the text readable on any background.
  cairo_move_to(context_.get(), at_pixels.x(), at_pixels.y());
  cairo_text_path(context_.get(), text.c_str());
  setColour(kFree);
  cairo_set_line_width(context_.get(), 4.0);
  cairo_stroke_preserve(context_.get());
  setColour(kInk);
  cairo_fill(context_.get());
}

void Canvas::drawHeader(const std::vector<LegendEntry>& legend) {
  constexpr double kTop = 12.0;  // [px]
  drawLegend(legend, kTop, kTop);
}

void Canvas::drawFooter(const std::string& caption, const std::vector<LegendEntry>& legend) {
  constexpr double kRow = 24.0;
  const double last_row = height_ - (one_row_ ? panel::kFooter - panel::kGap / 2 : kFooter / 2);
  drawLabel(caption, {kBorder, last_row - 10.0});
  // Two rows of entries, or caption and one.
  drawLegend(legend, caption.empty() && !one_row_ ? last_row - kRow : last_row, last_row);
  drawScaleBar(last_row);
}

void Canvas::drawLegend(const std::vector<LegendEntry>& legend, double first_row, double last_row) {
  constexpr double kBox = 16.0, kGap = 6.0, kLeastWidth = 48.0, kScaleText = 60.0;
  const double left = one_row_ ? panel::kGap : kBorder;
  double x = left;
  double top = first_row;
  for (const LegendEntry& entry : legend) {
    const double width = std::max(kLeastWidth, kBox + 3.0 * kGap + textWidth(entry.text));
    if (top < last_row && x + width > width_ - kBorder - kScaleText) {
      x = left;
      top = last_row;
    }
    setColour(entry.colour);
    if (entry.is_dot) {
      cairo_arc(context_.get(), x + kBox / 2, top + kBox / 2, kBox / 2, 0.0, 2.0 * kPi);
    } else {
      cairo_rectangle(context_.get(), x, top, kBox, kBox);
    }
    cairo_fill_preserve(context_.get());
    if (one_row_) {  // keeps white visible on white
      setColour(kInk);
      cairo_set_line_width(context_.get(), 1.0);
      cairo_stroke(context_.get());
    }
    cairo_new_path(context_.get());
    drawLabel(entry.text, {x + kBox + kGap, top + 14.0});
    x += width + (one_row_ ? kBox : 0.0);
  }
}

void Canvas::drawScaleBar(double top) {
  // The longest round length of at most a third of the width.
  const double most = (one_row_ ? map_width_ : width_) / 3;
  const double metres = roundLength(most / scale_);
  const double length = metres * scale_;
  const double right = width_ - (one_row_ ? panel::kGap : kBorder);
  const std::string text = std::to_string(static_cast<int>(metres)) + " m";
  drawLabel(text, one_row_ ? Position(right - length - textWidth(text) - 8.0, top + 14.0)
                           : Position(right - 48.0, top - 4.0));
  setColour(kInk);
  cairo_rectangle(context_.get(), right - length, top + 5.0, length, 6.0);
  cairo_fill(context_.get());
}

std::string Canvas::png() const {
  cairo_surface_flush(surface_.get());
  if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS ||
      cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("the picture cannot be drawn: ") +
                             cairo_status_to_string(cairo_status(context_.get())));
  }
  const std::int64_t width = cairo_image_surface_get_width(surface_.get());
  const std::int64_t height = cairo_image_surface_get_height(surface_.get());
  const unsigned char* row = cairo_image_surface_get_data(surface_.get());
  std::vector<std::uint8_t> rgb;
  rgb.reserve(static_cast<std::size_t>(3 * width * height));
  for (std::int64_t y = 0; y < height; ++y) {
    for (std::int64_t x = 0; x < width; ++x) {
      std::uint32_t pixel = 0;  // of CAIRO_FORMAT_RGB24
      std::memcpy(&pixel, row + x * static_cast<std::int64_t>(sizeof(pixel)), sizeof(pixel));
      for (const int shift : {16, 8, 0}) {
        rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
      }
    }
    row += cairo_image_surface_get_stride(surface_.get());
  }
  return encodeRgbPng(width, height, rgb);
}

}  // namespace sfw
