#include <pluginlib/class_list_macros.hpp>

#include "ros/rviz/mapping_panel.h"

PLUGINLIB_EXPORT_CLASS(sfw::MappingPanel, rviz::Panel)
