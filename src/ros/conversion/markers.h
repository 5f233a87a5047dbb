#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "files/colour.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Draws the path, the walls and the access points for rviz.
///
/// The path is coloured by wall count, with a legend. Walls between passes of the robot are dark
/// red; their opacity is their confidence. Access points have names; where there are many, names
/// are short and none covers another. An estimated access point has an ellipse of two standard
/// deviations, which contains it with a probability of 86 %. An access point whose readings
/// contradict its given position is orange. A line leads to the position that fits.
visualization_msgs::MarkerArray toMarkers(const Snapshot& snapshot, const DataFindings& findings,
                                          const std_msgs::Header& header);

/// A marker at the origin of its frame, of one colour.
/// @param type  of visualization_msgs/Marker
/// @param size  in each direction [m]
visualization_msgs::Marker marker(const std_msgs::Header& header, const char* name, int id,
                                  int type, double size, const Colour& colour);

/// A text that faces the viewer, with letters of a height [m].
visualization_msgs::Marker label(const std_msgs::Header& header, const char* name, int id,
                                 const std::string& text, const geometry_msgs::Point& at,
                                 const Colour& colour, double letter_height_m);

}  // namespace sfw
