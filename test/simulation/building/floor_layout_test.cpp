#include "simulation/building/floor_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sfw {
namespace {

/// The rooms that a seed draws, not turned.
std::vector<LayoutRoom> flatOf(int area_m2, std::uint64_t seed) {
  PortableRandom random(seed);
  FloorLayout layout(random, random.between(10, 13));
  drawFlat(area_m2, layout);
  layout.reachAll();
  return layout.rooms();
}

std::vector<LayoutRoom> officeOf(int area_m2, std::uint64_t seed) {
  PortableRandom random(seed);
  FloorLayout layout(random, random.between(10, 13));
  drawOffice(area_m2, layout);
  layout.reachAll();
  return layout.rooms();
}

void expectSensible(const LayoutRoom& room, std::uint64_t seed) {
  const int narrow_cm = std::min(room.rect.width(), room.rect.depth());
  const double area_m2 = 1e-4 * room.rect.width() * room.rect.depth();
  EXPECT_GE(narrow_cm, 85) << "seed " << seed;
  EXPECT_GE(area_m2, 1.2) << "seed " << seed;
  const bool to_live_in = room.kind == RoomKind::kBedroom || room.kind == RoomKind::kLiving ||
                          room.kind == RoomKind::kOffice || room.kind == RoomKind::kMeeting;
  if (to_live_in) {
    EXPECT_GE(narrow_cm, 210) << "seed " << seed;
    EXPECT_GE(area_m2, 6.0) << "seed " << seed;
  }
}

TEST(FloorLayout, RoomsHaveSensibleSizes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const int area_m2 = 30 + static_cast<int>(seed * 37 % 371);
    for (const std::vector<LayoutRoom>& rooms : {flatOf(area_m2, seed), officeOf(area_m2, seed)}) {
      EXPECT_FALSE(rooms.empty()) << "seed " << seed;
      for (const LayoutRoom& room : rooms) {
        expectSensible(room, seed);
      }
    }
  }
}

TEST(FloorLayout, AStudioHasFourRooms) {
  const std::vector<LayoutRoom> rooms = flatOf(32, 5);
  std::vector<RoomKind> kinds;
  std::vector<std::pair<int, int>> sizes_cm;
  for (const LayoutRoom& room : rooms) {
    kinds.push_back(room.kind);
    sizes_cm.emplace_back(room.rect.width(), room.rect.depth());
  }
  EXPECT_EQ(kinds, (std::vector<RoomKind>{RoomKind::kCorridor, RoomKind::kLiving,
                                          RoomKind::kKitchen, RoomKind::kBath}));
  EXPECT_EQ(sizes_cm,
            (std::vector<std::pair<int, int>>{{302, 120}, {344, 483}, {302, 150}, {302, 181}}));
}

}  // namespace
}  // namespace sfw
