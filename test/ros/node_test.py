#!/usr/bin/env python3
"""Starts mapping_node with parameters good and bad, and ends it.

Usage: node_test.py RESULT.xml MAPPING_NODE
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

NAME = "/mapping_node"
TABLE = [{"bssid": "02:00:00:00:00:01", "x": 0.5, "y": 0.5}]


class Node(unittest.TestCase):
    def setUp(self):
        self.session = RosSession()
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)

    def start(self, parameters):
        self.session.set_parameter(NAME, parameters)
        return self.session.start("node", sys.argv[1])

    def refuses(self, parameters, *words):
        node = self.start(parameters)
        self.assertEqual(node.wait(10), 1, self.session.text_of(node))
        for word in words:
            self.assertIn(word, self.session.text_of(node))

    def has_map(self):
        publishers = self.session.master().getSystemState("/test")[2][0]
        return any(topic == "/map" for topic, _ in publishers)

    def interrupt(self, node):
        wait_until(self.has_map, 10, "the map")
        time.sleep(0.3)
        start = time.monotonic()
        node.send_signal(signal.SIGINT)
        status = node.wait(10)
        return status, time.monotonic() - start

    def publish(self, *arguments):
        return self.session.start("rostopic", "rostopic", "pub", *arguments)

    def test_takes_the_right_type_after_a_wrong_one(self):
        self.publish("-l", "/tf_static", "tf2_msgs/TFMessage",
                     "{transforms: [{header: {frame_id: map}, child_frame_id: base_link,"
                     " transform: {rotation: {w: 1.0}}}]}")
        node = self.start({"access_points": TABLE})
        wrong = self.publish("-r", "10", "/wifi_scan", "std_msgs/String", "data: text")
        wait_until(lambda: "its messages are of type std_msgs/String" in self.session.text_of(node),
                   30, "the wrong type in the log")
        self.session.stop(wrong)
        self.publish("-r", "10", "/wifi_scan", "structure_from_wifi/WifiScan",
                     "readings: [{bssid: '%s', rssi_dbm: -50.0}]" % TABLE[0]["bssid"])
        wait_until(lambda: "The first reading" in self.session.text_of(node), 30, "a reading")

    def test_names_every_bad_parameter(self):
        self.refuses(
            {"access_points": TABLE, "map": {"resolution": 0.0, "margin": float("nan")},
             "k_visibility": {"window": "wide", "filter": "mode"},
             "belief": {"free_threshold": 0.9, "occupied_threshold": 0.2},
             "ros": {"map_frame": ""}},
            *(NAME + "/" + name for name in ("map/resolution", "map/margin", "k_visibility/window",
                                             "k_visibility/filter", "belief/free_threshold",
                                             "ros/map_frame")))

    def test_names_every_bad_access_point(self):
        self.refuses({"access_points": TABLE + TABLE + [{"bssid": "home", "x": "left", "y": 1}]},
                     "access_points[1]", "access_points[2]: 'bssid'", "access_points[2]: 'x'")

    def test_refuses_a_name_that_ros_cannot_use(self):
        run = subprocess.run([sys.argv[1], "__name:=my mapper"], capture_output=True, text=True,
                             timeout=60)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("is not valid in Graph Resource Name", run.stderr)

    def test_needs_a_list_of_access_points(self):
        self.refuses({"access_points": {"bssid": "home"}}, NAME + "/access_points must be a list")

    def test_uses_all_that_are_heard_without_a_table(self):
        for parameters in ({}, {"access_points": []}):
            node = self.start(parameters)
            self.interrupt(node)
            self.assertIn("Mapping with all access points that are heard",
                          self.session.text_of(node))

    def test_refuses_access_points_that_no_map_can_hold(self):
        far = {"bssid": "02:00:00:00:00:02", "x": 9e5, "y": 9e5}
        self.refuses({"access_points": TABLE + [far]},
                     "Mapping cannot start: " + NAME + ": no map can hold the access points",
                     "map/max_cells")

    def table_file(self, text):
        path = self.session.folder / "table.yaml"
        path.write_text(text)
        return str(path)

    def test_reads_a_file_of_access_points_that_rosparam_cannot_load(self):
        # Without quotes this is a number of base 60 in YAML 1.1, beyond 32 bits.
        table = self.table_file("access_points:\n  - {bssid: 52:54:00:12:34:56, x: 1, y: 2}\n")
        node = self.start({"access_points_file": table})
        status, _ = self.interrupt(node)
        self.assertEqual(status, 0)
        self.assertNotIn("access_points_file", self.session.text_of(node))

    def test_tells_that_the_file_of_access_points_wins(self):
        table = self.table_file("access_points: [{bssid: 02-00-00-00-00-02, x: 1, y: 2, z0: 3}]\n")
        node = self.start({"access_points_file": table, "access_points": TABLE})
        self.interrupt(node)
        text = self.session.text_of(node)
        self.assertIn("%s/access_points is not read, since access_points_file is set: %s wins" %
                      (NAME, table), text)
        self.assertIn(NAME + "/access_points_file: " + table + ": access_points[0]: 'z0'", text)

    def test_names_a_bad_file_of_access_points(self):
        self.refuses({"access_points_file": "/nowhere.yaml"},
                     "Mapping cannot start: " + NAME + "/access_points_file: /nowhere.yaml: cannot be read")
        self.refuses({"access_points_file": self.table_file("access_points: 7\n")}, "table.yaml",
                     "access_points must be a list")
        self.refuses({"access_points_file": 7.5, "access_points": TABLE}, "7.5: cannot be read")

    def test_warns_of_a_misspelt_parameter(self):
        node = self.start({"access_points": TABLE, "k_visibility": {"windw": 5}})
        self.interrupt(node)
        for word in (NAME + "/k_visibility/windw", "k_visibility/window"):
            self.assertIn(word, self.session.text_of(node))

    def test_ends_within_a_second(self):
        status, seconds = self.interrupt(self.start({"access_points": TABLE}))
        self.assertEqual(status, 0)
        self.assertLess(seconds, 1.0)

    def test_starts_and_ends_without_a_clock(self):
        self.session.set_parameter("/use_sim_time", True)
        status, seconds = self.interrupt(self.start({"access_points": TABLE}))
        self.assertEqual(status, 0)
        self.assertLess(seconds, 1.0)


class Killed(unittest.TestCase):
    """A process that is killed resumes from its autosave."""

    def start(self, session):
        node = session.start("node", sys.argv[1], "wifi_scan:=scan")
        wait_until(lambda: any(topic == "/map" for topic, _ in
                               session.master().getSystemState("/test")[2][0]) or None, 20, "map")
        return node

    def test_resumes(self):
        with RosSession() as session:
            session.set_parameter(NAME, {
                "access_points": TABLE, "ros": {"autosave_period": 0.2, "resume": True}})
            node = self.start(session)
            session.start("tf", "rostopic", "pub", "/tf_static", "tf2_msgs/TFMessage",
                          "{transforms: [{header: {frame_id: map}, child_frame_id: base_link, "
                          "transform: {translation: {x: 1, y: 2}, rotation: {w: 1}}}]}")
            session.run("rostopic", "pub", "-1", "/scan", "structure_from_wifi/WifiScan",
                        "{header: auto, readings: [{bssid: '02:00:00:00:00:01', rssi_dbm: -50}]}")
            saved = session.folder / ".ros/structure_from_wifi/autosave"
            try:
                wait_until(lambda: (saved / "access_points.yaml").is_file(), 20, "the autosave")
            except TimeoutError as error:
                raise AssertionError("%s\n%s" % (error, session.text_of(node)))
            readings = (saved / "readings.csv").read_text()
            self.assertEqual(len(readings.splitlines()), 2)
            node.kill()
            node.wait(10)
            node = self.start(session)
            wait_until(lambda: "The session goes on: added 1 readings" in session.text_of(node), 20,
                       "the session")
            answer = session.run("rosservice", "call", NAME + "/save_map", "{directory: again}")
            self.assertIn("success: True", answer)
            again = saved.parent / "again" / "readings.csv"
            self.assertEqual(again.read_text(), readings)


class LaunchArguments(unittest.TestCase):
    LAUNCH = pathlib.Path(__file__).resolve().parent.parent.parent / "launch" / "mapping.launch"

    def parameters(self, config, *arguments):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write(config)
            file.flush()
            run = subprocess.run(["roslaunch", "--dump-params", self.LAUNCH, "rviz:=false",
                                  "config:=" + file.name, *arguments],
                                 capture_output=True, text=True, timeout=60, check=True)
        return dict(line.strip().split(": ", 1) for line in run.stdout.splitlines()
                    if line.startswith("/"))

    def test_leave_settings_of_the_config_alone(self):
        config = "ros: {map_frame: world, antenna_frame: wifi_link, save_directory: /maps}\n"
        parameters = self.parameters(config)
        self.assertEqual(parameters["/mapping/ros/map_frame"], "world")
        self.assertEqual(parameters["/mapping/ros/antenna_frame"], "wifi_link")
        self.assertEqual(parameters["/mapping/ros/save_directory"], "/maps")

    def test_name_the_file_of_access_points_by_its_full_path(self):
        for given, path in (("/a b/table.yaml", "/a b/table.yaml"),
                            ("table.yaml", "%s/table.yaml" % os.environ["PWD"])):
            parameters = self.parameters("{}", "access_points:=" + given)
            self.assertEqual(parameters["/mapping/access_points_file"].strip("'"), path)
        self.assertNotIn("/mapping/access_points_file", self.parameters("{}"))

    def test_are_optional(self):
        for name, required in (("mapping", []), ("demo", []), ("replay", ["access_points", "bag"])):
            run = subprocess.run(["roslaunch", "--ros-args", self.LAUNCH.parent / (name + ".launch")],
                                 capture_output=True, text=True, timeout=60, check=True)
            head = run.stdout.split("Optional Arguments:")[0].splitlines()
            self.assertEqual([line.split(":")[0].strip() for line in head[1:]], required, name)

    def test_win_over_the_config(self):
        parameters = self.parameters("ros: {map_frame: world, antenna_frame: wifi_link}\n",
                                     "map_frame:=floor")
        self.assertEqual(parameters["/mapping/ros/map_frame"], "floor")
        self.assertEqual(parameters["/mapping/ros/antenna_frame"], "wifi_link")


class Messages(unittest.TestCase):
    def test_are_shown_in_the_devel_space(self):
        devel = pathlib.Path(sys.argv[1]).parents[2]
        for message in ("wireless_msgs/Connection", "octomap_msgs/Octomap"):
            run = subprocess.run(["bash", "-c", "source '%s/setup.bash' && rosmsg show %s" %
                                  (devel, message)], capture_output=True, text=True, timeout=60)
            self.assertEqual(run.returncode, 0, run.stderr)


if __name__ == "__main__":
    junit.run()
