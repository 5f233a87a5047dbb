#!/usr/bin/env python3
"""Runs `sfw` with an output that it cannot write.

Usage: bad_output_test.py RESULT.xml SFW
"""

import json
import os
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import MAP_FILES, CommandLine  # noqa: E402


class BadOutput(CommandLine):
    def test_a_file_in_the_way(self):
        way = self.write("way", "mine")
        for output in (way, way / "below"):
            with self.subTest(output=output):
                self.bad(self.map(output=output), output)
                self.assertEqual(way.read_text(), "mine")

    def test_a_directory_that_nobody_can_make(self):
        # /proc refuses root as well.
        self.bad(self.map(output="/proc/sfw_map"), "/proc/sfw_map")

    def test_a_directory_in_the_place_of_a_file(self):
        (self.output / "map.yaml").mkdir(parents=True)
        run = self.map()
        self.assertEqual(run.returncode, 1)
        self.assertIn("map.yaml", run.stderr)
        self.assertEqual([path.name for path in self.output.iterdir()
                          if path.name not in MAP_FILES], [])

    @unittest.skipIf(os.geteuid() == 0, "root writes everywhere")
    def test_a_directory_without_permission(self):
        self.output.mkdir(mode=0o555)
        run = self.map()
        self.assertEqual(run.returncode, 1)
        self.assertIn(str(self.output), run.stderr)
        self.assertEqual(list(self.output.iterdir()), [])

    def test_a_model_that_cannot_be_written_is_told_before_it_is_fitted(self):
        run = self.sfw("fit", "--drives", 10, "--cells", 10, "--output", "/proc/sfw_fit/model.yaml")
        self.bad(run, "/proc/sfw_fit")

    def test_a_folder_of_drives_that_cannot_be_made_is_told_before_they_are_simulated(self):
        run = self.sfw("wall-drives", "--drives", 100000, "--output", "/proc/sfw_drives")
        self.bad(run, "/proc/sfw_drives")
        self.assertNotIn("done", run.stderr)

    def test_a_picture_that_cannot_be_written_costs_no_metrics(self):
        self.good(self.map())
        run = self.sfw("evaluate", "--map", self.output / "map.yaml", "--truth",
                       self.output / "map.yaml", "--readings", self.readings, "--json",
                       "--picture", "/proc/sfw.png")
        self.assertEqual(run.returncode, 1)
        self.assertIn("/proc/sfw.png", run.stderr)
        self.assertEqual(json.loads(run.stdout)["map"]["free_precision"], 1.0)

    def test_a_full_standard_output(self):
        self.good(self.map())
        with open("/dev/full", "w") as full:
            status = subprocess.run(
                [sys.argv[1], "evaluate", "--map", self.output / "map.yaml", "--truth",
                 self.output / "map.yaml", "--readings", self.readings, "--json"], stdout=full,
                stderr=subprocess.DEVNULL, timeout=60).returncode
        self.assertEqual(status, 1)


if __name__ == "__main__":
    junit.run()
