#!/usr/bin/env python3
"""Maps without a table of access points, and prints one with `sfw access-points`.

Usage: access_points_test.py RESULT.xml SFW
"""

import json
import math
import pathlib
import random
import sys

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, CommandLine  # noqa: E402

FIRST, ALIAS, SECOND, RARE = ("a0:00:00:00:00:40", "a0:00:00:00:00:41", "bc:00:00:00:00:07",
                              "bc:00:00:00:00:99")
PLACES = {FIRST: (3.0, 2.5), SECOND: (9.0, 4.5)}


def hall():
    """Lanes of 12 m, 1 m apart. FIRST and ALIAS are one radio."""
    noise = random.Random(5)
    table, stamp = [], 0.0
    for lane in range(8):
        for step in range(60):
            x, y = 0.2 * step if lane % 2 == 0 else 12.0 - 0.2 * step, float(lane)
            signals = {}
            for bssid, (at_x, at_y) in PLACES.items():
                distance = math.hypot(x - at_x, y - at_y, 1.0)
                signals[bssid] = -40.0 - 20.0 * math.log10(distance) + noise.gauss(0.0, 2.5)
            signals[ALIAS] = signals[FIRST] + noise.gauss(0.0, 0.8)
            if step == 0:
                signals[RARE] = -80.0
            table += ["%.1f,%.3f,%.3f,%s,%.1f" % (stamp, x, y, *heard)
                      for heard in sorted(signals.items())]
            stamp += 0.5
    return "\n".join([HEADER] + table) + "\n"


class AccessPoints(CommandLine):
    def setUp(self):
        super().setUp()
        self.readings = self.write("hall.csv", hall())

    def table(self, *more):
        return self.good(self.sfw("access-points", "--readings", self.readings, *more))

    def near(self, entry, place):
        self.assertLess(math.hypot(entry["x"] - place[0], entry["y"] - place[1]), 1.0)

    def test_are_printed_as_a_table_with_their_certainty(self):
        text = self.table().stdout
        entries = {one["bssid"]: one for one in yaml.safe_load(text)["access_points"]}
        self.assertEqual(sorted(entries), sorted([FIRST, ALIAS, SECOND, RARE]))
        self.near(entries[FIRST], PLACES[FIRST])
        self.near(entries[SECOND], PLACES[SECOND])
        self.assertEqual(entries[ALIAS]["x"], entries[FIRST]["x"])
        self.assertNotIn("x", entries[RARE])
        self.assertRegex(text, FIRST + r".*# 480 readings, \+- 0\.\d m\n")
        self.assertRegex(text, ALIAS + ".*one radio with " + FIRST)
        self.assertRegex(text, RARE + ".*8 readings, too few to place it")

    def test_can_be_read_again(self):
        table = self.folder / "table.yaml"
        self.assertEqual(self.table("--output", table).stdout, "")
        self.good(self.map(access_points=table))

    def test_keep_their_names(self):
        table = self.write("names.yaml", "access_points: [{bssid: '%s', name: hall}]" % SECOND)
        entry, = yaml.safe_load(self.table("--access-points", table).stdout)["access_points"]
        self.assertEqual(entry["name"], "hall")
        self.near(entry, PLACES[SECOND])

    def test_that_may_stand_elsewhere_are_moved_by_the_readings(self):
        x, y = PLACES[SECOND]
        table = self.write("about.yaml", "access_points: [{bssid: '%s', x: %g, y: %g, "
                                         "position_sd: 2}]" % (SECOND, x - 2.0, y))
        entry, = yaml.safe_load(self.table("--access-points", table).stdout)["access_points"]
        self.near(entry, PLACES[SECOND])
        self.assertNotIn("position_sd", entry, "the readings would count twice")
        self.good(self.map(access_points=table))
        found, = json.loads((self.output / "report.json").read_text())["access_points"]
        self.near(found, PLACES[SECOND])
        self.assertEqual(found["given"], {"x": x - 2.0, "y": y, "sd_m": 2.0})
        self.assertLess(found["estimated"]["sd_x_m"], 2.0)
        self.assertFalse(found["fit"]["suspect"])

    def test_are_scaled_with_their_deviation(self):
        rows = [row.split(",") for row in hall().splitlines()[1:]]
        centimetres = [",".join([t, "%g" % (100 * float(x)), "%g" % (100 * float(y)), *heard])
                       for t, x, y, *heard in rows]
        readings = self.write("cm.csv", "\n".join([HEADER] + centimetres) + "\n")
        table = self.write("cm.yaml", "access_points: [{bssid: '%s', x: 800, y: 450, "
                                      "position_sd: 200}]" % SECOND)
        self.good(self.sfw("map", "--readings", readings, "--access-points", table,
                           "--scale", "0.01", "--output", self.output))
        found, = json.loads((self.output / "report.json").read_text())["access_points"]
        self.assertEqual(found["given"], {"x": 8.0, "y": 4.5, "sd_m": 2.0})
        self.near(found, PLACES[SECOND])

    def test_of_nothing(self):
        nothing = self.write("nothing.csv", HEADER + "\n0,1,1,%s,55\n" % FIRST)
        run = self.sfw("access-points", "--readings", nothing)
        self.assertEqual(run.returncode, 0)
        self.assertIn("too few to place it", run.stdout)
        self.bad(self.sfw("access-points"), "exactly one of --readings and --bag")
        self.bad(self.sfw("access-points", "--readings", self.folder / "none.csv"), "none.csv")

    def test_of_no_table_are_all_that_are_heard(self):
        run = self.good(self.sfw("map", "--readings", self.readings, "--output", self.output))
        self.assertIn("2 BSSIDs are 1 radio under several BSSIDs", run.stderr)
        self.assertNotIn("left out", run.stderr)
        report = json.loads((self.output / "report.json").read_text())
        self.assertFalse(report["has_table"])
        found = {one["bssid"]: one for one in report["access_points"]}
        self.assertEqual(found[ALIAS]["radio"], FIRST)
        self.assertIn("estimated", found[SECOND])
        self.assertIn("left_out", found[RARE])
        empty = self.write("empty.yaml", "access_points: []\n")
        self.good(self.map(access_points=empty, output=self.folder / "again"))
        self.assertEqual((self.folder / "again" / "map.pgm").read_bytes(),
                         (self.output / "map.pgm").read_bytes())

    def test_of_no_table_serve_the_ablations(self):
        self.good(self.sfw("map", "--readings", self.readings, "--output", self.output))
        judge = ["evaluate", "--map", self.output / "map.yaml", "--truth",
                 self.output / "map.yaml", "--readings", self.readings, "--ablations", "--json"]
        self.assertIn("no_radio", json.loads(self.good(self.sfw(*judge)).stdout)["ablations"])


if __name__ == "__main__":
    junit.run()
