#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Draws the path and the access points for rviz.
///
/// The path is coloured by wall count, with a legend. Access points have names. An estimated one
/// stands in an ellipse of two standard deviations, which holds it with 86 %. One whose readings
/// contradict its given position is orange, with a line to the position that fits.
visualization_msgs::MarkerArray toMarkers(const Snapshot& snapshot, const DataFindings& findings,
                                          const std_msgs::Header& header);

}  // namespace sfw
