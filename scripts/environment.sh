# shellcheck shell=bash
# The scripts in this folder source this file. It sets `repository` and `build`, and an environment
# that works on any machine. It defines say, fail and source_ros.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
# Another folder can hold a variant of the build, such as one with sanitizers.
build=${SFW_BUILD_FOLDER:-$repository/build}

# ROS needs the system's Python. Another Python first on the path breaks catkin and rospy.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:${PATH:-/usr/local/bin}
unset PYTHONHOME PYTHONPATH
export PYTHONNOUSERSITE=1

# Loopback works without a resolvable host name, and the port avoids a running master.
export ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:11911
unset ROS_HOSTNAME
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1

# Logs and settings stay in the build tree, so nothing needs or fills a home directory.
export ROS_HOME=$build/ros HOME=${HOME:-$build/home}

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "${0##*/}: $*"
  exit 1
}

# The ROS setup files read unset variables and run commands that fail.
source_ros() {
  set +eu
  # shellcheck disable=SC1090
  source "$1"
  set -eu
}

if [[ -f /opt/ros/noetic/setup.bash ]]; then
  source_ros /opt/ros/noetic/setup.bash
else
  unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH ROS_ROOT
fi
