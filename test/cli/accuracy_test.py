#!/usr/bin/env python3
"""Runs scripts/accuracy on made-up recordings and a small home.

Usage: accuracy_test.py RESULT.xml SFW
"""

import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import CommandLine  # noqa: E402

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "accuracy"
RECORDINGS = {"turtlebot_home_a": ["two_routers", "one_router"], "ble_flat": ["survey"],
              "cetc331_f2": ["tour"], "hcxy": ["tour"]}
# Two rooms with a door between them, as HouseExpo draws them.
HOME = """{"verts": [[0, 0], [3, 0], [3, 1], [3.1, 1], [3.1, 0], [5, 0], [5, 3], [3.1, 3],
    [3.1, 2], [3, 2], [3, 3], [0, 3]]}"""


class Accuracy(CommandLine):
    def accuracy(self, data):
        return subprocess.run([sys.executable, SCRIPT, "--sfw", sys.argv[1], "--output",
                               self.output, data], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=900)

    def test_what_is_missing_is_named(self):
        self.bad(self.accuracy(self.folder / "nothing"), "two_routers.csv", "survey.csv",
                 "houseexpo")

    @unittest.skipUnless(shutil.which("convert"), "ImageMagick is missing")
    def test_tables_and_pictures(self):
        data = self.folder / "data"
        homes = data / "floorplans" / "houseexpo"
        homes.mkdir(parents=True)
        for name in ("a", "b"):
            (homes / (name + ".json")).write_text(HOME)
        for folder, names in RECORDINGS.items():
            drive = data / "recordings" / folder
            self.good(self.sfw("simulate", "--plan", homes / "a.json", "--access-point-count", 1,
                               "--output", drive))
            for name in names:
                shutil.copy(drive / "readings.csv", drive / (name + ".csv"))
            shutil.copy(drive / "truth.yaml", drive / "truth_seen.yaml")
        run = self.good(self.accuracy(data))
        self.assertEqual((self.output / "tables.md").read_text() + "\n", run.stdout)
        for row in (r"\| home, one router \| shipped \| (\.\d{2}|1\.00) \|",
                    r"\|  \| shifted radio \|",
                    r"\| realistic \| shipped \| (\.\d{2}|1\.00) ± \.00 \|"):
            self.assertRegex(run.stdout, row)
        self.assertEqual([path.name for path in sorted(self.output.glob("*.png"))],
                         ["ble_flat_survey.png", "cetc331_f2_tour.png", "hcxy_tour.png",
                          "homes_1.png", "turtlebot_home_a_one_router.png",
                          "turtlebot_home_a_two_routers.png"])


if __name__ == "__main__":
    junit.run()
