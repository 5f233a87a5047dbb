#!/usr/bin/env bash
# The core works without ROS: its library needs none of ROS's libraries or symbols, directly or
# through another, and its sources include none of ROS's headers.
#
# Usage: core_links_no_ros.sh REPOSITORY MAPPING_LIBRARY ROS_LIBRARY
# ROS_LIBRARY, one that does need ROS, proves that the checks can tell.
set -euo pipefail
repository=$1 core=$2 ros_library=$3

ros_names='ros.*|cpp_common|xmlrpcpp|tf2?(_.*)?|nodelet.*|bondcpp|class_loader|pluginlib|message_filters'
ros_names+='|topic_tools|actionlib|image_transport|.*_msgs|std_srvs|dynamic_reconfigure.*|diagnostic_updater'
ros_names+='|mrpt-ros.*|mrpt/ros1bridge'
failures=0

report() {
  printf '%s:\n%s\n' "$1" "$2"
  failures=$((failures + 1))
}

needed_ros_libraries() {
  { readelf --dynamic --wide "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; ldd "$1" | awk '{print $1}'; } |
    sort -u | grep -E "^lib($ros_names)\.so" || true
}

used_ros_symbols() {
  nm --dynamic --demangle --undefined-only "$1" | grep -E '\<(ros|tf2|tf2_ros|nodelet|rosbag)::' || true
}

[[ -n $(needed_ros_libraries "$ros_library") ]] || report "no ROS library is seen in" "$ros_library"
[[ -n $(used_ros_symbols "$ros_library") ]] || report "no ROS symbol is seen in" "$ros_library"

found=$(needed_ros_libraries "$core")
[[ -z $found ]] || report "the core needs ROS libraries" "$found"
found=$(used_ros_symbols "$core")
[[ -z $found ]] || report "the core uses ROS symbols" "$found"

cd "$repository"
rooms=(include)
for room in src/*/; do
  case $room in src/ros/ | src/cli/) ;; *) rooms+=("$room") ;; esac
done
found=$(grep -rnE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($ros_names)/" "${rooms[@]}" || true)
[[ -z $found ]] || report "the core includes ROS headers" "$found"

# Generated message headers share the package's folder, but not its source tree.
while IFS=: read -r file line text; do
  header=$(sed -E 's/.*[<"](.*)[>"].*/\1/' <<<"$text")
  [[ -f include/$header ]] || report "not a header of the core" "$file:$line: $text"
done < <(grep -rnE '#[[:space:]]*include[[:space:]]*[<"]structure_from_wifi/' "${rooms[@]}")

[[ $failures == 0 ]]
