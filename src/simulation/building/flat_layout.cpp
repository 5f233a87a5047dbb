#include <algorithm>

#include "simulation/building/floor_layout.h"

namespace sfw {
namespace {

std::vector<RoomChoice> deepRow() {
  return {{RoomKind::kBedroom, 270, 420, 6, 9},
          {RoomKind::kStudy, 230, 320, 2, 1},
          {RoomKind::kBath, 190, 250, 2, 1}};
}

std::vector<RoomChoice> shallowRow() {
  return {{RoomKind::kStorage, 130, 220, 2, 2},
          {RoomKind::kBath, 180, 280, 4, 2},
          {RoomKind::kToilet, 100, 130, 2, 1},
          {RoomKind::kKitchen, 230, 340, 3, 1},
          {RoomKind::kStudy, 240, 330, 2, 2}};
}

/// The second row of a large flat, too deep for toilets.
std::vector<RoomChoice> mixedRow() {
  return {{RoomKind::kStudy, 240, 340, 3, 3},
          {RoomKind::kBath, 190, 260, 3, 2},
          {RoomKind::kKitchen, 260, 360, 2, 1},
          {RoomKind::kBedroom, 280, 400, 3, 9}};
}

std::vector<RoomChoice> choicesFor(int depth, bool main_row) {
  constexpr int kShallow = 290;
  if (depth < kShallow) {
    return shallowRow();
  }
  return main_row ? deepRow() : mixedRow();
}

/// Rooms along a corridor, each with its door. A room too deep for a bath is divided. A toilet or
/// cupboard is at the corridor, and behind it is a bath for the next bedroom.
std::vector<std::size_t> addRooms(std::size_t corridor, const Rect& rect, Side corridor_side,
                                  bool main_row, FloorLayout& layout) {
  constexpr int kDeepBath = 340;
  PortableRandom& random = layout.random();
  const bool level = corridor_side == Side::kBottom || corridor_side == Side::kTop;
  const int depth = level ? rect.depth() : rect.width();
  std::vector<std::size_t> row =
      layout.addRow(rect, level ? Axis::kX : Axis::kY, choicesFor(depth, main_row));
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (layout.rooms()[row[i]].kind != RoomKind::kBath || depth < kDeepBath || row.size() == 1) {
      layout.addDoor(corridor, row[i]);
      continue;
    }
    const std::size_t front =
        layout.cutOff(row[i], corridor_side, random.between(130, 160),
                      random.chance(60) ? RoomKind::kToilet : RoomKind::kStorage);
    layout.addDoor(corridor, front);
    layout.addDoor(row[i], i > 0 ? row[i - 1] : row[i + 1]);
  }
  return row;
}

/// One wing: rooms on both sides of a hall that ends in a living room as deep as the house.
struct StraightFlat {
  int length, depth;  // inside the outer walls
  int wall;           // of the hall
  int hall_bottom, hall_top;
  int living;  // its width
  int notch;   // missing from the lower row at the hall's other end
};

StraightFlat chooseBar(int area_m2, PortableRandom& random) {
  struct Depths {
    int below_m2, least, largest;
  };
  constexpr Depths kDepths[] = {
      {45, 480, 560}, {70, 600, 700}, {110, 720, 850}, {170, 850, 1000}, {401, 950, 1100}};
  const Depths& depths = *std::find_if(std::begin(kDepths), std::end(kDepths),
                                       [&](const Depths& d) { return area_m2 < d.below_m2; });
  StraightFlat bar{};
  bar.depth = random.between(depths.least, depths.largest);
  bar.wall = random.between(15, 20);
  const int hall = area_m2 < 70 ? random.between(110, 125) : random.between(125, 150);
  const int rest = bar.depth - hall - 2 * bar.wall;
  const int lower = std::max(150, rest * random.between(36, 46) / 100);
  bar.hall_bottom = lower + bar.wall;
  bar.hall_top = bar.hall_bottom + hall;
  bar.notch = area_m2 > 60 && random.chance(35) ? random.between(200, 320) : 0;
  bar.length = (area_m2 * kToCm2 + bar.notch * bar.hall_bottom) / bar.depth;
  bar.living = area_m2 < 45   ? bar.length * random.between(52, 60) / 100
               : area_m2 < 70 ? bar.length * random.between(42, 50) / 100
                              : std::min(random.between(380, 520), bar.length * 45 / 100);
  return bar;
}

/// Cuts a kitchen off a large living room, clear of where the hall enters.
void addKitchen(const StraightFlat& bar, std::size_t living, FloorLayout& layout) {
  constexpr int kLargeLiving = 26 * kToCm2;
  constexpr int kLeastKitchen = 210;
  PortableRandom& random = layout.random();
  if (bar.living * bar.depth < kLargeLiving || !random.chance(65)) {
    return;
  }
  const bool low = random.chance(50);
  const int most = (low ? bar.hall_bottom : bar.depth - bar.hall_top) - layout.partition();
  const int depth = std::min(random.between(240, 330), most);
  if (depth < kLeastKitchen) {
    return;
  }
  const std::size_t kitchen =
      layout.cutOff(living, low ? Side::kBottom : Side::kTop, depth, RoomKind::kKitchen);
  layout.connect(living, kitchen, random.chance(60) ? random.between(120, 220) : 85);
}

void drawBar(int area_m2, FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const StraightFlat bar = chooseBar(area_m2, random);
  const int hall_end = bar.length - bar.living - bar.wall;
  layout.addInside({0, bar.hall_bottom, bar.length, bar.depth});
  layout.addInside({bar.notch, 0, bar.length, bar.hall_bottom});
  const std::size_t hall =
      layout.addRoom(RoomKind::kCorridor, {0, bar.hall_bottom, hall_end, bar.hall_top});
  const std::size_t living =
      layout.addRoom(RoomKind::kLiving, {hall_end + bar.wall, 0, bar.length, bar.depth});
  addKitchen(bar, living, layout);
  layout.connect(hall, living, random.chance(60) ? 130 : 85);
  addRooms(hall, {bar.notch, 0, hall_end, bar.hall_bottom - bar.wall}, Side::kTop, false, layout);
  const std::vector<std::size_t> upper = addRooms(
      hall, {0, bar.hall_top + bar.wall, hall_end, bar.depth}, Side::kBottom, true, layout);
  if (random.chance(30)) {
    layout.connect(upper.back(), living, random.chance(50) ? 160 : 85);
  }
}

/// Two wings at a right angle. Their halls meet at a living room in the outer corner.
struct LShapedFlat {
  int wall, hall;
  int wing_depth;             // of the first wing, that lies along x
  int hall_bottom, hall_top;  // of its hall
  int wing_left;              // of the second wing
  int hall_left, hall_right;  // of its hall
  int length, height;         // of both wings together
};

LShapedFlat chooseEll(int area_m2, PortableRandom& random) {
  LShapedFlat ell{};
  ell.wall = random.between(15, 20);
  ell.hall = random.between(130, 160);
  ell.hall_bottom = random.between(320, 420) + ell.wall;
  ell.hall_top = ell.hall_bottom + ell.hall;
  ell.wing_depth = ell.hall_top + ell.wall + random.between(240, 400);
  const int left_row = random.between(240, 400);
  const int right_row = random.between(340, 440);
  const int wing_width = left_row + ell.wall + ell.hall + ell.wall + right_row;
  const int area = area_m2 * kToCm2;
  // Long enough that both wings are visible.
  ell.length = std::max(area * random.between(50, 60) / 100 / ell.wing_depth, wing_width + 250);
  ell.wing_left = ell.length - wing_width;
  ell.hall_left = ell.wing_left + left_row + ell.wall;
  ell.hall_right = ell.hall_left + ell.hall;
  ell.height = ell.wing_depth + (area - ell.length * ell.wing_depth) / wing_width;
  return ell;
}

void drawEll(int area_m2, FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const LShapedFlat ell = chooseEll(area_m2, random);
  layout.addInside({0, 0, ell.length, ell.wing_depth});
  layout.addInside({ell.wing_left, ell.wing_depth, ell.length, ell.height});
  // The second hall ends at a room across its wing, or at a window.
  const int across = random.chance(60) ? random.between(320, 400) : 0;
  const int wing_top = across > 0 ? ell.height - across - ell.wall : ell.height;
  const int living_top = ell.hall_top + random.between(0, 60);
  const int east = ell.hall_right + ell.wall;
  const std::size_t hall =
      layout.addRoom(RoomKind::kCorridor, {0, ell.hall_bottom, ell.hall_right, ell.hall_top});
  const std::size_t second = layout.addRoom(
      RoomKind::kCorridor, {ell.hall_left, ell.hall_bottom, ell.hall_right, wing_top});
  layout.join(hall, second);
  const std::size_t living = layout.addRoom(RoomKind::kLiving, {east, 0, ell.length, living_top});
  layout.connect(hall, living, 130);
  addRooms(hall, {0, 0, ell.hall_right, ell.hall_bottom - ell.wall}, Side::kTop, true, layout);
  addRooms(hall, {0, ell.hall_top + ell.wall, ell.hall_left - ell.wall, ell.wing_depth},
           Side::kBottom, false, layout);
  addRooms(second, {ell.wing_left, ell.wing_depth + ell.wall, ell.hall_left - ell.wall, wing_top},
           Side::kRight, false, layout);
  addRooms(second, {east, living_top + ell.wall, ell.length, wing_top}, Side::kLeft, true, layout);
  if (across > 0) {
    const std::size_t end = layout.addRoom(
        RoomKind::kBedroom, {ell.wing_left, wing_top + ell.wall, ell.length, ell.height});
    layout.addDoor(second, end);
  }
}

}  // namespace

void drawFlat(int area_m2, FloorLayout& layout) {
  constexpr int kLeastEll = 170;
  if (area_m2 >= kLeastEll && layout.random().chance(area_m2 > 230 ? 85 : 50)) {
    drawEll(area_m2, layout);
  } else {
    drawBar(area_m2, layout);
  }
}

}  // namespace sfw
