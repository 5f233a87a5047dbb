"""A simulated drive in a bag, for tests that change the bag and compare the maps."""

import copy
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import rosbag

COMPARED = ("map.pgm", "probability.pgm", "map.bt")
EQUAL_IOU = 0.02


def sfw(*arguments, status=0):
    """The output of sfw on stderr, or on stdout for JSON."""
    run = subprocess.run([sys.argv[1]] + [str(a) for a in arguments], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True, timeout=300)
    if run.returncode != status:
        raise AssertionError("sfw %s: status %d\n%s" % (" ".join(map(str, arguments)),
                                                        run.returncode, run.stderr))
    return run.stdout if "--json" in arguments else run.stderr


class Drive:
    """A simulated drive, its messages, and the map of its bag."""

    def __init__(self, seed):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw_bags_"))
        sfw("simulate", "--generate", "flat", "--noise", "realistic", "--access-points", 2,
            "--bag", "--seed", seed, "--output", self.folder)
        with rosbag.Bag(str(self.folder / "recording.bag")) as bag:
            self.messages = [(topic, message, stamp) for topic, message, stamp
                             in bag.read_messages()]
        self.start = self.messages[0][2].to_sec()
        self.said = self.map("plain", self.folder / "recording.bag")
        self.iou = self.iou_of("plain")

    def write(self, name, messages, compression="none"):
        file = self.folder / (name + ".bag")
        with rosbag.Bag(str(file), "w", compression=compression) as bag:
            for topic, message, stamp in messages:
                bag.write(topic, message, stamp)
        return file

    def map(self, name, *bags_and_options, status=0):
        """What `sfw map` says of bags."""
        bags = [part for file in bags_and_options if isinstance(file, pathlib.Path)
                for part in ("--bag", file)]
        options = [part for part in bags_and_options if not isinstance(part, pathlib.Path)]
        return sfw("map", *bags, *options, "--access-points", self.folder / "access_points.yaml",
                   "--output", self.folder / name, status=status)

    def iou_of(self, name):
        return json.loads(sfw("evaluate", "--map", self.folder / name / "map.yaml", "--truth",
                              self.folder / "truth.yaml", "--readings",
                              self.folder / "readings.csv", "--json"))["map"]["free_iou"]

    def bytes_of(self, name):
        return [(self.folder / name / file).read_bytes() for file in COMPARED]


def changed(message, change):
    """A copy of a message that was changed."""
    message = copy.deepcopy(message)
    change(message)
    return message


def is_tf(topic):
    return topic == "/tf"


class DriveTest(unittest.TestCase):
    """Maps a drive once in one plain bag."""

    @classmethod
    def setUpClass(cls):
        cls.drive = Drive(1)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.drive.folder, ignore_errors=True)

    def gives_the_same(self, name, *bags_and_options):
        said = self.drive.map(name, *bags_and_options)
        self.assertEqual(self.drive.bytes_of(name), self.drive.bytes_of("plain"), said)
        self.assertNotIn("left out", said)
        return said

    def is_as_good(self, name, messages):
        said = self.drive.map(name, self.drive.write(name, messages))
        iou = self.drive.iou_of(name)
        print("\n%-10s IoU %.3f, of the whole drive %.3f" % (name, iou, self.drive.iou))
        self.assertGreater(iou, self.drive.iou - EQUAL_IOU, said)
