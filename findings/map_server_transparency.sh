#!/usr/bin/env bash
# Shows how map_server reads opacity, otherwise than one would guess:
#
# 1. In mode `scale`, no grey value of a PGM is unknown (-1), because a PGM has no opacity.
# 2. In mode `scale`, a pixel is unknown only at opacity 0, and only between the thresholds.
# 3. In mode `scale`, the blue channel of a colour image without opacity is read as opacity.
# 4. In mode `trinary`, opacity is averaged as if it were a colour. An opaque image with opacity is
#    read as whiter than the same image without it.
#
# Usage: map_server_transparency.sh
# Needs map_server of ROS Noetic in the version below (Ubuntu's package ros-noetic-map-server), with
# its setup.bash sourced. Starts a ROS master of its own on this machine.
# Exits 0 if all is as above, 1 if map_server behaves otherwise, 2 if it cannot be run.
set -euo pipefail

expected_version=1.17.3

cannot_run() {
  echo "map_server_transparency.sh: $1" >&2
  exit 2
}

for program in roscore rosrun rosversion rosparam python3; do
  [[ $(type -t "$program") ]] || cannot_run "$program is missing; source the setup.bash of ROS"
done
version=$(rosversion map_server) || cannot_run 'map_server is missing; install ros-noetic-map-server'
[[ $version == "$expected_version" ]] ||
  cannot_run "map_server is version $version; this script was written for $expected_version"
echo "map_server $version"

folder=$(mktemp -d)
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:$port ROS_LOG_DIR=$folder/log
roscore -p "$port" > "$folder/roscore.log" 2>&1 &
master=$!
clean_up() {
  kill "$master" 2> /dev/null || true
  wait "$master" || true
  rm -r "$folder"
}
trap clean_up EXIT
tries=0
until rosparam list > /dev/null 2>&1; do
  ((++tries <= 60)) || cannot_run 'the ROS master does not start'
  sleep 0.5
done

cat > "$folder/check.py" << 'PYTHON'
import pathlib
import struct
import subprocess
import sys
import zlib

import rospy
from nav_msgs.msg import OccupancyGrid

GREY, RGB, GREY_ALPHA, RGB_ALPHA = 0, 2, 4, 6
CHANNELS = {GREY: 1, RGB: 3, GREY_ALPHA: 2, RGB_ALPHA: 4}
OPEN, USUAL = (1.0, 0.0), (0.65, 0.196)  # occupied_thresh, free_thresh
FOLDER = pathlib.Path(sys.argv[1])


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(colour_type, *pixels):
    """One row of pixels, 8 bits a channel."""
    row = bytes(value for pixel in pixels for value in pixel)
    header = struct.pack(">IIBBBBB", len(row) // CHANNELS[colour_type], 1, 8, colour_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(b"\0" + row)) + chunk(b"IEND", b""))


def pgm(values):
    return b"P5\n%d 1\n255\n" % len(values) + bytes(values)


def cells(number, image, mode, thresholds):
    """The cells that map_server publishes of an image of one row."""
    file = FOLDER / ("%d.%s" % (number, "pgm" if image.startswith(b"P5") else "png"))
    file.write_bytes(image)
    yaml = FOLDER / ("%d.yaml" % number)
    yaml.write_text("image: %s\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\nmode: %s\n"
                    "occupied_thresh: %g\nfree_thresh: %g\n" % (file, mode, *thresholds))
    topic = "/map_%d" % number
    server = subprocess.Popen(
        ["rosrun", "map_server", "map_server", str(yaml), "map:=" + topic, "map_metadata:=%s_data" % topic,
         "__name:=server_%d" % number], stdout=subprocess.DEVNULL)
    try:
        return list(rospy.wait_for_message(topic, OccupancyGrid, 30.0).data)
    finally:
        server.terminate()
        server.wait()


ALL = list(range(256))
greys = [0, 128, 255]
# What is shown, image, mode, thresholds, and the cells (a list) or whether any is -1 (a bool).
CASES = [
    ("PGM, every grey", pgm(ALL), "scale", OPEN, False),
    ("PGM, every grey", pgm(ALL), "scale", USUAL, False),
    ("PGM, every grey", pgm(ALL), "trinary", USUAL, True),
    ("greys 0 128 255, opacity 0", png(GREY_ALPHA, *[(g, 0) for g in greys]), "scale", OPEN, [-1, -1, -1]),
    ("greys 0 128 255, opacity 0", png(GREY_ALPHA, *[(g, 0) for g in greys]), "scale", USUAL, [100, -1, 0]),
    ("greys 0 128 255, opacity 1", png(GREY_ALPHA, *[(g, 1) for g in greys]), "scale", OPEN, [99, 49, 1]),
    ("greys 0 128 255, opacity 1", png(RGB_ALPHA, *[(g, g, g, 1) for g in greys]), "scale", OPEN, [99, 49, 1]),
    ("RGB, blue 0 and 1, no opacity", png(RGB, (128, 128, 0), (128, 128, 1)), "scale", OPEN, [-1, 66]),
    ("greys 60 205, no opacity", png(GREY, (60,), (205,)), "trinary", USUAL, [100, -1]),
    ("greys 60 205, opaque", png(GREY_ALPHA, (60, 255), (205, 255)), "trinary", USUAL, [-1, 0]),
    ("greys 60 205, opaque", png(RGB_ALPHA, (60, 60, 60, 255), (205, 205, 205, 255)), "trinary", USUAL, [-1, 0]),
]

rospy.init_node("map_server_transparency")
changed = 0
for number, (what, image, mode, thresholds, expected) in enumerate(CASES):
    seen = cells(number, image, mode, thresholds)
    if isinstance(expected, bool):
        seen = -1 in seen
        text = "some cell is -1" if seen else "no cell is -1"
    else:
        text = str(seen)
    changed += seen != expected
    print("%-30s %-8s %-13s %s%s" % (what, mode, "%g, %g" % thresholds, text,
                                     "" if seen == expected else "  CHANGED: expected %s" % expected))
sys.exit(1 if changed else 0)
PYTHON

echo 'image                          mode     thresholds    cells'
status=0
python3 "$folder/check.py" "$folder" || status=$?
if [[ $status == 0 ]]; then
  echo 'All is as described at the top of this script.'
else
  echo 'map_server behaves otherwise than described at the top of this script.' >&2
  exit 1
fi
