#!/usr/bin/env python3
"""Runs `sfw localise` on a simulated hall, and on bad input.

Usage: localise_test.py RESULT.xml SFW
"""

import csv
import json
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, CommandLine  # noqa: E402

RADIOS = [(0.0, 0.0), (12.0, 0.0), (0.0, 8.0), (12.0, 8.0), (6.0, 4.0)]


def readings(first_lane, start, shift=0.0):
    """Lanes of 12 m, 2 m apart, at 0.5 m/s."""
    noise = random.Random(first_lane + start)
    table, stamp = [], start
    for lane in range(4):
        y = first_lane + 2.0 * lane
        for step in range(25):
            x = 0.5 * step if lane % 2 == 0 else 12.0 - 0.5 * step
            for number, (at_x, at_y) in enumerate(RADIOS):
                distance = math.hypot(x - at_x, y - at_y, 1.0)
                table.append((stamp, x + shift, y + shift, "02:00:00:00:00:%02x" % (number + 1),
                              -40.0 - 25.0 * math.log10(distance) + noise.gauss(0.0, 2.0)))
            stamp += 1.0
    return table


def text(table):
    return "\n".join([HEADER] + ["%.3f,%.4f,%.4f,%s,%.1f" % row for row in table]) + "\n"


class Localise(CommandLine):
    def setUp(self):
        super().setUp()
        self.mapped = self.write("mapped.csv", text(readings(0.0, 0.0)))
        self.unknown = self.write("unknown.csv", text(readings(1.0, 1000.0)))
        self.output = self.folder / "poses.csv"

    def localise(self, *more, mapped=None, unknown=None):
        return self.sfw("localise", "--map-readings", mapped or self.mapped, "--readings",
                        unknown or self.unknown, *more)

    def errors(self, *more, **files):
        return json.loads(self.good(self.localise("--json", *more, **files)).stdout)

    def test_prints_errors_beside_nearest_fingerprints(self):
        printed = self.good(self.localise()).stdout
        for word in ("mean", "median", "90 %", "particle filter", "one scan alone",
                     "nearest fingerprints"):
            self.assertIn(word, printed)
        errors = self.errors()
        self.assertEqual(errors["particle_filter"]["scans"], 100)
        self.assertLess(errors["particle_filter"]["median_m"],
                        errors["nearest_fingerprints"]["median_m"])
        self.assertLess(errors["particle_filter"]["median_m"], 1.2)

    def test_writes_poses_that_map_can_read_as_a_path(self):
        self.good(self.localise("--output", self.output))
        with open(self.output) as file:
            poses = list(csv.DictReader(file))
        self.assertEqual(len(poses), 100)
        self.assertEqual(list(poses[0]), ["stamp", "x", "y", "var_x", "cov_xy", "var_y", "sure"])
        for pose in poses:
            self.assertGreater(float(pose["var_x"]), 0.0)
            self.assertLessEqual(float(pose["sure"]), 1.0)
        self.good(self.localise("--path", self.output))

    def test_the_same_seed_gives_the_same_bytes(self):
        outputs = []
        for seed in (1, 1, 2):
            self.good(self.localise("--seed", seed, "--output", self.output))
            outputs.append(self.output.read_bytes())
        self.assertEqual(outputs[0], outputs[1])
        self.assertNotEqual(outputs[0], outputs[2])

    def test_readings_need_no_positions(self):
        rows = ["%.3f,%s,%.1f" % (row[0], row[3], row[4]) for row in readings(1.0, 1000.0)]
        unknown = self.write("bare.csv", "\n".join(["stamp,bssid,rssi_dbm"] + rows) + "\n")
        run = self.good(self.localise("--output", self.output, unknown=unknown))
        self.assertEqual(run.stdout, "")
        self.assertEqual(len(self.output.read_text().splitlines()), 101)

    def test_far_frames_do_no_harm(self):
        far = 4_500_000.0
        mapped = self.write("far_mapped.csv", text(readings(0.0, 0.0, far)))
        unknown = self.write("far_unknown.csv", text(readings(1.0, 1000.0, far)))
        self.assertLess(self.errors(mapped=mapped, unknown=unknown)["particle_filter"]["median_m"],
                        1.2)

    def test_odometry_in_a_frame_of_its_own_helps(self):
        poses = ["%.3f,%.4f,%.4f" % (row[0], 30.0 - row[2], row[1] + 7.0)
                 for row in readings(1.0, 1000.0)[::len(RADIOS)]]
        odometry = self.write("odometry.csv", "\n".join(["stamp,x,y"] + poses) + "\n")
        self.assertLess(self.errors("--odometry", odometry)["particle_filter"]["mean_m"],
                        1.1 * self.errors()["particle_filter"]["mean_m"])

    def test_says_what_is_wrong(self):
        self.bad(self.sfw("localise", "--readings", self.unknown), "--map-readings is missing")
        self.bad(self.localise(mapped=self.folder / "none.csv"), "none.csv")
        strange = self.write("strange.csv",
                             text(readings(1.0, 1000.0)).replace("02:00:00:00:00", "0a:0b:0c:0d:0e"))
        self.bad(self.localise("--output", self.output, unknown=strange), "strange.csv",
                 "no scan holds a BSSID of the radio map", "mapped.csv")
        early = self.write("early.csv", "stamp,x,y\n1,0,0\n2,1,0\n")
        self.bad(self.localise("--odometry", early, "--output", self.output), "early.csv", "clock")
        self.bad(self.localise("--scan-window", "-1"), "--scan-window")
        stray = self.write("stray.csv", text(readings(0.0, 0.0) +
                                             [(500.0, 9e6, 9e6, "02:00:00:00:00:01", -50.0)]))
        self.bad(self.localise(mapped=stray, unknown=self.unknown), "stray.csv", "stray positions")

    def test_warns_of_scans_without_known_radios(self):
        lonely = readings(1.0, 1000.0) + [(5000.0, 1.0, 1.0, "0a:0b:0c:0d:0e:0f", -50.0)]
        run = self.good(self.localise(unknown=self.write("lonely.csv", text(lonely))))
        self.assertIn("1 of 101 scans hold no BSSID of the radio map", run.stderr)


if __name__ == "__main__":
    junit.run()
