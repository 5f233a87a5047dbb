#!/usr/bin/python3
"""Drives a mapping node for long, with faults, and looks for what grows.

Usage: soak.py MAPPING_NODE SIMULATOR_NODE MINUTES
       soak.py --messages COUNT HOSTILE_MESSAGES_TEST     runs that test with so many messages

A simulated robot maps the demo's flat again and again. One message of a hundred is hostile; at the end
of each of 20 cycles the map is saved and reset, and the simulator starts anew, so that its clock jumps
back. Prints the resident memory at the end of the cycles and its slope with the standard error of the
fit, threads, descriptors, and errors in /diagnostics. Fails if the node ends, if threads or descriptors
grow, if the slope is certainly above 1 MB/h, or if /diagnostics has an error without a cause.
"""

import collections
import os
import pathlib
import random
import sys
import time

import diagnostic_msgs.msg
import numpy
import rospy
import std_srvs.srv
import structure_from_wifi.msg
import structure_from_wifi.srv

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "ros"))

from hostile import HostileMessages  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

CYCLES = 20
WARM_UP = 5  # cycles after which all memory pools are filled
HOSTILE_SHARE = 0.01
SHORT_HOSTILE_SHARE = 0.1  # of runs below five minutes, which have few messages
LARGEST_SLOPE = 1.0  # MB/h
SHORTEST_SLOPE = 0.2  # h of cycles after the warm-up, without which a slope says nothing


class Process:
    """What the kernel tells of a process."""

    def __init__(self, pid):
        self.folder = pathlib.Path("/proc/%d" % pid)

    def memory_mb(self):
        fields = (self.folder / "statm").read_text().split()
        return int(fields[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6

    def threads(self):
        return len(list((self.folder / "task").iterdir()))

    def descriptors(self):
        return len(list((self.folder / "fd").iterdir()))


def slope_of(hours, megabytes):
    """The slope of a line through the points, and its standard error [MB/h]."""
    hours, megabytes = numpy.array(hours), numpy.array(megabytes)
    if len(hours) < 3:
        return float("nan"), float("nan")
    centred = hours - hours.mean()
    slope = float(centred @ megabytes / (centred @ centred))
    rest = megabytes - megabytes.mean() - slope * centred
    return slope, float(numpy.sqrt(rest @ rest / (len(hours) - 2) / (centred @ centred)))


class Soak:
    def __init__(self, session, mapping_node, simulator_node, minutes):
        self.session, self.simulator_node = session, simulator_node
        self.cycle_s = 60.0 * minutes / CYCLES
        self.hostile_share = HOSTILE_SHARE if minutes >= 5.0 else SHORT_HOSTILE_SHARE
        self.start_simulator()
        self.mapper = session.start("mapping", mapping_node, "__name:=mapping")
        self.process = Process(self.mapper.pid)
        self.errors = collections.Counter()
        self.scans = self.hostile = 0
        self.tf_may_miss = True  # the simulator starts

    def start_simulator(self):
        self.simulator = self.session.start("simulator", self.simulator_node, "__name:=simulator")

    def listen(self):
        os.environ.update(self.session.environment)
        rospy.init_node("soak", disable_signals=True)
        self.messages = HostileMessages("02:00:00:00:00:01")
        self.random = random.Random(2)
        self.reset = rospy.ServiceProxy("mapping/reset", std_srvs.srv.Trigger)
        self.save = rospy.ServiceProxy("mapping/save_map", structure_from_wifi.srv.SaveMap)
        self.subscribers = [
            rospy.Subscriber("wifi_scan", structure_from_wifi.msg.WifiScan, self.on_scan),
            rospy.Subscriber("/diagnostics", diagnostic_msgs.msg.DiagnosticArray,
                             self.on_diagnostics)]

    def on_scan(self, scan):
        if scan._connection_header["callerid"] == "/soak":
            return
        self.scans += 1
        if self.random.random() < self.hostile_share:
            self.hostile += 1
            self.messages.send(scan.header.stamp)

    def on_diagnostics(self, array):
        for status in array.status:
            is_error = status.level == diagnostic_msgs.msg.DiagnosticStatus.ERROR
            is_explained = self.tf_may_miss and status.message.startswith(
                ("tf has no", "/use_sim_time is set"))
            if is_error and not is_explained:
                self.errors["%s: %s" % (status.name, status.message)] += 1

    def cycle(self):
        """One drive; returns the memory at its end."""
        rospy.wait_for_service("mapping/reset", 30)
        end = time.monotonic() + self.cycle_s
        while time.monotonic() < end:
            if self.mapper.poll() is not None:
                raise SystemExit("the mapping node ended:\n" + self.session.text_of(self.mapper))
            time.sleep(0.2)
            self.tf_may_miss = self.tf_may_miss and time.monotonic() < end - 0.5 * self.cycle_s
        saved = self.save("soak")
        memory = self.process.memory_mb()
        print("%.0f MB, %d threads, %d descriptors, %d scans, %d hostile; %s" % (
            memory, self.process.threads(), self.process.descriptors(), self.scans, self.hostile,
            saved.message), flush=True)
        self.tf_may_miss = True
        self.session.stop(self.simulator)
        self.reset()
        self.start_simulator()
        return memory

    def run(self):
        self.listen()
        started = time.monotonic()
        hours, megabytes = [], []
        for number in range(CYCLES):
            memory = self.cycle()
            if number == WARM_UP:
                threads, descriptors = self.process.threads(), self.process.descriptors()
            if number >= WARM_UP:
                hours.append((time.monotonic() - started) / 3600.0)
                megabytes.append(memory)
        slope, error = slope_of(hours, megabytes)
        more_threads = self.process.threads() - threads
        more_descriptors = self.process.descriptors() - descriptors
        print("memory: %.2f +- %.2f MB/h; threads: %+d; descriptors: %+d; %d of %d scans hostile" % (
            slope, error, more_threads, more_descriptors, self.hostile, self.scans))
        for text, count in self.errors.items():
            print("error without a cause, %d times: %s" % (count, text))
        is_long = hours[-1] - hours[0] > SHORTEST_SLOPE
        grows = is_long and slope - 2.0 * error > LARGEST_SLOPE
        return not (grows or self.errors or more_threads > 1 or more_descriptors > 2
                    or self.hostile == 0)


def run_messages(count, test):
    with RosSession() as session:
        session.set_parameter("/use_sim_time", True)
        session.environment["SFW_MESSAGES"] = count
        process = session.start("messages", test)
        status = process.wait()
        print("\n".join(line for line in session.text_of(process).splitlines()
                        if "WARN" not in line and "tf2" not in line and "TF_" not in line))
        sys.exit(status)


def main():
    if sys.argv[1] == "--messages":
        run_messages(sys.argv[2], sys.argv[3])
    mapping_node, simulator_node, minutes = sys.argv[1], sys.argv[2], float(sys.argv[3])
    with RosSession() as session:
        flat = ROOT / "config" / "demo"
        table = [{"bssid": "02:00:00:00:00:01", "x": 2.6, "y": 1.6},
                 {"bssid": "02:00:00:00:00:02", "x": 7.0, "y": 6.0}]
        session.set_parameter("/use_sim_time", True)
        session.set_parameter("/simulator", {
            "plan": str(flat / "flat.yaml"), "route": str(flat / "route.csv"), "time_scale": 6.0,
            "publish_clock": True, "access_points": table})
        session.set_parameter("/mapping", {
            "access_points": table, "ros": {"save_directory": str(session.folder / "maps"),
                                            "autosave_period": 10.0}})
        soak = Soak(session, mapping_node, simulator_node, minutes)
        wait_until(lambda: session.master().lookupService("/t", "/mapping/reset")[0] == 1, 60,
                   "the mapping node's services")
        sys.exit(0 if soak.run() else 1)


if __name__ == "__main__":
    main()
