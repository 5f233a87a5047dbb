#include "simulation/building/floor_layout.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace sfw {
namespace {

constexpr int kThickestWall = 40;   // between rooms that a door may join [cm]
constexpr int kNarrowestDoor = 80;  // [cm]
constexpr int kDoorFrame = 10;      // of wall on each side of a door [cm]

/// The wall between two rectangles that face each other, if there is one.
std::optional<Rect> wallBetween(const Rect& a, const Rect& b) {
  const Rect gap{std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::max(a.left, b.left),
                 std::min(a.top, b.top)};
  if (gap.width() >= 0 && gap.width() <= kThickestWall && gap.depth() > 0) {
    return gap;
  }
  return std::nullopt;
}

/// A room's width in a row that is being filled.
struct Share {
  RoomChoice choice;
  int width;
};

/// Draws one of the choices that the row may still take; the first if none is left.
RoomChoice draw(const std::vector<RoomChoice>& choices, const std::vector<Share>& row,
                PortableRandom& random) {
  std::vector<int> weights;
  for (const RoomChoice& choice : choices) {
    const auto used = std::count_if(row.begin(), row.end(), [&](const Share& share) {
      return share.choice.kind == choice.kind;
    });
    weights.push_back(used < choice.most ? choice.weight : 0);
  }
  int lot = random.between(1, std::accumulate(weights.begin(), weights.end(), 0));
  for (std::size_t i = 0; i < choices.size(); ++i) {
    lot -= weights[i];
    if (lot <= 0 && weights[i] > 0) {
      return choices[i];
    }
  }
  return choices.front();
}

/// Draws rooms until their widths and walls fill `length` as well as possible.
std::vector<Share> fill(int length, int partition, const std::vector<RoomChoice>& choices,
                        PortableRandom& random) {
  std::vector<Share> row;
  int used = -partition;
  while (true) {
    const RoomChoice choice = draw(choices, row, random);
    const int width = random.between(choice.least_width, choice.largest_width);
    // `better`: the excess with the last room is smaller than the gap without it. Then squeezing is
    // better.
    const bool fits = used + partition + width <= length;
    const bool better = used + partition + width - length < length - used;
    if (!fits && !better && !row.empty()) {
      return row;
    }
    row.push_back({choice, width});
    used += partition + width;
    if (!fits) {
      return row;
    }
  }
}

/// Stretches or squeezes all rooms equally, so that they fill `length` to the centimetre. No room
/// becomes narrower than 90 % of its least width. If that is impossible, the row loses its
/// narrowest room.
void fit(int length, int partition, std::vector<Share>& row) {
  while (true) {
    const int net = length - partition * (static_cast<int>(row.size()) - 1);
    int sum = 0;
    for (const Share& share : row) {
      sum += share.width;
    }
    sum = std::max(sum, 1);  // of no row, too
    bool too_narrow = false;
    for (const Share& share : row) {
      too_narrow = too_narrow || share.width * net / sum < share.choice.least_width * 9 / 10;
    }
    if (too_narrow && row.size() > 1) {
      row.erase(std::min_element(row.begin(), row.end(),
                                 [](const Share& a, const Share& b) { return a.width < b.width; }));
      continue;
    }
    int left = net;
    for (Share& share : row) {
      share.width = share.width * net / sum;
      left -= share.width;
    }
    row.back().width += left;
    return;
  }
}

}  // namespace

int PortableRandom::between(int low, int high) {
  if (high <= low) {
    return low;
  }
  const auto values = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>((engine_() >> 32) * values >> 32);
}

std::size_t FloorLayout::addRoom(RoomKind kind, const Rect& rect) {
  rooms_.push_back({kind, rect});
  return rooms_.size() - 1;
}

std::vector<std::size_t> FloorLayout::addRow(const Rect& rect, Axis axis,
                                             const std::vector<RoomChoice>& choices) {
  std::vector<std::size_t> numbers;
  const Rect along = axis == Axis::kX ? rect : rect.transposed();
  std::vector<Share> row = fill(along.width(), partition_, choices, random_);
  fit(along.width(), partition_, row);
  int at = along.left;
  for (const Share& share : row) {
    const Rect room{at, along.bottom, at + share.width, along.top};
    numbers.push_back(addRoom(share.choice.kind, axis == Axis::kX ? room : room.transposed()));
    at += share.width + partition_;
  }
  return numbers;
}

std::size_t FloorLayout::cutOff(std::size_t room, Side side, int slice_cm, RoomKind kind) {
  Rect& rest = rooms_[room].rect;
  Rect slice = rest;
  const int step = slice_cm + partition_;
  switch (side) {
    case Side::kLeft:
      slice.right = slice.left + slice_cm;
      rest.left += step;
      break;
    case Side::kBottom:
      slice.top = slice.bottom + slice_cm;
      rest.bottom += step;
      break;
    case Side::kRight:
      slice.left = slice.right - slice_cm;
      rest.right -= step;
      break;
    case Side::kTop:
      slice.bottom = slice.top - slice_cm;
      rest.top -= step;
      break;
  }
  return addRoom(kind, slice);
}

bool FloorLayout::connect(std::size_t a, std::size_t b, int width_cm) {
  std::optional<Rect> wall = wallBetween(rooms_[a].rect, rooms_[b].rect);
  const bool upright = wall.has_value();
  if (!wall) {
    wall = wallBetween(rooms_[a].rect.transposed(), rooms_[b].rect.transposed());
  }
  if (!wall) {
    return false;
  }
  const int room = wall->depth() - 2 * kDoorFrame;
  if (room < kNarrowestDoor) {
    return false;
  }
  const int width = std::min(width_cm, room);
  // Doors are near a corner, to leave wall for furniture. Openings are anywhere.
  const int spare = room - width;
  int shift = random_.between(0, width_cm > 100 ? spare : std::min(spare, 40));
  shift = random_.chance(50) ? shift : spare - shift;
  const int from = wall->bottom + kDoorFrame + shift;
  const Rect hole{wall->left, from, wall->right, from + width};
  holes_.push_back(upright ? hole : hole.transposed());
  connections_.emplace_back(a, b);
  return true;
}

std::vector<std::size_t> FloorLayout::reachable() const {
  std::vector<std::size_t> open{0};
  std::vector<bool> seen(rooms_.size(), false);
  seen[0] = true;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const auto& [a, b] : connections_) {
      const std::size_t other = a == open[i] ? b : a;
      if ((a == open[i] || b == open[i]) && !seen[other]) {
        seen[other] = true;
        open.push_back(other);
      }
    }
  }
  std::sort(open.begin(), open.end());
  return open;
}

void FloorLayout::reachAll() {
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<std::size_t> reached = reachable();
    for (std::size_t room = 0; room < rooms_.size() && !changed; ++room) {
      if (std::binary_search(reached.begin(), reached.end(), room)) {
        continue;
      }
      for (std::size_t i = 0; i < reached.size() && !changed; ++i) {
        changed = addDoor(reached[i], room);
      }
    }
  }
}

}  // namespace sfw
