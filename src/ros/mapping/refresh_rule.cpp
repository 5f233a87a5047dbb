#include "ros/mapping/refresh_rule.h"

#include <cmath>

namespace sfw {

bool RefreshRule::isNew(const Bssid& bssid, const Position& position, double bin_size_m, int most) {
  constexpr double kFarthest = 1e9;  // [bins], beyond any map
  const Position bin = position / bin_size_m;
  if (!(bin.cwiseAbs().maxCoeff() < kFarthest)) {
    return false;  // no map can use it, NaN neither
  }
  int& seen = seen_[{bssid, static_cast<std::int64_t>(std::floor(bin.x())),
                     static_cast<std::int64_t>(std::floor(bin.y()))}];
  if (seen >= most) {
    return false;
  }
  ++seen;
  return true;
}

bool RefreshRule::isNews(const LocatedObservation& observation) {
  constexpr int kReadings = 5;
  constexpr int kContacts = 1;
  bool is_news = false;
  for (const Reading& reading : observation.readings) {
    is_news = isNew(reading.bssid, reading.antenna_in_map, bin_size_m_, kReadings) || is_news;
  }
  for (const Contact& contact : observation.contacts) {
    is_news = isNew(Bssid(), contact.point_in_map, 0.25 * bin_size_m_, kContacts) || is_news;
  }
  return is_news;
}

}  // namespace sfw
