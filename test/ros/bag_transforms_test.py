#!/usr/bin/env python3
"""Maps bags whose transforms jump, stop, or are wrong, and compares with the map of the plain bag.

Usage: bag_transforms_test.py RESULT.xml SFW
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from bag_drive import DriveTest, changed, is_tf  # noqa: E402


class BagTransforms(DriveTest):
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

    def warnings(self, said):
        return [line for line in said.splitlines() if "warning" in line]

    def test_infinite_transforms(self):
        def break_it(message):
            for one in message.transforms:
                one.transform.translation.x = float("inf")
        messages = []
        for i, (topic, message, stamp) in enumerate(self.drive.messages):
            messages.append((topic, message, stamp))
            if is_tf(topic) and i % 100 == 0:
                messages.append((topic, changed(message, break_it), stamp))
        broken = sum(len(message.transforms) for topic, message, _ in messages
                     if is_tf(topic)) - sum(len(message.transforms) for topic, message, _
                                            in self.drive.messages if is_tf(topic))
        bag = self.drive.write("infinite", messages)
        said = self.gives_the_same("infinite", bag)
        self.assertGreater(broken, 10)
        self.assertEqual(self.warnings(said), [
            "sfw: warning: %s: %d transforms are infinite and not used; look for the node that "
            "publishes them" % (bag, broken)])

    def between(self, name, first, last):
        """Only these seconds of the drive have transforms from map to odom."""
        def cut(message, age):
            message.transforms = [one for one in message.transforms
                                  if one.child_frame_id != "odom" or first <= age <= last]
        messages, without = [], 0
        for topic, message, stamp in self.drive.messages:
            age = stamp.to_sec() - self.drive.start
            if is_tf(topic):
                message = changed(message, lambda m: cut(m, age))
            elif not first <= age <= last:
                without += len(message.readings)
            messages.append((topic, message, stamp))
        bag = self.drive.write(name, messages)
        return bag, without, self.warnings(self.drive.map(name, bag))

    def test_a_localisation_that_starts_late(self):
        bag, without, warnings = self.between("late", 20.05, 1e9)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertRegex(warnings[0], r"%s: %d readings left out: the transforms from base_link to "
                         r"map begin 20\.[12] s after the bag, and readings before have no position; "
                         r"start odometry and localisation before the recording$" % (bag, without))

    def test_a_localisation_that_stops(self):
        bag, without, warnings = self.between("stops", 0, 100.05)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertRegex(warnings[0], r"%s: %d readings left out: the transforms from base_link to "
                         r"map end (99\.[89]|100\.0) s after the begin of the bag, and readings "
                         r"after have no position; look why odometry or localisation stopped$"
                         % (bag, without))

    def test_clocks_that_differ(self):
        """The localisation runs on a machine whose clock is an hour ahead."""
        def shift(message):
            for one in message.transforms:
                if one.child_frame_id == "odom":
                    one.header.stamp.secs += 3600
        bag = self.drive.write("clocks", [
            (topic, changed(message, shift) if is_tf(topic) else message, stamp)
            for topic, message, stamp in self.drive.messages])
        said = self.drive.map("clocks", bag, status=1)
        self.assertIn("at their stamp; compare the clocks of the machines", said)
        self.assertNotIn("name the frames", said)

    def test_frames_of_other_names_are_not_late(self):
        """No reading has a position, and only the names of the frames are to blame."""
        bag = self.drive.folder / "recording.bag"
        said = self.drive.map("wrong_frame", bag, "--antenna-frame", "base_footprint", status=1)
        self.assertIn("name the frames with --antenna-frame and --map-frame. Frames of the bag: ",
                      said)
        self.assertNotIn("after the bag", said)

    def test_the_plain_drive_has_no_note(self):
        self.assertNotIn("warning", self.drive.said.lower(), self.drive.said)


if __name__ == "__main__":
    junit.run()
