#!/usr/bin/env python3
"""Reads the scan messages of other packages, which genpy and rosbag write.

Usage: scan_messages_test.py RESULT.xml READ_SCANS
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import genpy
import genpy.dynamic
import rosbag

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
import scan_messages  # noqa: E402
from scan_messages import A, B, HEADER, MD5, MESSAGES, RECEIVED, STAMP, STAMPED, part  # noqa: E402


def filled(message, values, classes):
    for field, kind in zip(message.__slots__, message._slot_types):
        value = values.get(field)
        if value is None:
            continue
        if kind in ("time", "duration"):
            value = genpy.Time(value["secs"], value["nsecs"])
        elif kind.endswith("[]") and kind[:-2] in classes:
            value = [filled(classes[kind[:-2]](), element, classes) for element in value]
        elif kind in classes:
            value = filled(classes[kind](), value, classes)
        setattr(message, field, value)
    return message


def message_of(kind, definition, values):
    classes = genpy.dynamic.generate_dynamic(kind, definition)
    return filled(classes[kind](), values, classes)


def line_of(topic, expected):
    if isinstance(expected, str):
        count, words = expected.split(" ", 1)
        return "%s\tproblem\t%s\t%s" % (topic, count, words)
    bssid, rssi_dbm, stamp = expected
    return "%s\t%s\t%.3f\t%d" % (topic, bssid, rssi_dbm, round(stamp * 10**9))


class ScanMessages(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw_scans_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def read(self, messages, settings=None):
        """The lines of each topic."""
        bag = self.folder / "scans.bag"
        with rosbag.Bag(str(bag), "w") as file:
            for topic, message in messages:
                file.write(topic, message, genpy.Time.from_sec(RECEIVED))
        command = [sys.argv[1], str(bag)]
        if settings is not None:
            (self.folder / "settings.yaml").write_text(settings)
            command.append(str(self.folder / "settings.yaml"))
        run = subprocess.run(command, capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = {topic: [] for topic, _ in messages}
        for line in run.stdout.splitlines():
            lines[line.split("\t")[0]].append(line)
        return lines

    def expect(self, topic, lines, expected):
        """A problem may have more words than those expected."""
        wanted = [line_of(topic, reading) for reading in expected]
        with self.subTest(topic):
            cut = [line[:len(want)] if "\tproblem\t" in want else line
                   for line, want in zip(lines, wanted)]
            self.assertEqual(cut + lines[len(wanted):], wanted, lines)

    def test_every_known_message_gives_its_readings(self):
        messages = [("/" + name.replace(" ", "_"), message_of(kind, definition, values))
                    for name, kind, definition, values, _ in MESSAGES]
        lines = self.read(messages)
        for (topic, _), entry in zip(messages, MESSAGES):
            self.expect(topic, lines[topic], entry[-1])

    def test_the_definitions_are_those_of_the_packages(self):
        for name, kind, definition, _, _ in MESSAGES:
            if name in MD5:
                known = genpy.dynamic.generate_dynamic(kind, definition)[kind]._md5sum
                self.assertEqual(known, MD5[name], name)

    def test_settings_describe_any_other_message(self):
        definition = ("Header header\nNet[] nets\n" + HEADER +
                      part("my/Net", "string mac\nint32 level\nint64 seen_us\nfloat64 at"))
        values = {"header": STAMP, "nets": [{"mac": A, "level": -5000, "seen_us": 250000,
                                             "at": 999.0}]}
        message = message_of("my/Scan", definition, values)
        base = "{type: my/Scan, readings: nets, bssid: mac, rssi: level"
        for more, expected in ((", unit: mbm}", (A, -50, STAMPED)),
                               (", unit: mbm, age: seen_us, age_unit: us}", (A, -50, 1000.0)),
                               (", unit: mbm, stamp: at}", (A, -50, 999.0)),
                               (", unit: mbm, stamp: ''}", (A, -50, RECEIVED)),
                               (", unit: negative}", (A, -5000, STAMPED)),
                               (", unit: quality}", (A, -2600, STAMPED))):
            lines = self.read([("/own", message)], "scan_format: " + base + more)
            self.expect("/own", lines["/own"], [expected])
        wrong = "scan_format: {type: my/Scan, readings: nets, bssid: address, rssi: level}"
        self.expect("/own", self.read([("/own", message)], wrong)["/own"],
                    ["1 its messages are of type my/Scan, which has no field address"])

    def test_settings_name_the_access_point_of_a_message_without_one(self):
        message = message_of("std_msgs/Float32", "float32 data", {"data": -50.0})
        settings = "scan_format: {type: std_msgs/Float32, bssid: '%s', rssi: data}" % B
        self.expect("/own", self.read([("/own", message)], settings)["/own"],
                    [(B, -50, RECEIVED)])

    def test_settings_describe_json(self):
        message = message_of("std_msgs/String", "string data",
                             {"data": '{"bssid": "%s", "rssi": -50}' % A})
        settings = "scan_format: {type: std_msgs/String, bssid: bssid, rssi: rssi}"
        self.expect("/own", self.read([("/own", message)], settings)["/own"],
                    [(A, -50, RECEIVED)])


if __name__ == "__main__":
    junit.run()
