#!/usr/bin/env python3
"""Maps the recordings with the shipped settings and holds the maps against the truth.

Usage: recordings_test.py RESULT.xml SFW
Needs ../shared beside the repository; SFW_SHARED names another place. Skips without it.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECORDINGS = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"),
                          "data", "recordings")
SHOWN = ["knows_wall_f1", "knows_wall_auc", "plans_through_walls", "places_reached",
         "free_precision", "free_precision_tolerant", "free_recall", "free_iou", "beyond_m2",
         "beyond_precision", "wall_f1_2", "wall_in_free", "walls_called_free", "auc"]


def text(value):
    return "       -" if value is None else "%8.3f" % value


@unittest.skipUnless(RECORDINGS.is_dir(), "%s is missing; SFW_SHARED may name the folder of the "
                     "recordings" % RECORDINGS)
class Recordings(unittest.TestCase):
    def setUp(self):
        self.output = pathlib.Path(tempfile.mkdtemp(prefix="sfw_recordings_"))
        self.addCleanup(shutil.rmtree, self.output)

    def sfw(self, *arguments):
        run = subprocess.run([sys.argv[1], *map(str, arguments)], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def metrics(self, folder, name):
        """Maps a recording, prints the map's metrics beside those of the path, returns them."""
        recording = RECORDINGS / folder
        readings = ["--readings", recording / name]
        access_points = ["--access-points", recording / "access_points.yaml"]
        self.sfw("map", *readings, *access_points, "--config", ROOT / "config" / "mapping.yaml",
                 "--output", self.output)
        metrics = json.loads(self.sfw(
            "evaluate", "--map", self.output / "map.yaml", "--truth", recording / "truth.yaml",
            *readings, *access_points, "--json"))
        print("\n%-34s %8s %9s" % (folder + "/" + name, "map", "path only"))
        for metric in SHOWN:
            print("  %-32s %s  %s" % (metric, text(metrics["map"][metric]),
                                      text(metrics["path_only"][metric])))
        return metrics["map"]

    def check(self, folder, name, precision, iou, knows_wall_f1):
        metrics = self.metrics(folder, name)
        self.assertGreaterEqual(metrics["free_precision"], precision)
        self.assertGreaterEqual(metrics["free_iou"], iou)
        self.assertGreaterEqual(metrics["knows_wall_f1"], knows_wall_f1)
        return metrics

    def test_two_routers(self):
        metrics = self.check("turtlebot_home_a", "two_routers.csv", 0.89, 0.78, 0.72)
        self.assertLessEqual(metrics["plans_through_walls"], 0.15)

    def test_one_router(self):
        metrics = self.check("turtlebot_home_a", "one_router.csv", 0.89, 0.78, 0.55)
        self.assertLessEqual(metrics["plans_through_walls"], 0.25)

    def test_ble_flat(self):
        metrics = self.check("ble_flat", "survey.csv", 0.94, 0.78, 0.74)
        self.assertLessEqual(metrics["plans_through_walls"], 0.15)


if __name__ == "__main__":
    junit.run()
