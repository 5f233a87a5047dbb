#!/usr/bin/env python3
"""Starts navigate.launch, without move_base and, where it is installed, with it.

Usage: navigate_test.py RESULT.xml
"""

import json
import pathlib
import subprocess
import sys
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

SETTINGS = ROOT / "config" / "move_base"
HAS_MOVE_BASE = subprocess.run(["rospack", "find", "move_base"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL).returncode == 0


def costmap(name):
    """The settings of a costmap as navigate.launch loads them: the second file overrides."""
    merged = yaml.safe_load((SETTINGS / "costmap_common.yaml").read_text())
    for key, value in yaml.safe_load((SETTINGS / (name + "_costmap.yaml")).read_text()).items():
        merged[key] = {**merged[key], **value} if isinstance(value, dict) else value
    return merged


class Settings(unittest.TestCase):
    def test_unknown_cells_are_unknown_in_the_global_costmap_only(self):
        for name, tracked in (("global", True), ("local", False)):
            self.assertEqual(costmap(name)["track_unknown_space"], tracked)
            self.assertEqual(costmap(name)["static_layer"]["track_unknown_space"], tracked)

    def test_both_costmaps_read_the_costs(self):
        for name in ("global", "local"):
            layer = costmap(name)["static_layer"]
            self.assertEqual(layer["map_topic"], "map_costs")
            self.assertFalse(layer["first_map_only"])
        self.assertFalse(costmap("global")["static_layer"]["trinary_costmap"],
                         "costs below 100 would count as free")

    def test_a_robot_that_touches_something_does_not_collide_in_the_local_costmap(self):
        cell = costmap("local")["resolution"]
        self.assertLessEqual(costmap("local")["robot_radius"] + cell,
                             costmap("global")["robot_radius"] + 1e-9)


class Launch(unittest.TestCase):
    def setUp(self):
        self.session = RosSession()
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)

    def launch(self, **arguments):
        words = ["%s:=%s" % item for item in arguments.items()]
        return self.session.start("navigate", "roslaunch", ROOT / "launch" / "navigate.launch",
                                  "rviz:=false", "save_directory:=%s" % self.session.folder, *words)

    def parameter(self, name):
        code, _, value = self.session.master().getParam("/test", name)
        return value if code == 1 else None

    def has_publisher(self, topic):
        return topic in [name for name, _ in self.session.master().getSystemState("/test")[2][0]]

    def test_the_simulated_robot_waits_for_commands(self):
        self.launch(move_base="false", robot_radius=0.2)
        wait_until(lambda: self.has_publisher("/map_costs") and self.has_publisher("/odom"), 30,
                   "the costs and the odometry")
        self.assertEqual(self.parameter("/simulator/drive"), "cmd_vel")
        self.assertEqual(self.parameter("/simulator/robot_radius"), 0.2)
        self.assertEqual(self.parameter("/mapping/path/footprint_radius"), 0.2)

    def test_a_real_robot_needs_no_simulator(self):
        self.launch(move_base="false", simulator="false", map_costs="floor_costs",
                    access_points=ROOT / "config" / "demo" / "access_points.yaml")
        wait_until(lambda: self.has_publisher("/floor_costs"), 30, "the costs")
        self.assertFalse(self.has_publisher("/odom"))
        self.assertIsNone(self.parameter("/simulator/drive"))

    @unittest.skipIf(HAS_MOVE_BASE, "move_base is installed")
    def test_names_move_base_if_it_is_missing(self):
        launch = self.launch()
        wait_until(lambda: launch.poll() is not None, 30, "the end of roslaunch")
        self.assertIn("move_base_must_be_installed", self.session.text_of(launch))

    @unittest.skipUnless(HAS_MOVE_BASE, "move_base is not installed")
    def test_move_base_reaches_a_goal_from_a_cold_start(self):
        flat = ROOT / "config" / "demo" / "flat.yaml"
        output = self.session.run(ROOT / "scripts" / "navigation", "cold", flat, "--goals", 1,
                                  seconds=300)
        self.assertEqual(json.loads(output.splitlines()[0])["outcome"], "reached", output)


if __name__ == "__main__":
    junit.run()
