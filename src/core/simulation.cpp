#include "structure_from_wifi/simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/ray.h"

namespace sfw {
namespace {

constexpr double kPi = 3.14159265358979323846;

void requirePositive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(std::string(name) + " must be finite and positive");
  }
}

void throwIfAny(const std::vector<std::string>& problems) {
  std::string text;
  for (const std::string& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem;
  }
  if (!text.empty()) {
    throw InputError(text);
  }
}

std::string toText(const Position& point) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", point.x(), point.y());
  return text;
}

bool isWall(const Grid<CellState>& plan, Cell c) {
  return plan.geometry.contains(c) && plan[c] == CellState::kOccupied;
}

/// Where a ray meets a wall: in one cell, or at the corner that two share.
struct WallContact {
  Cell a;
  Cell b;
};

bool touch(Cell a, Cell b) { return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1; }

bool touch(const WallContact& s, const WallContact& t) {
  return touch(s.a, t.a) || touch(s.a, t.b) || touch(s.b, t.a) || touch(s.b, t.b);
}

double distanceToSegment(const Position& point, const Position& a, const Position& b) {
  const Position along = b - a;
  const double length_squared = along.squaredNorm();
  const double share = length_squared > 0.0 ? (point - a).dot(along) / length_squared : 0.0;
  return (a + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

/// A cell that is not free and too near to the segment; the lowest row first.
std::optional<Cell> findObstacle(const Grid<CellState>& plan, const Position& a, const Position& b,
                                 double radius_m) {
  const GridGeometry& geometry = plan.geometry;
  const double reach = radius_m + std::sqrt(0.5) * geometry.resolution();
  const Cell first = geometry.cellAt(a.cwiseMin(b) - Position::Constant(reach));
  const Cell last = geometry.cellAt(a.cwiseMax(b) + Position::Constant(reach));
  Cell c;
  for (c.y = first.y; c.y <= last.y; ++c.y) {
    for (c.x = first.x; c.x <= last.x; ++c.x) {
      const bool free = geometry.contains(c) && plan[c] == CellState::kFree;
      if (!free && distanceToSegment(geometry.centre(c), a, b) < reach) {
        return c;
      }
    }
  }
  return std::nullopt;
}

std::string obstacleText(const Grid<CellState>& plan, Cell c) {
  const char* what = " is outside the plan";
  if (plan.geometry.contains(c)) {
    what = plan[c] == CellState::kOccupied ? " is occupied" : " is unknown";
  }
  return toText(plan.geometry.centre(c)) + what;
}

/// Random numbers that are the same on every machine, unlike those of std::normal_distribution:
/// SplitMix64 (Steele et al. 2014) and Box-Muller. One generator for each purpose and sample, so
/// that no value depends on how many were drawn before.
class Random {
 public:
  Random(std::int64_t seed, std::uint64_t purpose, std::uint64_t sample)
      : state_(scrambled(scrambled(static_cast<std::uint64_t>(seed) + kStep * purpose) + sample)) {}

  /// In (0, 1].
  double uniform() {
    state_ += kStep;
    return static_cast<double>((scrambled(state_) >> 11) + 1) * 0x1p-53;
  }

  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * kPi * uniform());
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

  static std::uint64_t scrambled(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
  }

  std::uint64_t state_;
};

/// The streams of one access point: its shadowing and its samples.
std::uint64_t shadowingStream(std::size_t access_point) { return 2 * access_point + 1; }
std::uint64_t sampleStream(std::size_t access_point) { return 2 * access_point + 2; }

}  // namespace

Route::Route(const std::vector<Position>& way_points, double speed_m_s, double yaw_rate_rad_s) {
  requirePositive(speed_m_s, "speed_m_s");
  requirePositive(yaw_rate_rad_s, "yaw_rate_rad_s");
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    const Position along = way_points[i] - way_points[i - 1];
    if (along.norm() == 0.0) {
      continue;
    }
    Leg leg{};
    leg.from = way_points[i - 1];
    leg.to = way_points[i];
    leg.yaw_rad = std::atan2(along.y(), along.x());
    if (!legs_.empty()) {
      leg.start_s = legs_.back().end_s;
      leg.turn_rad = std::remainder(leg.yaw_rad - legs_.back().yaw_rad, 2.0 * kPi);
    }
    leg.drive_s = leg.start_s + std::abs(leg.turn_rad) / yaw_rate_rad_s;
    leg.end_s = leg.drive_s + along.norm() / speed_m_s;
    legs_.push_back(leg);
  }
  if (legs_.empty()) {
    throw InputError("a route needs at least two different way points");
  }
}

double Route::duration() const { return legs_.back().end_s; }

RobotPose Route::poseAt(double time_s) const {
  const double time = std::clamp(time_s, 0.0, duration());
  const auto next = std::upper_bound(legs_.begin() + 1, legs_.end(), time,
                                     [](double t, const Leg& leg) { return t < leg.start_s; });
  const Leg& leg = *(next - 1);
  if (time < leg.drive_s) {
    const double to_go = (leg.drive_s - time) / (leg.drive_s - leg.start_s);
    return {leg.from, leg.yaw_rad - to_go * leg.turn_rad};
  }
  const double share = (time - leg.drive_s) / (leg.end_s - leg.drive_s);
  return {leg.from + share * (leg.to - leg.from), leg.yaw_rad};
}

void requireFree(const Grid<CellState>& plan, const std::vector<Position>& way_points,
                 double radius_m) {
  std::vector<std::string> problems;
  const auto name = [&](std::size_t i) {
    return "way point " + std::to_string(i + 1) + " " + toText(way_points[i]);
  };
  bool last_is_free = false;
  for (std::size_t i = 0; i < way_points.size(); ++i) {
    const std::optional<Cell> obstacle = findObstacle(plan, way_points[i], way_points[i], radius_m);
    if (obstacle) {
      problems.push_back(name(i) + " is not free: " + obstacleText(plan, *obstacle));
    } else if (last_is_free) {
      const auto between = findObstacle(plan, way_points[i - 1], way_points[i], radius_m);
      if (between) {
        problems.push_back("the stretch from " + name(i - 1) + " to " + name(i) +
                           " is not free: " + obstacleText(plan, *between));
      }
    }
    last_is_free = !obstacle;
  }
  throwIfAny(problems);
}

int countWalls(const Grid<CellState>& plan, const Position& from, const Position& to) {
  int walls = 0;
  std::optional<WallContact> last_contact;
  const auto meet = [&](const WallContact& contact) {
    walls += last_contact && touch(*last_contact, contact) ? 0 : 1;
    last_contact = contact;
  };
  std::optional<Cell> last;
  Ray(plan.geometry, from, to).forEachCell([&](Cell c) {
    if (last && last->x != c.x && last->y != c.y) {
      const WallContact corner{{last->x, c.y}, {c.x, last->y}};
      if (isWall(plan, corner.a) && isWall(plan, corner.b)) {
        meet(corner);
      }
    }
    if (isWall(plan, c)) {
      meet({c, c});
    }
    last = c;
  });
  return walls;
}

std::vector<std::string> validate(const RadioModel::Config& config) {
  std::vector<std::string> problems;
  const auto require = [&](double value, double low, double high, const char* name) {
    if (!(value >= low && value <= high)) {
      char text[96];
      std::snprintf(text, sizeof text, "%s must lie in %g..%g", name, low, high);
      problems.emplace_back(text);
    }
  };
  require(config.rssi_at_1m, -119.0, 0.0, "rssi_at_1m");
  require(config.exponent, 0.0, 10.0, "exponent");
  require(config.wall_loss, 0.0, 100.0, "wall_loss");
  require(config.shadowing, 0.0, 30.0, "shadowing");
  require(config.shadowing_distance, 0.01, 1000.0, "shadowing_distance");
  require(config.sample_noise, 0.0, 30.0, "sample_noise");
  require(config.antenna_height, 0.0, 10.0, "antenna_height");
  require(config.sensitivity, -119.0, 0.0, "sensitivity");
  return problems;
}

RadioModel::RadioModel(const Grid<CellState>& plan, const std::vector<AccessPoint>& access_points,
                       const Config& config)
    : plan_(plan), access_points_(access_points), config_(config) {
  std::vector<std::string> problems = validate(config);
  for (const AccessPoint& access_point : access_points) {
    if (!plan.geometry.contains(plan.geometry.cellAt(access_point.position))) {
      problems.push_back("access point " + access_point.bssid.str() + " at " +
                         toText(access_point.position) + " is outside the plan");
    }
  }
  throwIfAny(problems);
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    waves_.push_back(makeWaves(i));
  }
}

std::vector<RadioModel::Wave> RadioModel::makeWaves(std::size_t access_point) const {
  // Plane waves with random directions and phases add up to a Gaussian field. With wave numbers of
  // the two-dimensional Cauchy distribution, normal / |normal|, its correlation is exp(-d / D), the
  // usual form (Gudmundson 1991).
  constexpr std::size_t kWaves = 256;
  Random random(config_.seed, shadowingStream(access_point), 0);
  std::vector<Wave> waves(kWaves);
  for (Wave& wave : waves) {
    const double x = random.normal();
    const double y = random.normal();
    const double scale = config_.shadowing_distance * std::abs(random.normal());
    wave = {Position(x, y) / scale, 2.0 * kPi * random.uniform()};
  }
  return waves;
}

double RadioModel::shadowing(std::size_t access_point, const Position& antenna_in_map) const {
  const std::vector<Wave>& waves = waves_[access_point];
  double sum = 0.0;
  for (const Wave& wave : waves) {
    sum += std::cos(wave.rad_per_m.dot(antenna_in_map) + wave.phase_rad);
  }
  return config_.shadowing * std::sqrt(2.0 / static_cast<double>(waves.size())) * sum;
}

double RadioModel::meanRssi(std::size_t access_point, const Position& antenna_in_map) const {
  constexpr double kNear = 0.1;  // metres; nearer antennas touch, and the model ends
  const AccessPoint& source = access_points_[access_point];
  const double above = source.height_m.value_or(config_.antenna_height) - config_.antenna_height;
  const double along = (antenna_in_map - source.position).norm();
  const double distance = std::max(std::hypot(along, above), kNear);
  return config_.rssi_at_1m - 10.0 * config_.exponent * std::log10(distance) -
         config_.wall_loss * countWalls(plan_, source.position, antenna_in_map) +
         shadowing(access_point, antenna_in_map);
}

std::optional<double> RadioModel::rssi(std::size_t access_point, const Position& antenna_in_map,
                                       std::uint64_t sample) const {
  Random random(config_.seed, sampleStream(access_point), sample);
  const double noisy =
      meanRssi(access_point, antenna_in_map) + config_.sample_noise * random.normal();
  const double rounded = std::min(std::round(noisy), 0.0);
  return rounded < config_.sensitivity ? std::nullopt : std::optional<double>(rounded);
}

}  // namespace sfw
