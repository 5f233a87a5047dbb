#include "output/wall_files.h"

#include <algorithm>
#include <cmath>

#include "files/round_length.h"
#include "files/text.h"
#include "files/yaml.h"
#include "grid/contour.h"

namespace sfw {
namespace {

/// A number rounded at the third place, without the sign of -0.
std::string thousandths(double value) {
  return exactText(std::round(1000.0 * value) / 1000.0 + 0.0);
}

/// The corners of a closed way from cell to cell.
std::vector<Position> cornersOf(const std::vector<Cell>& way, const GridGeometry& geometry) {
  std::vector<Position> corners;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Cell before = way[(i + way.size() - 1) % way.size()];
    const Cell after = way[(i + 1) % way.size()];
    const Cell straight_on{2 * way[i].x - before.x, 2 * way[i].y - before.y};
    if (after != straight_on) {
      corners.push_back(geometry.centre(way[i]));
    }
  }
  return corners;
}

std::vector<std::vector<Position>> freeOutlines(const BeliefMap& belief) {
  constexpr std::size_t kLeastCorners = 3;  // fewer enclose no area
  Mask free(belief.geometry());
  free.cells = belief.converted([](const CellBelief& cell) {
    return static_cast<std::uint8_t>(cell.state == CellState::kFree ? 1 : 0);
  });
  std::vector<std::vector<Position>> outlines;
  for (const std::vector<Cell>& way : contours(free)) {
    std::vector<Position> corners = cornersOf(way, belief.geometry());
    if (corners.size() >= kLeastCorners) {
      outlines.push_back(std::move(corners));
    }
  }
  return outlines;
}

// ---- SVG ----

constexpr double kMmPerMetre = 20.0;  // of paper: a scale of 1:50
constexpr double kMarginMm = 10.0;
constexpr double kFooterMm = 15.0;  // for the scale bar

/// A group that Inkscape shows as a layer. Its coordinates are metres of the map frame.
std::string svgLayer(const char* id, const Box& area, const std::string& style,
                     const std::string& content) {
  return formatted(
             "<g id=\"%s\" inkscape:groupmode=\"layer\" inkscape:label=\"%s\"\n"
             "   transform=\"matrix(%g 0 0 %g ",
             id, id, kMmPerMetre, -kMmPerMetre) +
         thousandths(kMarginMm - area.min().x() * kMmPerMetre) + " " +
         thousandths(kMarginMm + area.max().y() * kMmPerMetre) + ")\"\n   " + style + ">\n" +
         content + "</g>\n";
}

std::string svgOutlines(const std::vector<std::vector<Position>>& outlines) {
  if (outlines.empty()) {
    return "";
  }
  std::string path = "<path fill-rule=\"evenodd\" d=\"";
  for (const std::vector<Position>& outline : outlines) {
    char command = 'M';
    for (const Position& corner : outline) {
      path += command + thousandths(corner.x()) + " " + thousandths(corner.y());
      command = 'L';
    }
    path += "Z\n";
  }
  return path + "\"/>\n";
}

/// The outer walls, or all the others.
std::string svgWalls(const std::vector<WallSegment>& walls, bool outer) {
  std::string lines;
  for (const WallSegment& wall : walls) {
    if (wall.is_outer != outer) {
      continue;
    }
    lines += "<line x1=\"" + thousandths(wall.from.x()) + "\" y1=\"" + thousandths(wall.from.y()) +
             "\" x2=\"" + thousandths(wall.to.x()) + "\" y2=\"" + thousandths(wall.to.y()) +
             "\" stroke-opacity=\"" + thousandths(wall.confidence) + "\"/>\n";
  }
  return lines;
}

/// A bar of at most a third of the width, in the footer.
std::string svgScaleBar(double width_mm, double top_mm) {
  const double metres = roundLength(width_mm / (3.0 * kMmPerMetre));
  return formatted(
      "<g id=\"scale\">\n<rect x=\"%g\" y=\"%.3f\" width=\"%g\" height=\"1.5\"/>\n"
      "<text x=\"%g\" y=\"%.3f\" font-family=\"sans-serif\" font-size=\"5\">%g m</text>\n</g>\n",
      kMarginMm, top_mm + 8.0, metres * kMmPerMetre, kMarginMm, top_mm + 6.0, metres);
}

// ---- DXF ----

/// Pairs of a group code and a value, each on a line of its own.
class DxfText {
 public:
  DxfText& add(int code, const std::string& value) {
    text_ += formatted("%3d\n", code) + value + "\n";
    return *this;
  }
  DxfText& add(int code, int value) { return add(code, std::to_string(value)); }

  /// A point of the floor; its codes are `code` and, for y and z, 10 and 20 more.
  DxfText& add(int code, const Position& point) {
    constexpr int kNextCoordinate = 10;
    return add(code, thousandths(point.x()))
        .add(code + kNextCoordinate, thousandths(point.y()))
        .add(code + 2 * kNextCoordinate, "0.0");
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void addHeader(const Box& area, DxfText& dxf) {
  constexpr int kMetres = 6;
  dxf.add(0, "SECTION").add(2, "HEADER").add(9, "$ACADVER").add(1, "AC1009");
  dxf.add(9, "$INSUNITS").add(70, kMetres);
  dxf.add(9, "$EXTMIN").add(10, area.min()).add(9, "$EXTMAX").add(10, area.max());
  dxf.add(0, "ENDSEC");
}

void addLayer(const char* name, int colour, DxfText& dxf) {
  dxf.add(0, "LAYER").add(2, name).add(70, 0).add(62, colour).add(6, "CONTINUOUS");
}

void addTables(DxfText& dxf) {
  constexpr int kRed = 1;
  constexpr int kPaleRed = 11;
  constexpr int kGrey = 8;
  dxf.add(0, "SECTION").add(2, "TABLES");
  dxf.add(0, "TABLE").add(2, "LTYPE").add(70, 1);
  dxf.add(0, "LTYPE").add(2, "CONTINUOUS").add(70, 0).add(3, "Solid line");
  dxf.add(72, static_cast<int>('A')).add(73, 0).add(40, "0.0").add(0, "ENDTAB");
  dxf.add(0, "TABLE").add(2, "LAYER").add(70, 3);
  addLayer("WALLS", kRed, dxf);
  addLayer("OUTER_WALLS", kPaleRed, dxf);
  addLayer("FREE", kGrey, dxf);
  dxf.add(0, "ENDTAB").add(0, "ENDSEC");
}

void addOutline(const std::vector<Position>& outline, DxfText& dxf) {
  constexpr int kClosed = 1;
  dxf.add(0, "POLYLINE").add(8, "FREE").add(66, 1).add(10, Position(0.0, 0.0)).add(70, kClosed);
  for (const Position& corner : outline) {
    dxf.add(0, "VERTEX").add(8, "FREE").add(10, corner);
  }
  dxf.add(0, "SEQEND").add(8, "FREE");
}

}  // namespace

FloorDrawing floorDrawing(const Snapshot& snapshot) {
  FloorDrawing drawing{snapshot.walls, freeOutlines(snapshot.belief)};
  for (const std::vector<Position>& outline : drawing.free_outlines) {
    for (const Position& corner : outline) {
      drawing.area.extend(corner);
    }
  }
  for (const WallSegment& wall : drawing.walls) {
    drawing.area.extend(wall.from);
    drawing.area.extend(wall.to);
  }
  if (drawing.area.isEmpty()) {
    drawing.area = snapshot.belief.geometry().box();
  }
  return drawing;
}

std::string wallsYaml(const std::vector<WallSegment>& walls) {
  constexpr int kFormat = 1;
  std::string yaml = formatted("format: %d\nframe: map\nunit: m\nwalls:", kFormat);
  yaml += walls.empty() ? " []\n" : "\n";
  for (const WallSegment& wall : walls) {
    yaml += "  - {from: [" + thousandths(wall.from.x()) + ", " + thousandths(wall.from.y()) +
            "], to: [" + thousandths(wall.to.x()) + ", " + thousandths(wall.to.y()) +
            "], confidence: " + thousandths(wall.confidence) +
            ", outer: " + (wall.is_outer ? "true" : "false") + "}\n";
  }
  return yaml;
}

std::vector<WallSegment> readWalls(const std::string& file) {
  return readYaml(file, [](const YAML::Node& node) {
    constexpr double kHalfStep = 0.0005;
    std::vector<WallSegment> walls;
    if (!node.IsMap() || !node["walls"].IsSequence()) {
      throw InputError("it holds no list `walls`; make it with sfw map");
    }
    for (const YAML::Node& row : node["walls"]) {
      try {
        WallSegment wall;
        wall.from = {row["from"][0].as<double>(), row["from"][1].as<double>()};
        wall.to = {row["to"][0].as<double>(), row["to"][1].as<double>()};
        wall.confidence = row["confidence"].as<double>();
        wall.is_outer = row["outer"].as<bool>();
        if (!wall.from.allFinite() || !wall.to.allFinite() || !(wall.confidence >= 0.0) ||
            !(wall.confidence <= 1.0)) {
          throw InputError("its numbers are out of range");
        }
        // The file rounds to thousandths.
        wall.confidence = std::clamp(wall.confidence, kHalfStep, 1.0 - kHalfStep);
        walls.push_back(wall);
      } catch (const std::exception& error) {
        throw InputError("wall " + std::to_string(walls.size() + 1) +
                         " needs {from: [x, y], to: [x, y], confidence, outer}: " + error.what());
      }
    }
    return walls;
  });
}

std::string wallsSvg(const FloorDrawing& drawing) {
  const Position size = drawing.area.sizes() * kMmPerMetre;
  const double width = size.x() + 2.0 * kMarginMm;
  const double height = size.y() + 2.0 * kMarginMm + kFooterMm;
  return formatted(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\"\n"
             "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
             "     width=\"%.3fmm\" height=\"%.3fmm\" viewBox=\"0 0 %.3f %.3f\">\n",
             width, height, width, height) +
         svgLayer("free", drawing.area, "fill=\"#eef3f7\" stroke=\"#9aa5b1\" stroke-width=\"0.02\"",
                  svgOutlines(drawing.free_outlines)) +
         svgLayer("walls", drawing.area, "stroke=\"#8b0000\" stroke-width=\"0.1\"",
                  svgWalls(drawing.walls, false)) +
         svgLayer("outer_walls", drawing.area,
                  "stroke=\"#8b0000\" stroke-width=\"0.05\" stroke-dasharray=\"0.2 0.1\"",
                  svgWalls(drawing.walls, true)) +
         svgScaleBar(width, height - kFooterMm) + "</svg>\n";
}

std::string wallsDxf(const FloorDrawing& drawing) {
  DxfText dxf;
  addHeader(drawing.area, dxf);
  addTables(dxf);
  dxf.add(0, "SECTION").add(2, "ENTITIES");
  for (const std::vector<Position>& outline : drawing.free_outlines) {
    addOutline(outline, dxf);
  }
  for (const WallSegment& wall : drawing.walls) {
    dxf.add(0, "LINE")
        .add(8, wall.is_outer ? "OUTER_WALLS" : "WALLS")
        .add(10, wall.from)
        .add(11, wall.to);
  }
  dxf.add(0, "ENDSEC").add(0, "EOF");
  return dxf.text();
}

}  // namespace sfw
