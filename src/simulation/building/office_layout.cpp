#include <algorithm>

#include "simulation/building/floor_layout.h"

namespace sfw {
namespace {

/// Rooms at a façade.
std::vector<RoomChoice> facadeRow() {
  return {{RoomKind::kOffice, 250, 400, 8, 99},
          {RoomKind::kMeeting, 420, 600, 2, 1},
          {RoomKind::kOpenPlan, 650, 950, 2, 1},
          {RoomKind::kToilet, 320, 380, 2, 1},
          {RoomKind::kKitchen, 240, 340, 1, 1}};
}

/// Rooms without daylight, between two corridors.
std::vector<RoomChoice> coreRow() {
  return {{RoomKind::kStorage, 180, 320, 3, 3},
          {RoomKind::kToilet, 320, 400, 3, 2},
          {RoomKind::kMeeting, 380, 560, 3, 2},
          {RoomKind::kKitchen, 240, 340, 2, 1}};
}

/// Turns a room into toilets: a lobby at the corridor and two toilets behind it.
void divideToilets(std::size_t corridor, std::size_t room, Side corridor_side,
                   FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const std::size_t lobby =
      layout.cutOff(room, corridor_side, random.between(140, 170), RoomKind::kStorage);
  const bool level = corridor_side == Side::kBottom || corridor_side == Side::kTop;
  const Rect rest = layout.rooms()[room].rect;
  const int half = ((level ? rest.width() : rest.depth()) - layout.partition()) / 2;
  const std::size_t second =
      layout.cutOff(room, level ? Side::kLeft : Side::kBottom, half, RoomKind::kToilet);
  layout.addDoor(corridor, lobby);
  layout.addDoor(lobby, room);
  layout.addDoor(lobby, second);
}

/// Rooms along a corridor with their doors; an open-plan office has an opening instead, and
/// neighbours are sometimes joined.
void addRooms(std::size_t corridor, const Rect& rect, Side corridor_side,
              const std::vector<RoomChoice>& choices, FloorLayout& layout) {
  constexpr int kDeepToilets = 310;
  PortableRandom& random = layout.random();
  const std::vector<std::size_t> row = layout.addRow(rect, Axis::kX, choices);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const RoomKind kind = layout.rooms()[row[i]].kind;
    if (kind == RoomKind::kToilet && rect.depth() >= kDeepToilets) {
      divideToilets(corridor, row[i], corridor_side, layout);
      continue;
    }
    layout.connect(corridor, row[i],
                   kind == RoomKind::kOpenPlan ? random.between(180, 300) : random.between(80, 90));
    const bool offices =
        i > 0 && kind == RoomKind::kOffice && layout.rooms()[row[i - 1]].kind == RoomKind::kOffice;
    if (offices && random.chance(15)) {
      layout.addDoor(row[i - 1], row[i]);
    }
  }
}

/// A reception along one façade and offices behind it.
void drawSingleRow(int area_m2, FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const int wall = random.between(12, 20);
  const int reception = random.between(170, 240);
  const int offices = random.between(360, 460);
  const int depth = reception + wall + offices;
  const int length = area_m2 * kToCm2 / depth;
  layout.addInside({0, 0, length, depth});
  const std::size_t corridor = layout.addRoom(RoomKind::kCorridor, {0, 0, length, reception});
  addRooms(corridor, {0, reception + wall, length, depth}, Side::kBottom, facadeRow(), layout);
}

/// Offices on both sides of a corridor that ends in a room across the whole wing.
void drawDoubleRow(int area_m2, FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const int wall = random.between(12, 20);
  const int hall_bottom = random.between(380, 500) + wall;
  const int hall_top = hall_bottom + random.between(160, 200);
  const int depth = hall_top + wall + random.between(420, 540);
  const int length = area_m2 * kToCm2 / depth;
  const int end_room = length > 1100 && random.chance(70) ? random.between(450, 750) : 0;
  const int hall_end = end_room > 0 ? length - end_room - wall : length;
  layout.addInside({0, 0, length, depth});
  const std::size_t corridor =
      layout.addRoom(RoomKind::kCorridor, {0, hall_bottom, hall_end, hall_top});
  addRooms(corridor, {0, 0, hall_end, hall_bottom - wall}, Side::kTop, facadeRow(), layout);
  addRooms(corridor, {0, hall_top + wall, hall_end, depth}, Side::kBottom, facadeRow(), layout);
  if (end_room > 0) {
    const std::size_t room =
        layout.addRoom(RoomKind::kOpenPlan, {hall_end + wall, 0, length, depth});
    layout.connect(corridor, room, random.chance(50) ? 180 : 90);
  }
}

/// Heights at which the strips of a ring-shaped floor begin and end.
struct Ring {
  int wall, hall;
  int first_bottom, first_top;    // corridor
  int second_bottom, second_top;  // corridor
  int depth;
};

Ring chooseRing(PortableRandom& random) {
  Ring ring{};
  ring.wall = random.between(12, 20);
  ring.hall = random.between(150, 180);
  ring.first_bottom = random.between(400, 500) + ring.wall;
  ring.first_top = ring.first_bottom + ring.hall;
  ring.second_bottom = ring.first_top + ring.wall + random.between(320, 450) + ring.wall;
  ring.second_top = ring.second_bottom + ring.hall;
  ring.depth = ring.second_top + ring.wall + random.between(400, 500);
  return ring;
}

/// A corridor around a core of rooms without daylight, offices around the corridor.
void drawRing(int area_m2, FloorLayout& layout) {
  PortableRandom& random = layout.random();
  const Ring ring = chooseRing(random);
  const int length = area_m2 * kToCm2 / ring.depth;
  const int end_room = length > 1900 ? random.between(450, 600) : 0;
  const int end = end_room > 0 ? length - end_room - ring.wall : length;
  layout.addInside({0, 0, length, ring.depth});
  const auto hall = [&](const Rect& rect) { return layout.addRoom(RoomKind::kCorridor, rect); };
  const std::size_t first = hall({0, ring.first_bottom, end, ring.first_top});
  const std::size_t second = hall({0, ring.second_bottom, end, ring.second_top});
  const std::size_t west = hall({0, ring.first_bottom, ring.hall, ring.second_top});
  const std::size_t east = hall({end - ring.hall, ring.first_bottom, end, ring.second_top});
  for (const std::size_t cross : {west, east}) {
    layout.join(first, cross);
    layout.join(cross, second);
  }
  addRooms(first, {0, 0, end, ring.first_bottom - ring.wall}, Side::kTop, facadeRow(), layout);
  addRooms(second, {0, ring.second_top + ring.wall, end, ring.depth}, Side::kBottom, facadeRow(),
           layout);
  const bool from_first = random.chance(50);
  addRooms(from_first ? first : second,
           {ring.hall + ring.wall, ring.first_top + ring.wall, end - ring.hall - ring.wall,
            ring.second_bottom - ring.wall},
           from_first ? Side::kBottom : Side::kTop, coreRow(), layout);
  if (end_room > 0) {
    const std::size_t room =
        layout.addRoom(RoomKind::kOpenPlan, {end + ring.wall, 0, length, ring.depth});
    layout.connect(east, room, random.between(90, 200));
  }
}

}  // namespace

void drawOffice(int area_m2, FloorLayout& layout) {
  constexpr int kLeastDoubleRow = 75;
  constexpr int kLeastRing = 230;
  if (area_m2 < kLeastDoubleRow) {
    drawSingleRow(area_m2, layout);
  } else if (area_m2 >= kLeastRing && layout.random().chance(60)) {
    drawRing(area_m2, layout);
  } else {
    drawDoubleRow(area_m2, layout);
  }
}

}  // namespace sfw
