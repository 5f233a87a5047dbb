#!/usr/bin/env python3
"""Maps bags with topics and frames of other names, and compares with the map of the plain bag.

Usage: bag_names_test.py RESULT.xml SFW
"""

import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from sensor_msgs.msg import PointCloud2, PointField  # noqa: E402
from bag_drive import DriveTest, changed, is_tf  # noqa: E402


def cloud(stamp, frame, point):
    message = PointCloud2(height=1, width=1, point_step=12, row_step=12, is_dense=True)
    message.header.stamp, message.header.frame_id = stamp, frame
    message.fields = [PointField(name, 4 * i, 7, 1) for i, name in enumerate("xyz")]
    message.data = struct.pack("<3f", *point)
    return message


class BagNames(DriveTest):
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


if __name__ == "__main__":
    junit.run()
