#!/usr/bin/env python3
"""Faults of the ROS graph: a master that restarts, and a second mapper on the same topic.

Usage: master_test.py RESULT.xml MAPPING_NODE
"""

import pathlib
import signal
import sys
import time
import unittest
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

PARAMETERS = {"access_points": [{"bssid": "02:00:00:00:00:01", "x": 0.5, "y": 0.5}],
              "ros": {"autosave_period": 0.2}}


class Graph(unittest.TestCase):
    def setUp(self):
        self.session = RosSession()
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)

    def start(self, name):
        self.session.set_parameter("/" + name, PARAMETERS)
        return self.session.start(name, sys.argv[1], "__name:=" + name)

    def nodes_of(self, topic):
        return dict(self.session.master().getSystemState("/test")[2][0]).get(topic, [])

    def wait_for_map_of(self, name):
        wait_until(lambda: "/" + name in self.nodes_of("/map"), 20, "the map of " + name)


class RestartedMaster(Graph):
    def readings(self):
        file = self.session.folder / ".ros/structure_from_wifi/autosave/readings.csv"
        return len(file.read_text().splitlines()) - 1 if file.is_file() else 0

    def test_mapping_goes_on(self):
        node = self.start("mapper")
        self.wait_for_map_of("mapper")
        self.session.start("tf", "rostopic", "pub", "/tf_static", "tf2_msgs/TFMessage",
                           "{transforms: [{header: {frame_id: map}, child_frame_id: base_link, "
                           "transform: {translation: {x: 1, y: 2}, rotation: {w: 1}}}]}")
        self.session.start("scans", "rostopic", "pub", "-r", "10", "-s", "/wifi_scan",
                           "structure_from_wifi/WifiScan",
                           "{header: auto, readings: [{bssid: '02:00:00:00:00:01', rssi_dbm: -50}]}")
        wait_until(lambda: self.readings() > 5, 30, "readings")
        master = self.session.processes[0]
        self.session.stop(master)
        self.assertFalse(self.session.is_up())
        at_the_end = self.readings()
        wait_until(lambda: self.readings() > at_the_end + 5, 30, "readings without a master")
        self.session.start("rosmaster", "rosmaster", "--core", "-p",
                           urllib.parse.urlparse(self.session.uri).port)
        wait_until(self.session.is_up, 20, "the ROS master's second start")
        again = self.readings()
        wait_until(lambda: self.readings() > again + 5, 30, "readings under the next master")
        self.assertIsNone(node.poll(), self.session.text_of(node))
        start = time.monotonic()
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(10), 0, self.session.text_of(node))
        self.assertLess(time.monotonic() - start, 1.0)


class TwoMappers(Graph):
    def test_the_second_one_names_the_first(self):
        first = self.start("first")
        self.wait_for_map_of("first")
        second = self.start("second")
        wait_until(lambda: "/map is published by /first too" in self.session.text_of(second), 20,
                   "the warning")
        self.assertNotIn("is published by", self.session.text_of(first))

    def test_a_node_that_was_killed_is_no_second_one(self):
        killed = self.start("mapper")
        self.wait_for_map_of("mapper")
        killed.kill()
        killed.wait(10)
        self.assertEqual(self.nodes_of("/map"), ["/mapper"], "the master still lists it")
        again = self.start("mapper")
        wait_until(lambda: "Mapping with 1 access points" in self.session.text_of(again), 20,
                   "the next start")
        self.assertNotIn("is published by", self.session.text_of(again))


if __name__ == "__main__":
    junit.run()
