#!/usr/bin/env python3
"""Kills the mapper under roslaunch, as a node of its own and with its nodelet manager.

Usage: respawn_test.py RESULT.xml
"""

import os
import pathlib
import signal
import sys
import unittest
import xmlrpc.client

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

MANAGER = """<launch>
  <node name="manager" pkg="nodelet" type="nodelet" args="manager" respawn="true" output="screen"/>
  <include file="%s" pass_all_args="true"><arg name="manager" value="manager"/></include>
</launch>
"""
OLD = {"readings.csv": "stamp,x,y,bssid,rssi_dbm\n1,9,9,02:00:00:00:00:01,-50\n",
       "contacts.csv": "stamp,x,y\n",
       "access_points.yaml": "access_points:\n  - {bssid: '02:00:00:00:00:01', x: 0, y: 0}\n"}


class Respawn(unittest.TestCase):
    def setUp(self):
        self.session = RosSession()
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)
        self.saved = self.session.folder / "maps"
        self.autosave = self.saved / "autosave"

    def launch(self, file):
        config = self.session.folder / "config.yaml"
        config.write_text("ros: {autosave_period: 0.2}\n")
        return self.session.start(
            "launch", "roslaunch", file, "rviz:=false", "respawn:=true", "config:=%s" % config,
            "access_points:=%s" % (ROOT / "test/data/access_points.yaml"),
            "save_directory:=%s" % self.saved)

    def pid_of(self, node):
        try:
            code, _, uri = self.session.master().lookupNode("/test", node)
            return xmlrpc.client.ServerProxy(uri).getPid("/test")[2] if code == 1 else None
        except OSError:
            return None  # the master still has the dead one

    def rows(self, directory):
        try:
            return (directory / "readings.csv").read_text().splitlines()[1:]
        except OSError:
            return []

    def leave_an_old_session(self):
        self.autosave.mkdir(parents=True)
        for name, text in OLD.items():
            (self.autosave / name).write_text(text)

    def send_readings(self):
        self.session.start("tf", "rostopic", "pub", "/tf_static", "tf2_msgs/TFMessage",
                           "{transforms: [{header: {frame_id: map}, child_frame_id: base_link, "
                           "transform: {translation: {x: 1, y: 2}, rotation: {w: 1}}}]}")
        self.session.run("rostopic", "pub", "-1", "/wifi_scan", "structure_from_wifi/WifiScan",
                         "{header: auto, readings: [{bssid: '02:00:00:00:00:01', rssi_dbm: -50}, "
                         "{bssid: '02:00:00:00:00:02', rssi_dbm: -60}]}")

    def comes_back_with_its_map(self, launch, process):
        """Kills a process; the mapper comes back with its session, and not with an older one."""
        try:
            pid = wait_until(lambda: self.pid_of(process), 30, "the start")
            wait_until(lambda: "/mapping/save_map" in self.services(), 30, "the mapper")
            self.send_readings()
            before = wait_until(lambda: len(self.rows(self.autosave)) == 2 and
                                self.rows(self.autosave), 30, "the autosave")
            self.assertEqual(self.rows(self.saved / "autosave_before"),
                             OLD["readings.csv"].splitlines()[1:])
            os.kill(pid, signal.SIGKILL)
            wait_until(lambda: self.pid_of(process) not in (None, pid), 30, "the next process")
            wait_until(lambda: "The session goes on" in self.session.text_of(launch), 60,
                       "the session")
        except TimeoutError as error:
            raise AssertionError("%s\n%s" % (error, self.session.text_of(launch)))
        answer = self.session.run("rosservice", "call", "/mapping/save_map", "directory: again")
        self.assertIn("success: True", answer)
        self.assertEqual(self.rows(self.saved / "again"), before)

    def services(self):
        return [name for name, _ in self.session.master().getSystemState("/test")[2][2]]

    def test_a_node_comes_back_with_its_map(self):
        self.leave_an_old_session()
        self.comes_back_with_its_map(self.launch(ROOT / "launch/mapping.launch"), "/mapping")

    def test_a_nodelet_comes_back_when_its_manager_does(self):
        self.leave_an_old_session()
        file = self.session.folder / "manager.launch"
        file.write_text(MANAGER % (ROOT / "launch/mapping.launch"))
        self.comes_back_with_its_map(self.launch(file), "/manager")


if __name__ == "__main__":
    junit.run()
