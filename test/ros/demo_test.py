#!/usr/bin/env python3
"""Starts demo.launch as its users do: on plans of each kind, by hand, and with mistakes.

Usage: demo_test.py RESULT.xml
"""

import csv
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

PLANS = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"), "data", "floorplans")
# Two rooms of 3 x 3 m with a door between them, as HouseExpo draws them.
TWO_ROOMS = """{"verts": [[0, 0], [3, 0], [3, 1], [3.1, 1], [3.1, 0], [6.1, 0], [6.1, 3], [3.1, 3],
    [3.1, 2], [3, 2], [3, 3], [0, 3]]}"""
CELL = 0.05  # [m], the mapper's default


class Demo(unittest.TestCase):
    def setUp(self):
        self.session = RosSession()
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)

    def write(self, name, text):
        path = self.session.folder / name
        path.write_text(text)
        return path

    def launch(self, **arguments):
        words = ["%s:=%s" % item for item in arguments.items()]
        return self.session.start("demo", "roslaunch", ROOT / "launch" / "demo.launch",
                                  "rviz:=false", "save_directory:=%s" % self.session.folder, *words)

    def latest(self, topic, *options):
        """One message of a topic, or nothing within a few seconds."""
        try:
            return self.session.run("rostopic", "echo", "-n", 1, *options, topic, seconds=5)
        except subprocess.TimeoutExpired:
            return ""

    def is_true(self, topic):
        return self.latest(topic, "--filter", "m.data")

    def saved(self):
        """The folder into which the mapper saves its map."""
        text = self.session.run("rosservice", "call", "/mapping/save_map", "directory: saved")
        self.assertIn("success: True", text)
        return self.session.folder / "saved"

    def free_area(self):
        """Of the saved map [m2]."""
        pixels = (self.saved() / "map.pgm").read_bytes()
        header = re.match(rb"P5\s+(?:#.*\s+)*(\d+)\s+(\d+)\s+255\s", pixels)
        cells = pixels[header.end():]
        self.assertEqual(len(cells), int(header.group(1)) * int(header.group(2)))
        return cells.count(254) * CELL * CELL

    def maps(self, **arguments):
        """Drives to the end of the route; the free area found."""
        demo = self.launch(time_scale=20, **arguments)
        try:
            wait_until(lambda: self.is_true("/finished"), 90, "the end of the drive")
            return self.free_area()
        except (AssertionError, TimeoutError) as error:
            raise AssertionError("%s\n%s" % (error, self.session.text_of(demo)))

    def refuses(self, *words, **arguments):
        demo = self.launch(**arguments)
        wait_until(lambda: demo.poll() is not None, 30, "the end of roslaunch")
        for word in words:
            self.assertIn(word, self.session.text_of(demo))

    def test_maps_a_houseexpo_plan(self):
        free = self.maps(plan=self.write("two rooms.json", TWO_ROOMS), noise="moderate", drift=0.01,
                         seed=3)
        self.assertGreater(free, 9.0)
        self.assertLess(free, 25.0)  # the rooms have 18 m2

    def test_maps_a_building_made_up(self):
        self.assertGreater(self.maps(generate="flat", route="sparse", access_point_count=3), 15.0)

    @unittest.skipUnless(PLANS.is_dir(), "no floor plans: set SFW_SHARED to a folder with "
                                         "data/floorplans")
    def test_maps_a_shared_plan(self):
        plan = min((PLANS / "houseexpo").glob("*.json"), key=lambda path: path.stat().st_size)
        self.assertGreater(self.maps(plan=plan), 10.0)

    def test_cmd_vel_drives_into_a_wall_and_the_mapper_learns_of_it(self):
        route = self.write("start.csv", "x,y\n2,0.5\n1,0.5\n")
        self.launch(plan=self.write("two_rooms.json", TWO_ROOMS), drive="cmd_vel", route=route)
        wait_until(lambda: self.latest("/map/info"), 20, "the map")
        self.session.start("teleop", "rostopic", "pub", "-r", 10, "/cmd_vel", "geometry_msgs/Twist",
                           "{linear: {x: 0.5}}")
        wait_until(lambda: self.is_true("/contact"), 30, "the contact")

        def contacts():
            with open(self.saved() / "contacts.csv") as table:
                return list(csv.DictReader(table))
        rows = wait_until(contacts, 20, "a contact in the recording")
        self.assertEqual(len(rows), 1)
        self.assertAlmostEqual(float(rows[0]["x"]), 0.0, delta=0.06)
        self.assertAlmostEqual(float(rows[0]["y"]), 0.5, delta=0.06)

    def test_names_what_it_cannot_use(self):
        missing = self.session.folder / "missing.json"
        self.refuses("missing.json", "No such file", plan=missing)
        plan = self.write("two_rooms.json", TWO_ROOMS)
        route = self.write("blocked.csv", "x,y\n1,1\n3.05,0.5\n")
        self.refuses("blocked.csv: way point 2 (3.05, 0.50) is not free", plan=plan, route=route)
        self.refuses("route walls: ", "robot", plan=plan, robot_radius=1.6)
        self.refuses("noise: 'loud' is no noise level", plan=plan, noise="loud")


if __name__ == "__main__":
    junit.run()
