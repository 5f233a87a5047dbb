#!/usr/bin/env python3
"""Maps bags as people have them, and compares with the map of the same drive in one plain bag.

Usage: bag_recordings_test.py RESULT.xml SFW
"""

import copy
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
import rosbag  # noqa: E402
from sensor_msgs.msg import PointCloud2, PointField  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from wireless_msgs.msg import Connection  # noqa: E402
import recording_bag  # noqa: E402

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


def cloud(stamp, frame, point):
    message = PointCloud2(height=1, width=1, point_step=12, row_step=12, is_dense=True)
    message.header.stamp, message.header.frame_id = stamp, frame
    message.fields = [PointField(name, 4 * i, 7, 1) for i, name in enumerate("xyz")]
    message.data = struct.pack("<3f", *point)
    return message


class BagRecordings(unittest.TestCase):
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

    # ---- Readings that are far apart ----

    def test_a_scan_each_four_seconds(self):
        count = 0
        messages = []
        for topic, message, stamp in self.drive.messages:
            count += 0 if is_tf(topic) else 1
            if is_tf(topic) or count % 20 == 0:
                messages.append((topic, message, stamp))
        self.is_as_good("scan_4s", messages)

    def test_a_wireless_watcher(self):
        """The associated link once a second. A new access point is chosen when it is lost."""
        messages, count, link = [], 0, None
        for topic, message, stamp in self.drive.messages:
            if is_tf(topic):
                messages.append((topic, message, stamp))
                continue
            count += 1
            level = {reading.bssid: reading.rssi_dbm for reading in message.readings}
            best = max(level, key=level.get)
            if level.get(link, -100) < level[best] - 15:
                link = best
            if count % 5 == 0 and link in level:
                messages.append(("/connection", Connection(bssid=link.upper(), frequency=2.437,
                                                           signal_level=round(level[link])), stamp))
        self.is_as_good("watcher", messages)

    # ---- Split and broken bags ----

    def split(self, parts):
        """Bags of a recording; only the first has the static transform of the antenna."""
        first = self.drive.messages[0][2]
        static = TFMessage([recording_bag.transform(first.to_nsec(), "base_link", "wifi_antenna",
                                                    0.0, 0.0, 0.0)])
        messages = [("/tf_static", static, first)] + self.drive.messages
        size = -(-len(messages) // parts)
        return [self.drive.write("part_%d" % i, messages[i * size:(i + 1) * size])
                for i in range(parts)]

    def test_three_split_bags_in_any_order(self):
        bags = self.split(3)
        for name, order in (("split", bags), ("reversed", bags[::-1])):
            self.gives_the_same(name, *order, "--antenna-frame", "wifi_antenna")

    def test_a_part_alone_lacks_the_static_frame(self):
        said = self.drive.map("alone", self.split(3)[1], "--antenna-frame", "wifi_antenna",
                              status=1)
        self.assertIn("wifi_antenna", said)
        self.assertIn("Frames of the bag: ", said)
        self.assertIn("base_link", said)

    def test_compressed_bags(self):
        for compression in ("bz2", "lz4"):
            self.gives_the_same(compression, self.drive.write("in_" + compression,
                                                              self.drive.messages, compression))

    def test_a_bag_that_was_not_closed(self):
        whole = (self.drive.folder / "recording.bag").read_bytes()
        with open(self.drive.folder / "open.bag", "wb") as file:
            bag = rosbag.Bag(file, "w")
            for topic, message, stamp in self.drive.messages[:500]:
                bag.write(topic, message, stamp)
            bag.flush()
            unclosed = (self.drive.folder / "open.bag").read_bytes()
        active = self.drive.folder / "drive.bag.active"
        cut = self.drive.folder / "cut.bag"
        for file, content in ((active, unclosed), (cut, whole[:2 * len(whole) // 3])):
            file.write_bytes(content)
            said = self.drive.map("broken", file, status=1)
            self.assertIn("%s: " % file, said)
            self.assertIn("rosbag reindex %s" % file, said)
            self.assertFalse((self.drive.folder / "broken").exists())

    def test_one_of_two_is_no_bag(self):
        said = self.drive.map("none", self.drive.folder / "recording.bag",
                              self.drive.folder / "truth.pgm", status=1)
        self.assertIn("truth.pgm: cannot be read as a bag", said)
        self.assertNotIn("reindex", said)

    # ---- Topics and frames of other names ----

    def test_transforms_in_a_namespace(self):
        named = self.drive.write("named", [("/robot1" + topic, message, stamp) for
                                           topic, message, stamp in self.drive.messages])
        self.gives_the_same("ns_tf", named, "--scan-topic", "/robot1/wifi_scan")

    def two_robots(self):
        """Another robot, five metres away, in the same bag."""
        def shift(message):
            for transform in message.transforms:
                transform.transform.translation.x += 5.0 * (transform.child_frame_id == "odom")
        messages = []
        for topic, message, stamp in self.drive.messages:
            messages.append(("/robot1" + topic, message, stamp))
            messages.append(("/robot2" + topic,
                             changed(message, shift) if is_tf(topic) else message, stamp))
        return self.drive.write("two", messages)

    def test_transforms_of_two_robots(self):
        two = self.two_robots()
        self.gives_the_same("first", two, "--scan-topic", "/robot1/wifi_scan")
        self.gives_the_same("named_tf", two, "--scan-topic", "/robot2/wifi_scan",
                            "--tf-topic", "/robot1/tf")
        said = self.drive.map("third", two, "--scan-topic", "/robot1/wifi_scan", "--tf-topic",
                              "/robot3/tf", status=1)
        self.assertIn("no transform on /robot3/tf; it has /robot1/tf, /robot2/tf", said)

    def test_a_scan_of_no_robot_among_two(self):
        messages = [("/wifi_scan" if topic == "/wifi_scan" else "/a" + topic, message, stamp)
                    for topic, message, stamp in self.drive.messages]
        messages += [("/b/tf", message, stamp) for topic, message, stamp in self.drive.messages
                     if is_tf(topic)]
        messages.sort(key=lambda entry: entry[2])
        said = self.drive.map("unclear", self.drive.write("ab", messages), status=1)
        self.assertIn("transforms of several robots, on /a/tf, /b/tf; name one with --tf-topic",
                      said)

    def test_no_transforms(self):
        scans = [entry for entry in self.drive.messages if not is_tf(entry[0])]
        said = self.drive.map("no_tf", self.drive.write("scans", scans), status=1)
        self.assertIn("scans.bag: no transform on /tf", said)

    def test_a_leading_slash_in_transforms(self):
        def slashed(message):
            for transform in message.transforms:
                transform.header.frame_id = "/" + transform.header.frame_id
                transform.child_frame_id = "/" + transform.child_frame_id
        slash = self.drive.write("slash", [
            (topic, changed(message, slashed) if is_tf(topic) else message, stamp)
            for topic, message, stamp in self.drive.messages])
        self.gives_the_same("slashed", slash, "--antenna-frame", "/base_link", "--map-frame", "/map")

    def test_a_leading_slash_in_contacts(self):
        said = []
        for frame in ("base_link", "/base_link"):
            messages = []
            for i, (topic, message, stamp) in enumerate(self.drive.messages):
                messages.append((topic, message, stamp))
                if not is_tf(topic) and i % 40 == 1:
                    messages.append(("/contact_points", cloud(stamp, frame, (0.25, 0, 0)), stamp))
            name = "contacts" + frame.replace("/", "_slash_")
            said.append(self.drive.map(name, self.drive.write("with_" + name, messages)))
            self.assertNotIn("left out", said[-1])
        self.assertEqual(self.drive.bytes_of("contactsbase_link"),
                         self.drive.bytes_of("contacts_slash_base_link"))
        self.assertNotEqual(self.drive.bytes_of("contactsbase_link"), self.drive.bytes_of("plain"))

    # ---- Odometry and localisation ----

    def loop(self, name, odom, base):
        """Odometry that drifts until a loop closure half a minute before the end."""
        closure = self.drive.messages[-1][2].to_sec() - 30.0

        def drift(message, stamp):
            age = stamp.to_sec() - self.drive.start
            for one in message.transforms:
                shift = one.transform.translation
                if one.child_frame_id == "base_link":
                    shift.x, shift.y = shift.x + 0.005 * age, shift.y + 0.003 * age
                elif stamp.to_sec() >= closure:
                    shift.x, shift.y = shift.x - 0.005 * age, shift.y - 0.003 * age
                rename = {"odom": odom, "base_link": base}
                one.header.frame_id = rename.get(one.header.frame_id, one.header.frame_id)
                one.child_frame_id = rename.get(one.child_frame_id, one.child_frame_id)

        return self.drive.write(name, [
            (topic, changed(message, lambda m: drift(m, stamp)) if is_tf(topic) else message, stamp)
            for topic, message, stamp in self.drive.messages])

    def test_odometry_of_any_name(self):
        self.drive.map("loop", self.loop("loop", "odom", "base_link"))
        for odom in ("tb3_0/odom", "wheels"):
            bag = self.loop("loop_ns", odom, "tb3_0/base_link")
            self.drive.map("loop_ns", bag, "--antenna-frame", "tb3_0/base_link")
            self.assertEqual(self.drive.bytes_of("loop_ns"), self.drive.bytes_of("loop"))
        self.drive.map("off", bag, "--antenna-frame", "tb3_0/base_link", "--odom-frame", "map")
        iou, off = self.drive.iou_of("loop"), self.drive.iou_of("off")
        print("\nloop closure: IoU %.3f, not used %.3f" % (iou, off))
        self.assertGreater(iou, off + 0.03)
        said = self.drive.map("typo", bag, "--antenna-frame", "tb3_0/base_link", "--odom-frame",
                              "odometry")
        self.assertIn("no frame odometry (--odom-frame)", said)

    def test_two_publishers_of_one_transform(self):
        count = [0]

        def flip(message):
            count[0] += 1
            for one in message.transforms:
                if one.child_frame_id == "odom":
                    one.transform.translation.x = 0.0 if count[0] % 2 else 1.5
                else:
                    one.transform.translation.x -= 1.5
        bag = self.drive.write("twopub", [
            (topic, changed(message, flip) if is_tf(topic) else message, stamp)
            for topic, message, stamp in self.drive.messages])
        said = self.drive.map("twopub", bag)
        self.assertIn("the transform from map to odom goes to and fro", said)
        self.assertIn("two programs publish it", said)
        self.assertEqual(said.count("to and fro"), 1, said)
        self.drive.map("uncorrected", bag, "--odom-frame", "map")
        self.assertEqual(self.drive.bytes_of("twopub"), self.drive.bytes_of("uncorrected"))

    def test_two_floors(self):
        def lift(message):
            for one in message.transforms:
                one.transform.translation.z = 3.2 * (one.child_frame_id == "base_link")
        half = self.drive.start + 100.0
        said = self.drive.map("floors", self.drive.write("floors", [
            (topic, changed(message, lift) if is_tf(topic) and stamp.to_sec() > half else message,
             stamp) for topic, message, stamp in self.drive.messages]))
        self.assertIn("the robot drives on 2 floors, at heights of 0.0 m, 3.2 m", said)

    def test_the_plain_drive_has_no_note(self):
        self.assertNotIn("warning", self.drive.said.lower(), self.drive.said)


if __name__ == "__main__":
    junit.run()
