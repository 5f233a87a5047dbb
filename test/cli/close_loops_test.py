#!/usr/bin/env python3
"""Closes loops of drifted recordings with `sfw close-loops`.

Usage: close_loops_test.py RESULT.xml SFW
"""

import json
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, CommandLine  # noqa: E402

RADIOS = [(-1, -1), (10, -1), (21, -1), (-1, 13), (10, 13), (21, 13), (-1, 6), (21, 6)]
CORNERS = [(1, 2), (19, 2), (19, 6), (1, 6), (1, 10), (19, 10)]


def way():
    """Twice through a hall, half a metre between places."""
    corners = 2 * CORNERS
    places = []
    for a, b in zip(corners, corners[1:]):
        steps = int(2 * math.dist(a, b))
        places += [(a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps)
                   for i in range(steps)]
    return places


def drifted(places, turn):
    """Odometry that turns by an error at each step."""
    path, heading = [places[0]], 0.0
    for a, b in zip(places, places[1:]):
        heading += turn
        x, y = b[0] - a[0], b[1] - a[1]
        path.append((path[-1][0] + math.cos(heading) * x - math.sin(heading) * y,
                     path[-1][1] + math.sin(heading) * x + math.cos(heading) * y))
    return path


def recording(path, offset=(0.0, 0.0), robot=None):
    noise = random.Random(3)
    rows = []
    for step, (place, (x, y)) in enumerate(zip(way(), path)):
        for radio, at in enumerate(RADIOS):
            rssi = -38 - 28 * math.log10(math.hypot(math.dist(place, at), 1.0)) + noise.gauss(0, 2)
            rows.append("%d,%.3f,%.3f,02:00:00:00:00:0%d,%.1f" % (
                step + 1, x + offset[0], y + offset[1], radio, rssi) +
                ("," + robot if robot else ""))
    return "\n".join([HEADER + (",robot" if robot else "")] + rows) + "\n"


class CloseLoops(CommandLine):
    def close(self, text, *more):
        readings = self.write("drive.csv", text)
        output = self.folder / "closed"
        return output, self.good(self.sfw("close-loops", "--readings", readings, "--output", output,
                                          *more))

    def test_corrects_a_path_that_drifts_and_maps_it(self):
        path = drifted(way(), 0.005)
        contacts = self.write("contacts.csv", "stamp,x,y\n%d,%.3f,%.3f\n" % (len(path), *path[-1]))
        output, result = self.close(recording(path), "--contacts", contacts, "--json")
        found, = json.loads(result.stdout)
        self.assertEqual(found["finding"], "drift")
        self.assertLess(found["after"]["distance_m"], 0.5 * found["before"]["distance_m"])
        self.assertRegex(result.stderr, r"drive.csv: where the robot returned, the path is off by "
                                        r"[0-9.]+ m .*; corrected, it is off by")
        rows = (output / "readings.csv").read_text().splitlines()
        self.assertEqual(len(rows), 1 + len(path) * len(RADIOS))
        first = [float(value) for value in rows[1].split(",")[1:3]]
        self.assertLess(math.dist(first, path[0]), 1e-3, "the start of the path stays")
        contact, last = [[float(value) for value in line.split(",")[1:3]] for line in
                         ((output / "contacts.csv").read_text().splitlines()[1], rows[-1])]
        self.assertLess(math.dist(contact, last), 1e-3, "a contact moves with the robot")
        self.good(self.sfw("map", "--readings", output / "readings.csv", "--contacts",
                           output / "contacts.csv", "--path", output / "path.csv", "--output",
                           self.folder / "map"))

    def test_leaves_a_good_path_as_it_is(self):
        text = recording(way(), (500000.0, 4000000.0))
        output, result = self.close(text)
        self.assertIn("no more than the radio resolves; it stays", result.stderr)
        closed = (output / "readings.csv").read_text().splitlines()
        places = [[tuple(map(float, line.split(",")[1:3])) for line in lines[1:]]
                  for lines in (text.splitlines(), closed)]
        self.assertEqual(len(places[0]), len(places[1]))
        self.assertLess(max(map(math.dist, *places)), 1e-3)

    def test_tells_when_the_robot_never_returned(self):
        places = way()
        half = recording(places[:70])
        _, result = self.close(half)
        self.assertRegex(result.stderr, "the path stays: it returns to heard places in [0-9]+ "
                                        "stretches")

    def test_names_robots(self):
        _, result = self.close(recording(way(), robot="rover"))
        self.assertIn("the path of rover is off by", result.stderr)

    def test_without_readings_says_what_to_do(self):
        readings = self.write("empty.csv", HEADER + "\n")
        self.bad(self.sfw("close-loops", "--readings", readings, "--output",
                          self.folder / "closed"), "empty.csv")
        self.bad(self.sfw("close-loops", "--output", self.folder / "closed"),
                 "exactly one of --readings and --bag is needed")
        self.assertFalse((self.folder / "closed").exists())


if __name__ == "__main__":
    junit.run()
