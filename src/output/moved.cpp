#include "output/moved.h"

namespace sfw {

Snapshot moved(Snapshot snapshot, const Position& by) {
  snapshot.offset += by;
  snapshot.belief = snapshot.belief.moved(by);
  snapshot.probability = snapshot.probability.moved(by);
  for (PathPose& pose : snapshot.path) {
    pose.antenna_in_map += by;
  }
  for (Contact& contact : snapshot.contacts) {
    contact.point_in_map += by;
  }
  for (AccessPointSummary& summary : snapshot.access_points) {
    if (hasPosition(summary)) {
      summary.access_point.position += by;
    }
    if (summary.estimate) {
      summary.estimate->position += by;
    }
    if (summary.given_position) {
      *summary.given_position += by;
    }
    for (Sample& sample : summary.samples) {
      sample.antenna_in_map += by;
    }
  }
  if (snapshot.tomography) {
    snapshot.tomography->wall_loss = moved(std::move(snapshot.tomography->wall_loss), by);
  }
  if (!snapshot.extent.isEmpty()) {
    snapshot.extent.translate(by);
  }
  for (WallSegment& wall : snapshot.walls) {
    wall.from += by;
    wall.to += by;
  }
  return snapshot;
}

DataFindings moved(DataFindings findings, const Position& by) {
  for (auto& fit : findings.fits) {
    if (fit) {
      fit->estimate.position += by;
    }
  }
  return findings;
}

}  // namespace sfw
