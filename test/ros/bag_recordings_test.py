#!/usr/bin/env python3
"""Maps bags that were split, cut, or hold few scans, and compares with the map of the plain bag.

Usage: bag_recordings_test.py RESULT.xml SFW
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
import rosbag  # noqa: E402
import rospy  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from wireless_msgs.msg import Connection  # noqa: E402
import recording_bag  # noqa: E402
from bag_drive import DriveTest, is_tf  # noqa: E402


class BagRecordings(DriveTest):
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

    def test_bags_that_overlap(self):
        """Two recorders of the same topics: each message comes twice, the second time a bit later."""
        late = rospy.Duration(0.05)
        again = self.drive.write("again", [(topic, message, stamp + late)
                                           for topic, message, stamp in self.drive.messages])
        said = self.gives_the_same("overlap", self.drive.folder / "recording.bag", again)
        self.assertEqual(len(said.splitlines()), 1, said)

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


if __name__ == "__main__":
    junit.run()
