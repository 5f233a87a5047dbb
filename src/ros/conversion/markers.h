#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// What rviz shows beside the map: the path coloured by wall count with the colours' legend, and
/// access points with their names. One whose position was estimated stands in the ellipse that
/// holds it with 86 %, two standard deviations; one that was given a position that does not fit its
/// readings is orange, and a line leads to where it seems to stand.
visualization_msgs::MarkerArray toMarkers(const Snapshot& snapshot, const DataFindings& findings,
                                          const std_msgs::Header& header);

}  // namespace sfw
