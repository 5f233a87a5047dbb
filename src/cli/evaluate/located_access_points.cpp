#include "cli/evaluate/located_access_points.h"

#include <map>
#include <set>

#include "base/erase_if.h"
#include "cli/evaluate/map_report.h"
#include "cli/warnings.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {

std::vector<AccessPoint> locatedAccessPoints(std::vector<AccessPoint> table,
                                             const std::vector<Reading>& readings,
                                             const std::string& map,
                                             const std::string& table_file) {
  std::set<Bssid> in_readings;
  for (const Reading& reading : readings) {
    in_readings.insert(reading.bssid);
  }
  eraseIf(table, [&](const AccessPoint& access_point) {
    return in_readings.count(access_point.bssid) == 0;
  });
  if (table.empty()) {
    throw InputError(table_file +
                     ": none of its access points is in the readings; give the table "
                     "that the map was made with");
  }
  const std::map<Bssid, Position> reported = reportedPositions(map);
  for (AccessPoint& access_point : table) {
    const auto found = reported.find(access_point.bssid);
    const bool is_exact = access_point.position_known && !access_point.position_sd_m;
    if (!is_exact && found != reported.end()) {
      access_point.position = found->second;
      access_point.position_known = true;
    }
  }
  eraseIf(table, [](const AccessPoint& access_point) { return !access_point.position_known; });
  if (table.empty()) {
    warn(table_file +
         ": no access point has a position, here or in report.json beside the map; the metrics of "
         "observed walls are left out");
  }
  return table;
}

}  // namespace sfw
