#include "ros/mapping/insertion.h"

namespace sfw {
namespace {

bool isKept(InsertResult result) {
  return result == InsertResult::kAccepted || result == InsertResult::kUnknownAccessPoint;
}

}  // namespace

std::size_t insert(const LocatedObservation& observation, Mapper& mapper,
                   PathCorrector& corrector) {
  std::size_t readings = 0;
  for (const Reading& reading : observation.readings) {
    readings += isKept(mapper.insert(reading)) ? 1 : 0;
  }
  bool kept = readings > 0;
  for (const Contact& contact : observation.contacts) {
    kept = isKept(mapper.insert(contact)) || kept;
  }
  if (kept && observation.correction) {
    corrector.insert(*observation.correction);
  }
  for (const LocatedPose& sample : observation.way) {
    const PathPose& pose = sample.pose;
    if (isKept(mapper.insertPose(pose.stamp_ns, pose.antenna_in_map, pose.robot)) &&
        sample.correction) {
      corrector.insert(*sample.correction);
    }
  }
  return readings;
}

}  // namespace sfw
