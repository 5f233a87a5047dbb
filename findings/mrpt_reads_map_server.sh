#!/usr/bin/env bash
# Shows how MRPT 2.5.8 reads maps of map_server, otherwise than one would guess. The function is
# COccupancyGridMap2D::loadFromROSMapServerYAML. It reports success in every case below.
#
# 1. The map moves by up to half a cell, because each edge is rounded to a multiple of the resolution.
# 2. If the origin lies half a cell off and the number of columns or rows is odd, the map can lose its
#    last column or top row, with the wall in it, or gain one of unknown cells. Halves are rounded to
#    even numbers, so the two edges move in opposite directions.
# 3. In mode `scale`, opacity is not read. A transparent pixel, which map_server reads as unknown, is
#    occupied or free as its hidden grey says.
# 4. In mode `scale`, occupied_thresh and free_thresh are not used.
#
# Not surprising, but shown beside it: in mode `trinary`, thresholds count, and 205 becomes unknown.
#
# Usage: mrpt_reads_map_server.sh
# Needs Debian 12 with g++ and up-to-date package lists. Downloads the pinned packages, and those of
# their libraries that this machine lacks (at most 130 MB), and unpacks all into a temporary folder.
# Exits 0 if all is as above, 1 if MRPT behaves otherwise, 2 if it cannot be run.
set -euo pipefail

# shellcheck source=findings/mrpt.bash
source "$(dirname "${BASH_SOURCE[0]}")/mrpt.bash"

[[ $(type -t base64) ]] || cannot_run "base64 is missing"
fetch_mrpt

cat > load.cpp <<'CPP'
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdio>

// Prints columns, rows, the lower left corner, and the cells from the lower left on.
int main(int, char** arguments) {
  mrpt::maps::COccupancyGridMap2D map;
  const bool loaded = map.loadFromROSMapServerYAML(arguments[1]);
  std::printf("%s %ux%u at %.3f %.3f:", loaded ? "read" : "refused", map.getSizeX(), map.getSizeY(),
              map.getXMin(), map.getYMin());
  for (unsigned y = 0; y < map.getSizeY(); ++y) {
    for (unsigned x = 0; x < map.getSizeX(); ++x) {
      std::printf(" %.2f", map.getCell(x, y));
    }
  }
  std::printf("\n");
}
CPP

build_with_mrpt load

# Makes an image of grey values.
grey_image() {
  local name=$1 width=$2 height=$3
  shift 3
  {
    printf 'P5\n%d %d\n255\n' "$width" "$height"
    # shellcheck disable=SC2059  # the format is the data
    printf "$(printf '\\%03o' "$@")"
  } > "$name"
}

# Loads one image by a YAML file and prints what becomes of it.
show() {
  local what=$1 image=$2 resolution=$3 origin=$4 mode=$5 thresholds=${6:-0.65 0.196}
  cat > map.yaml <<YAML
image: $image
resolution: $resolution
origin: [$origin, 0]
negate: 0
mode: $mode
occupied_thresh: ${thresholds% *}
free_thresh: ${thresholds#* }
YAML
  printf '%-33s %-8s %s\n' "$what" "$mode" "$(./load map.yaml 2> log)"
}

# A map has a wall (0) at both ends and free cells (254) between.
grey_image wide4.pgm 4 1 0 254 254 0
grey_image wide5.pgm 5 1 0 254 254 254 0
grey_image high5.pgm 1 5 0 254 254 254 0
grey_image greys.pgm 5 1 0 60 128 205 254
# A PNG of one row with the greys 0, 128, 255, 0, 255; the first three are transparent.
base64 -d > transparent.png <<BASE64
iVBORw0KGgoAAAANSUhEUgAAAAUAAAABCAQAAAC896x4AAAAE0lEQVR4nGNgYGhg+M/A8P//fwAP
/wR98T1oUAAAAABJRU5ErkJggg==
BASE64

cat > expected <<'TEXT'
origin 3 cells from 0             trinary  read 5x1 at -0.150 0.000: 0.00 1.00 1.00 1.00 0.00
origin -0.17 -0.03, cells 0.05    trinary  read 5x1 at -0.150 -0.050: 0.00 1.00 1.00 1.00 0.00
origin -51.225, cells 0.05        trinary  read 4x1 at -51.200 0.000: 0.00 1.00 1.00 0.00
origin x -0.125, cells 0.05       trinary  read 4x1 at -0.100 0.000: 0.00 1.00 1.00 1.00
origin y -0.125, cells 0.05       trinary  read 1x4 at 0.000 -0.100: 0.00 1.00 1.00 1.00
origin x -0.625, cells 0.25       trinary  read 4x1 at -0.500 0.000: 0.00 1.00 1.00 1.00
origin x 0.125, cells 0.25        trinary  read 6x1 at 0.000 0.000: 0.00 1.00 1.00 1.00 0.00 0.50
greys 0 60 128 205 254            trinary  read 5x1 at 0.000 0.000: 0.00 0.00 0.50 0.50 1.00
the same greys                    scale    read 5x1 at 0.000 0.000: 0.01 0.23 0.50 0.80 0.98
the same, other thresholds        scale    read 5x1 at 0.000 0.000: 0.01 0.23 0.50 0.80 0.98
greys (0 128 255) 0 255           scale    read 5x1 at 0.000 0.000: 0.01 0.50 0.98 0.01 0.98
TEXT
echo 'what (in brackets: transparent)   mode     columns x rows at x y: probability of being free'
{
  show 'origin 3 cells from 0' wide5.pgm 0.05 '-0.15, 0' trinary
  show 'origin -0.17 -0.03, cells 0.05' wide5.pgm 0.05 '-0.17, -0.03' trinary
  show 'origin -51.225, cells 0.05' wide4.pgm 0.05 '-51.225, 0' trinary
  show 'origin x -0.125, cells 0.05' wide5.pgm 0.05 '-0.125, 0' trinary
  show 'origin y -0.125, cells 0.05' high5.pgm 0.05 '0, -0.125' trinary
  show 'origin x -0.625, cells 0.25' wide5.pgm 0.25 '-0.625, 0' trinary
  show 'origin x 0.125, cells 0.25' wide5.pgm 0.25 '0.125, 0' trinary
  show 'greys 0 60 128 205 254' greys.pgm 0.05 '0, 0' trinary
  show 'the same greys' greys.pgm 0.05 '0, 0' scale
  show 'the same, other thresholds' greys.pgm 0.05 '0, 0' scale '1.0 0.0'
  show 'greys (0 128 255) 0 255' transparent.png 0.05 '0, 0' scale '1.0 0.0'
} | tee seen
if diff expected seen > log; then
  echo 'All is as described at the top of this script.'
else
  echo 'MRPT behaves otherwise than described at the top of this script. Expected (<) and seen (>):' >&2
  cat log >&2
  exit 1
fi
