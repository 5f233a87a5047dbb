#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace sfw {

/// A rectangle in whole centimetres of the building's own frame.
struct Rect {
  int left = 0, bottom = 0, right = 0, top = 0;

  int width() const { return right - left; }
  int depth() const { return top - bottom; }
  /// The rectangle mirrored at the diagonal.
  Rect transposed() const { return {bottom, left, top, right}; }
};

/// The use of a room.
enum class RoomKind {
  kLiving,
  kKitchen,
  kBedroom,
  kStudy,
  kBath,
  kToilet,
  kStorage,  // of flats, but offices too
  kCorridor,
  kOffice,
  kOpenPlan,
  kMeeting
};

/// A room, or a stretch of corridor.
struct LayoutRoom {
  RoomKind kind;
  Rect rect;
};

/// The axis of a row of rooms.
enum class Axis { kX, kY };

/// Random whole numbers for layouts that are the same on every machine, unlike those of
/// std::uniform_int_distribution.
///
/// Layouts use this generator, not Random (base/random.h). Another generator would draw another
/// building from each seed. Then drives of earlier releases could not be repeated.
class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  /// A number in low..high, both included; `low` if the two are in the wrong order.
  int between(int low, int high);

  /// True in `percent` of 100 draws.
  bool chance(int percent) { return between(1, 100) <= percent; }

 private:
  std::mt19937_64 engine_;
};

/// A side of a rectangle.
enum class Side { kLeft, kBottom, kRight, kTop };

/// A kind of room that a row may contain, with its widths along the row.
struct RoomChoice {
  RoomKind kind;
  int least_width;    ///< [cm]
  int largest_width;  ///< [cm]
  int weight;         ///< relative frequency among the choices
  int most;           ///< greatest number in one row
};

/// A floor while it is drawn: its outline, its rooms, and the holes in its walls.
class FloorLayout {
 public:
  FloorLayout(PortableRandom& random, int partition_cm)
      : random_(random), partition_(partition_cm) {}

  /// Thickness of the walls between rooms of a row [cm].
  int partition() const { return partition_; }

  /// Adds a rectangle inside the outer walls.
  void addInside(const Rect& rect) { inside_.push_back(rect); }

  /// @return its number.
  std::size_t addRoom(RoomKind kind, const Rect& rect);

  /// Fills a rectangle with rooms side by side along an axis. Their kinds are drawn from `choices`
  /// until the row is full; then all rooms are stretched to fit exactly.
  /// @return their numbers, in ascending order along the axis.
  std::vector<std::size_t> addRow(const Rect& rect, Axis axis,
                                  const std::vector<RoomChoice>& choices);

  /// Turns a slice of a room along one side into a room of its own, with a wall between.
  /// @return the slice's number.
  std::size_t cutOff(std::size_t room, Side side, int slice_cm, RoomKind kind);

  /// Records that two stretches of corridor overlap.
  void join(std::size_t a, std::size_t b) { connections_.emplace_back(a, b); }

  /// Opens the wall between two rooms.
  /// @param width_cm  of the hole; narrowed down to a door's if the shared wall is too short
  /// @return false, without a change, if they share no wall that a door fits into.
  bool connect(std::size_t a, std::size_t b, int width_cm);

  /// Connects two rooms by a hole as wide as a door.
  bool addDoor(std::size_t a, std::size_t b) { return connect(a, b, random_.between(80, 90)); }

  /// Adds a door to every room that cannot be reached from the first room, where it shares a wall
  /// with a reachable room.
  void reachAll();

  const std::vector<LayoutRoom>& rooms() const { return rooms_; }
  const std::vector<Rect>& inside() const { return inside_; }
  const std::vector<Rect>& holes() const { return holes_; }
  PortableRandom& random() { return random_; }

 private:
  std::vector<std::size_t> reachable() const;

  PortableRandom& random_;
  int partition_;
  std::vector<Rect> inside_;
  std::vector<LayoutRoom> rooms_;
  std::vector<Rect> holes_;
  std::vector<std::pair<std::size_t, std::size_t>> connections_;
};

constexpr int kToCm2 = 10'000;  ///< factor from m2

/// Draws a flat into an empty layout. @param area_m2 of floor and interior walls
void drawFlat(int area_m2, FloorLayout& layout);

/// Draws an office floor into an empty layout. @param area_m2 of floor and interior walls
void drawOffice(int area_m2, FloorLayout& layout);

}  // namespace sfw
