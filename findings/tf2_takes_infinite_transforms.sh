#!/usr/bin/env bash
# Shows that tf2 0.7.6 takes infinite transforms, though it refuses those that are not a number.
#
# 1. BufferCore::setTransform prints an error and returns false for a NaN, and true for an infinite
#    translation, which it keeps.
# 2. Each lookup between the stamps of the good transforms before and after the infinite one then
#    succeeds, with an infinite or NaN position. No exception tells of it.
#
# So one such transform spoils all positions for as long as its neighbours are apart, and a reader of
# tf has to check positions itself.
#
# Usage: tf2_takes_infinite_transforms.sh
# Needs Debian 12 with g++ and up-to-date package lists. Downloads the pinned packages, and those of
# their libraries that this machine lacks (at most 60 MB), and unpacks all into a temporary folder.
# Exits 0 if all is as above, 1 if tf2 behaves otherwise, 2 if it cannot be run.
set -euo pipefail

tf2_version=0.7.6-1+b2

# shellcheck source=findings/packages.bash
source "$(dirname "${BASH_SOURCE[0]}")/packages.bash"

enter_temporary_folder

missing=$(apt-get install --simulate --no-install-recommends "libtf2-dev=$tf2_version" 2> log |
  awk '$1 == "Inst" && $2 !~ /^libtf2-/ { print $2 }') ||
  cannot_run "the package lists of this machine have no tf2 $tf2_version: $(tail -n 1 log)"
# shellcheck disable=SC2086  # a list of words
unpack_packages "libtf2-dev=$tf2_version" "libtf2-2d=$tf2_version" $missing

cat > transforms.cpp <<'CPP'
#include <tf2/buffer_core.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

geometry_msgs::TransformStamped at(double seconds, double x) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time(seconds);
  transform.header.frame_id = "map";
  transform.child_frame_id = "robot";
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

int main() {
  tf2::BufferCore buffer;
  const auto set = [&](double seconds, double x) {
    std::printf("set x = %g at %g s: %s\n", x, seconds,
                buffer.setTransform(at(seconds, x), "finding") ? "taken" : "refused");
  };
  set(10.0, 1.0);
  set(12.0, std::numeric_limits<double>::quiet_NaN());
  set(14.0, std::numeric_limits<double>::infinity());
  set(18.0, 2.0);
  for (const double seconds : {10.0, 12.0, 14.0, 16.0, 18.0}) {
    const auto found = buffer.lookupTransform("map", "robot", ros::Time(seconds));
    const double x = found.transform.translation.x;
    std::printf("x at %g s: %s\n", seconds,
                std::isfinite(x) ? std::to_string(x).c_str() : "not finite");
  }
}
CPP

libraries=usr/lib/$(g++ -print-multiarch)
export LD_LIBRARY_PATH=$folder/$libraries
g++ -std=c++17 -isystem usr/include transforms.cpp -o transforms -L"$libraries" \
  -Wl,--allow-shlib-undefined "$libraries"/libtf2.so -lrostime 2> log ||
  cannot_run "g++: $(grep -m 1 error log)"
lacking=$(ldd transforms | awk '/not found/ { print $1 }')
[[ -z $lacking ]] || cannot_run "libraries are missing: ${lacking//$'\n'/ }"
echo "tf2 $tf2_version"

cat > expected <<'TEXT'
set x = 1 at 10 s: taken
set x = nan at 12 s: refused
set x = inf at 14 s: taken
set x = 2 at 18 s: taken
x at 10 s: 1.000000
x at 12 s: not finite
x at 14 s: not finite
x at 16 s: not finite
x at 18 s: 2.000000
TEXT
./transforms 2> log | tee seen
if diff expected seen > log; then
  echo 'All is as described at the top of this script.'
else
  echo 'tf2 behaves otherwise than described at the top of this script. Expected (<) and seen (>):' >&2
  cat log >&2
  exit 1
fi
