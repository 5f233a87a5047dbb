#include "structure_from_wifi/snapshot.h"

namespace sfw {

const char* toString(InsertResult result) {
  switch (result) {
    case InsertResult::kAccepted:
      return "accepted";
    case InsertResult::kPositionNotFinite:
      return "position is not finite";
    case InsertResult::kPositionTooFar:
      return "position is so far away that the map would exceed map/max_cells";
    case InsertResult::kRssiNotFinite:
      return "rssi_dbm is not finite";
    case InsertResult::kRssiOutOfRange:
      return "rssi_dbm is not in (-120, 0] (a percentage, or an inaudible radio?)";
    case InsertResult::kUnknownAccessPoint:
      return "bssid is not in the table of access points";
    case InsertResult::kTooManyReadings:
      return "map/max_readings is reached";
  }
  return "";
}

}  // namespace sfw
