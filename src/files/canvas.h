#pragma once

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/colour.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A colour of the legend with its meaning.
struct LegendEntry {
  Colour colour;
  std::string text;
  bool is_dot = false;  ///< drawn as a dot, not as an area
};

/// Draws a picture of an area of the map frame: metres in, pixels out, x to the right and y up.
///
/// A legend and a scale bar lie below the area. Several panels of the same area may lie side by
/// side, each with a title above it.
class Canvas {
 public:
  static constexpr Colour kFree{1.0, 1.0, 1.0};
  static constexpr Colour kOccupied{0.10, 0.10, 0.12};
  static constexpr Colour kUnknown{0.80, 0.81, 0.83};
  static constexpr Colour kAccessPoint{0.55, 0.10, 0.65};

  /// @param area shown area [m], not empty
  explicit Canvas(const Box& area);

  /// @param panels  number of panels; each shows the area, and its surroundings as far as they fit
  Canvas(const Box& area, int panels);

  /// Begins a panel, counted from 0, and writes its title and note. Later calls draw into it.
  void beginPanel(int panel, const std::string& title, const std::string& note);

  /// Ends the panel. Later calls draw outside of panels.
  void endPanel();

  /// Fills the area; a picture begins with the colour of unknown cells.
  void fillArea(const Colour& colour);

  /// Fills the cells for which `chosen(Cell)` holds, as far as they lie in the area.
  template <class Chosen>
  void fillCells(const GridGeometry& geometry, const Colour& colour, Chosen&& chosen);

  /// Draws dots, the later ones over the earlier. A robot's path has a pose for each reading, so a
  /// dot is left out where the last dot in its pixel has the same colour.
  /// @param dots  in the area, with their colours
  void drawDots(const std::vector<std::pair<Position, Colour>>& dots);

  /// @param width_px  on the picture, whatever its scale
  void drawLine(const Position& from, const Position& to, const Colour& colour, double width_px);

  /// Draws a net of round coordinates across the area, with numbers in the border [m]. A picture
  /// with panels has no room for the numbers.
  void drawAxes();

  /// Draws an access point with its name beside it, if the name is not empty.
  void drawAccessPoint(const Position& at, const std::string& name);

  /// Draws entries above the area. A picture with panels has no room for them.
  void drawHeader(const std::vector<LegendEntry>& legend);

  /// Draws caption and entries on the left, and the scale bar on the right. A picture with panels
  /// has room for one row of entries and for no caption.
  void drawFooter(const std::string& caption, const std::vector<LegendEntry>& legend);

  /// @throw std::runtime_error if Cairo fails.
  std::string png() const;

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  void makePage(double width, double height, double text_size, const Colour& ground);
  Position toPixels(const Position& point) const;
  void setColour(const Colour& colour);
  void drawNetLine(const Position& from_pixels, const Position& to_pixels);
  /// Adds a row of cells to what the next fill covers. They overlap, so one piece covers the same
  /// pixels as they do one by one.
  void addCells(const GridGeometry& geometry, Cell first, std::int64_t count);
  void drawLabel(const std::string& text, const Position& at_pixels);
  double textWidth(const std::string& text) const;
  void drawLegend(const std::vector<LegendEntry>& legend, double first_row, double last_row);
  void drawScaleBar(double top);

  Box area_;
  Position corner_;         // where the area's upper left one is drawn [px]
  double scale_ = 1.0;      // [px/m]
  double width_ = 0.0;      // of the picture [px]
  double height_ = 0.0;     // of the picture [px]
  double map_width_ = 0.0;  // of one panel, if there are several [px]
  double map_height_ = 0.0;
  double text_size_ = 15.0;  // [px]
  bool one_row_ = false;     // of the footer, with the scale bar in it
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

template <class Chosen>
void Canvas::fillCells(const GridGeometry& geometry, const Colour& colour, Chosen&& chosen) {
  cairo_save(context_.get());
  cairo_rectangle(context_.get(), corner_.x(), corner_.y(), map_width_, map_height_);
  cairo_clip(context_.get());                                 // no cell covers the border
  cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);  // no seams between cells
  setColour(colour);
  Cell c;
  for (c.y = 0; c.y < geometry.height(); ++c.y) {
    std::int64_t first = 0;  // of the cells that are filled in one piece
    for (c.x = 0; c.x <= geometry.width(); ++c.x) {
      if (c.x == geometry.width() || !chosen(c)) {
        if (first < c.x) {
          addCells(geometry, {first, c.y}, c.x - first);
        }
        first = c.x + 1;
      }
    }
  }
  cairo_fill(context_.get());
  cairo_restore(context_.get());
}

}  // namespace sfw
