#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/map_picture.h"

namespace sfw {

/// A colour of the legend and what it stands for.
struct LegendEntry {
  Colour colour;
  std::string text;
};

/// A picture of a part of the map frame: metres in, pixels out, x to the right and y up.
/// Below the map it keeps room for a legend and a scale bar.
class Canvas {
 public:
  static constexpr Colour kFree{1.0, 1.0, 1.0};
  static constexpr Colour kOccupied{0.10, 0.10, 0.12};
  static constexpr Colour kUnknown{0.80, 0.81, 0.83};

  /// @param area what is shown [m], not empty
  explicit Canvas(const Box& area);

  /// Fills the cells for which `chosen(Cell)` holds.
  template <class Chosen>
  void fillCells(const GridGeometry& geometry, const Colour& colour, Chosen&& chosen);

  void drawDot(const Position& at, const Colour& colour);

  /// A marked access point with its name beside it; an empty name is left out.
  void drawAccessPoint(const Position& at, const std::string& name);

  /// Caption and entries on the left, scale bar on the right, below the map.
  void drawFooter(const std::string& caption, const std::vector<LegendEntry>& legend);

  /// @throw std::runtime_error if Cairo fails.
  std::string png() const;

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  Position toPixels(const Position& point) const;
  void setColour(const Colour& colour);
  void addCell(const GridGeometry& geometry, Cell cell);
  void drawLabel(const std::string& text, const Position& at_pixels);
  void drawScaleBar(double top);

  Box area_;
  double scale_ = 1.0;  // [px/m]
  double width_ = 0.0;  // of the picture [px]
  double map_height_ = 0.0;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

template <class Chosen>
void Canvas::fillCells(const GridGeometry& geometry, const Colour& colour, Chosen&& chosen) {
  cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);  // no seams between cells
  setColour(colour);
  Cell c;
  for (c.y = 0; c.y < geometry.height(); ++c.y) {
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      if (chosen(c)) {
        addCell(geometry, c);
      }
    }
  }
  cairo_fill(context_.get());
  cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_DEFAULT);
}

}  // namespace sfw
