# Fetches MRPT and builds programs with it; sourced by the findings on MRPT in this folder.
# Needs Debian 12 with g++ and up-to-date package lists. Downloads the pinned packages, and those of
# their libraries that this machine lacks (at most 130 MB), and unpacks all into a temporary folder.
# shellcheck shell=bash

mrpt_version=1:2.5.8+ds-2
opencv_version=4.6.0+dfsg-12  # MRPT reads images with OpenCV

# shellcheck source=findings/packages.bash
source "$(dirname "${BASH_SOURCE[0]}")/packages.bash"

# Prints the packages that an installation of MRPT would add to a machine; options are for apt-get.
packages_to_add() {
  apt-get install --simulate --no-install-recommends "$@" "libmrpt-maps-dev=$mrpt_version" |
    awk '$1 == "Inst" { print $2 }'
}

# Unpacks MRPT into a new temporary folder and goes there. The folder is removed at the end.
fetch_mrpt() {
  local all missing pinned others
  enter_temporary_folder
  # To a machine without any package, MRPT would add all of its packages.
  all=$(packages_to_add -o Dir::State::status=/dev/null 2> log) ||
    cannot_run "the package lists of this machine have no MRPT $mrpt_version: $(tail -n 1 log)"
  missing=$(packages_to_add 2> log) || cannot_run "apt-get: $(tail -n 1 log)"
  pinned=$(sed -n -e "s/^libmrpt-.*/&=$mrpt_version/p" -e "s/^libopencv-.*/&=$opencv_version/p" <<< "$all")
  others=$(sed -e '/^libmrpt-/d' -e '/^libopencv-/d' <<< "$missing")
  # shellcheck disable=SC2086  # lists of words
  unpack_packages $pinned $others
}

# Builds NAME.cpp with MRPT.
build_with_mrpt() {
  local name=$1 algebra include lacking
  local libraries includes
  libraries=usr/lib/$(g++ -print-multiarch)
  export LD_LIBRARY_PATH=$folder/$libraries:$folder/usr/lib:$folder/lib/${libraries##*/}
  for algebra in blas lapack; do
    LD_LIBRARY_PATH+=:$folder/$libraries/$algebra:/$libraries/$algebra
  done
  includes=(-isystem usr/include -isystem usr/include/eigen3 -isystem /usr/include/eigen3)
  for include in usr/include/mrpt/*/include; do
    includes+=(-isystem "$include")
  done
  g++ -std=c++17 "${includes[@]}" "$name.cpp" -o "$name" \
    -Wl,--allow-shlib-undefined "$libraries"/libmrpt-*.so 2> log ||
    cannot_run "g++: $(grep -m 1 error log)"
  lacking=$(ldd "$name" | awk '/not found/ { print $1 }')
  [[ -z $lacking ]] || cannot_run "libraries are missing: ${lacking//$'\n'/ }"
  echo "MRPT $mrpt_version, OpenCV $opencv_version"
}
