#include "ros/mapping/insertion.h"

namespace sfw {
namespace {

bool isKept(InsertResult result) {
  return result == InsertResult::kAccepted || result == InsertResult::kUnknownAccessPoint;
}

}  // namespace

void insert(const LocatedObservation& observation, Mapper& mapper, PathCorrector& corrector) {
  bool kept = false;
  for (const Reading& reading : observation.readings) {
    kept = isKept(mapper.insert(reading)) || kept;
  }
  for (const Contact& contact : observation.contacts) {
    kept = isKept(mapper.insert(contact)) || kept;
  }
  if (kept && observation.correction) {
    corrector.insert(*observation.correction);
  }
}

}  // namespace sfw
