#!/usr/bin/env python3
"""Cuts a drive in two halves that two robots drive at the same time, and compares with its map.

Usage: bag_robots_test.py RESULT.xml SFW
"""

import csv
import json
import os
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
import genpy  # noqa: E402
from bag_drive import EQUAL_IOU, DriveTest, changed, is_tf, sfw  # noqa: E402

CASES = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"), "cases")
KNOWS_WALL = "knows_wall_f1"


class BagRobots(DriveTest):
    def robots(self, topic_of, frame_of):
        """Both halves of the drive, in order of time."""
        begin, end = self.drive.messages[0][2], self.drive.messages[-1][2]
        half = genpy.Duration.from_sec((end - begin).to_sec() / 2)

        def rename(robot, message):
            for one in message.transforms:
                one.header.stamp -= half if robot == "robot2" else genpy.Duration()
                for header, field in ((one.header, "frame_id"), (one, "child_frame_id")):
                    name = getattr(header, field)
                    setattr(header, field, name if name == "map" else robot + "/" + name)

        def name_robot(robot, message):
            message.header.stamp -= half if robot == "robot2" else genpy.Duration()
            message.header.frame_id = frame_of(robot)

        messages = []
        for topic, message, stamp in self.drive.messages:
            robot = "robot1" if stamp - begin < half else "robot2"
            message = changed(message, lambda m: (rename if is_tf(topic) else name_robot)(robot, m))
            messages.append((topic if is_tf(topic) else topic_of(robot), message,
                             stamp - half if robot == "robot2" else stamp))
        return sorted(messages, key=lambda entry: entry[2])

    def check(self, name, said):
        iou = self.drive.iou_of(name)
        print("\n%s: IoU %.3f, of the drive %.3f" % (name, iou, self.drive.iou))
        self.assertGreater(iou, self.drive.iou - EQUAL_IOU, said)
        self.assertNotIn("warning", said)

    FRAMES = ("--antenna-frame", "robot1/base_link", "robot2/base_link")

    def test_on_one_topic(self):
        bag = self.drive.write("one_topic", self.robots(lambda robot: "/wifi_scan",
                                                        lambda robot: "/" + robot + "/base_link"))
        self.check("one_topic", self.drive.map("one_topic", bag, *self.FRAMES))

    def test_on_a_topic_each(self):
        bag = self.drive.write("two_topics", self.robots(lambda robot: "/%s/wifi_scan" % robot,
                                                         lambda robot: robot + "/base_link"))
        self.check("two_topics", self.drive.map("two_topics", bag, *self.FRAMES, "--scan-topic",
                                                "/robot1/wifi_scan", "/robot2/wifi_scan"))

    def test_without_frames_on_a_topic_each(self):
        bag = self.drive.write("no_frames", self.robots(lambda robot: "/%s/wifi_scan" % robot,
                                                        lambda robot: ""))
        self.check("no_frames", self.drive.map("no_frames", bag, *self.FRAMES, "--scan-topic",
                                               "/robot1/wifi_scan", "/robot2/wifi_scan"))

    def test_without_frames_on_one_topic_no_robot_is_guessed(self):
        bag = self.drive.write("guess", self.robots(lambda robot: "/wifi_scan", lambda robot: ""))
        said = self.drive.map("guess", bag, *self.FRAMES, status=1)
        self.assertIn("a message without a frame does not name its robot; publish it in the "
                      "namespace of its robot, robot1 or robot2", said)

    def test_the_settings_name_the_frames_too(self):
        bag = self.drive.write("by_settings", self.robots(lambda robot: "/wifi_scan",
                                                          lambda robot: robot + "/base_link"))
        settings = self.drive.folder / "settings.yaml"
        settings.write_text("ros: {antenna_frames: robot1/base_link robot2/base_link}\n")
        self.check("by_settings", self.drive.map("by_settings", bag, "--config=%s" % settings))

    def test_a_frame_of_no_robot_is_told(self):
        bag = self.drive.write("typo", self.robots(lambda robot: "/wifi_scan",
                                                   lambda robot: robot + "/base_link"))
        said = self.drive.map("typo", bag, "--antenna-frame", "robot1/base_link", "robot2/base")
        self.assertIn("readings or contacts left out: the frame of a scan, 'robot2/base_link', is "
                      "none of ros/antenna_frames", said)

    def test_a_robot_without_transforms_is_named(self):
        messages = self.robots(lambda robot: "/wifi_scan", lambda robot: robot + "/base_link")

        def drop(message):
            message.transforms = [one for one in message.transforms
                                  if one.child_frame_id != "robot2/odom"]
        bag = self.drive.write("lost", [
            (topic, changed(message, drop) if is_tf(topic) else message, stamp)
            for topic, message, stamp in messages])
        said = self.drive.map("lost", bag, *self.FRAMES)
        self.assertIn("no transform from robot2/base_link to map", said)
        self.assertNotIn("robot1/base_link to map", said)

    def test_an_odometry_frame_goes_with_one_robot(self):
        said = self.drive.map("odom", self.drive.folder / "recording.bag", *self.FRAMES,
                              "--odom-frame", "odom", status=1)
        self.assertIn("ros/odom_frame must be empty or ros/map_frame", said)


@unittest.skipUnless(CASES.is_dir(), "no recordings: set SFW_SHARED to a folder with cases")
class RecordedDrive(unittest.TestCase):
    """The same for a CSV."""

    @classmethod
    def setUpClass(cls):
        with open(CASES / "drive.csv") as file:
            cls.rows = list(csv.DictReader(file))

    def map(self, rows, folder):
        """The metrics of the map, and what was said."""
        folder.mkdir(parents=True)
        with open(folder / "readings.csv", "w") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
        said = sfw("map", "--readings", folder / "readings.csv", "--access-points",
                   CASES / "access_points.yaml", "--output", folder / "map")
        score = json.loads(sfw("evaluate", "--map", folder / "map" / "map.yaml", "--truth",
                               CASES / "truth.yaml", "--readings", CASES / "drive.csv",
                               "--json"))
        return score["map"], said

    def test_two_halves_at_once(self):
        stamps = [float(row["stamp"]) for row in self.rows]
        half = (stamps[-1] - stamps[0]) / 2
        halves = []
        for row, stamp in zip(self.rows, stamps):
            is_second = stamp - stamps[0] >= half
            halves.append(dict(row, stamp="%.9f" % (stamp - half * is_second),
                               robot="robot2" if is_second else "robot1"))
        halves.sort(key=lambda row: float(row["stamp"]))
        nameless = [{key: row[key] for key in row if key != "robot"} for row in halves]
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            whole, _ = self.map(self.rows, folder / "whole")
            both, said = self.map(halves, folder / "both")
            one, taken_for_one = self.map(nameless, folder / "one")
        for name, score in (("drive", whole), ("two robots", both), ("taken for one", one)):
            print("\n%s: IoU %.3f, knows the wall %.3f" % (name, score["free_iou"],
                                                           score[KNOWS_WALL]))
        self.assertAlmostEqual(both["free_iou"], whole["free_iou"], delta=EQUAL_IOU)
        self.assertAlmostEqual(both[KNOWS_WALL], whole[KNOWS_WALL], delta=EQUAL_IOU)
        self.assertNotIn("warning", said)
        # Walls get lost then, so more is free, also what is free in truth.
        self.assertLess(one[KNOWS_WALL], whole[KNOWS_WALL] - 0.1)
        self.assertIn("the path is in two places at once", taken_for_one)


if __name__ == "__main__":
    junit.run()
