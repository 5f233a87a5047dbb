#!/usr/bin/env python3
"""Replays recordings and compares the maps byte for byte.

Usage: replay_test.py RESULT.xml SFW MAPPING_LAUNCH_TEST
The same drive as readings.csv, as a bag read by `sfw map`, and as a bag played by replay.launch at
several rates must give the same map. replay.launch also passes mapping_launch_test.
"""

import itertools
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
import recording_bag  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

TABLE = ROOT / "test" / "data" / "access_points.yaml"
HOME_A = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"), "data", "recordings",
                      "turtlebot_home_a")
COMPARED = ("map.pgm", "probability.pgm", "map.bt")


class Replay(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw replay "))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.split = ["drive.bag"]  # the bags to play

    def write(self, stops, messages):
        recording_bag.write_csv(stops, self.folder / "readings.csv")
        recording_bag.write_bag(messages, self.folder / "drive.bag")
        return len({(stop.stamp_ns, bssid) for stop in stops for bssid, _ in stop.readings})

    def mapped(self, name, *source, table=TABLE):
        """The folder of the map that `sfw map` makes."""
        text = self.session.run(sys.argv[1], "map", *source, "--access-points", table, "--output",
                                self.folder / name)
        self.assertNotIn("left out", text)
        return self.folder / name

    def launch(self, rate, delay, table=TABLE, workers=None):
        """Starts replay.launch, with a node of its own or in a manager with so many threads."""
        self.session.environment["PWD"] = str(self.folder)  # as if called in there
        self.session.set_parameter("/mapping/method", "of an earlier launch")
        manager = "none" if workers is None else "manager"
        if workers is not None:
            self.session.set_parameter("/use_sim_time", True)  # it starts before the launch file
            self.session.start("manager", "rosrun", "nodelet", "nodelet", "manager",
                               "__name:=manager", "_num_worker_threads:=%d" % workers)
        return self.session.start(
            "replay", "roslaunch", ROOT / "launch" / "replay.launch",
            "bag:=" + " ".join(self.split),
            "access_points:=%s" % table, "rviz:=false",
            "rate:=%g" % rate, "delay:=%g" % delay, "manager:=%s" % manager,
            "save_directory:=%s" % (self.folder / "saved"))

    def replayed(self, rate, readings, table=TABLE, workers=None):
        """The folder that ~save_map fills once it has all readings."""
        shutil.rmtree(self.folder / "saved", ignore_errors=True)
        # What comes before the nodelet listens is lost, and a manager takes long to load it.
        launch = self.launch(rate, 4 if workers is None else 8, table, workers)
        saved = self.folder / "saved" / "all"

        def is_complete():
            self.assertIsNone(launch.poll(), self.session.text_of(launch))
            if self.session.master().lookupService("/test", "/mapping/save_map")[0] != 1:
                return False
            self.session.run("rosservice", "call", "/mapping/save_map", "{directory: all}")
            if not saved.is_dir():
                return False  # there are no readings yet
            table = (saved / "readings.csv").read_text().splitlines()
            return len(table) - 1 >= readings

        try:
            wait_until(is_complete, 60, "%d readings at rate %g" % (readings, rate))
        except TimeoutError:
            print(self.session.text_of(launch))
            raise
        self.session.stop(launch)
        name = self.folder / ("rate_%g_workers_%s" % (rate, workers))
        shutil.rmtree(name, ignore_errors=True)  # of the drive before
        saved.rename(name)
        return name

    def check(self, readings, rates, table=TABLE, with_csv=True, workers=(None,)):
        """Makes all maps of the drive written before, at each rate and number of worker threads;
        says which files differ."""
        with RosSession(with_master=False) as self.session:
            maps = [self.mapped("from_bag", "--bag", self.folder / "drive.bag", table=table)]
            if with_csv:
                maps.insert(0, self.mapped("from_csv", "--readings", self.folder / "readings.csv",
                                           table=table))
        for rate, count in itertools.product(rates, workers):
            with RosSession() as self.session:
                maps.append(self.replayed(rate, readings, table, count))
        differing = ["%s of %s" % (file, made.name) for made in maps[1:] for file in COMPARED
                     if (made / file).read_bytes() != (maps[0] / file).read_bytes()]
        self.assertEqual(differing, [], "these are not those of %s" % maps[0].name)
        pixels = (maps[0] / "map.pgm").read_bytes()
        self.assertGreater(pixels.count(bytes([254])), 100, "hardly a cell is free")
        return maps

    def test_a_drive_gives_one_map_by_all_ways(self):
        stops = recording_bag.synthetic_stops()
        self.check(self.write(stops, recording_bag.plain_messages(stops)), (1, 10))

    def test_neither_rate_nor_threads_change_the_map(self):
        stops = recording_bag.synthetic_stops()
        self.check(self.write(stops, recording_bag.plain_messages(stops)), (1, 10), with_csv=False,
                   workers=(1, 8))

    def test_an_awkward_bag_gives_the_same_map(self):
        stops = recording_bag.synthetic_stops(start_ns=1700000000 * 10**9 + 123456789)
        self.check(self.write(stops, recording_bag.awkward_messages(stops)), (2,))

    def test_a_loop_closure_gives_one_map_with_the_drift_taken_off(self):
        stops = recording_bag.synthetic_stops()
        readings = self.write(stops, recording_bag.corrected_messages(stops))
        maps = self.check(readings, (1, 10), with_csv=False)
        rows = [row.split(",") for row in (maps[1] / "readings.csv").read_text().split()[1:]]
        self.assertEqual(len(rows), readings)
        for i, row in enumerate(rows):
            self.assertAlmostEqual(float(row[1]), stops[i // 2].x, delta=0.02)
            self.assertAlmostEqual(float(row[2]), stops[i // 2].y, delta=0.02)

    def test_a_slow_scanner_gives_one_map_by_all_ways(self):
        stops = recording_bag.synthetic_stops()
        for name, messages, bags in (("whole", list(recording_bag.slow_messages(stops, 20)), 1),
                                     ("split", list(recording_bag.slow_messages(stops, 20)), 3)):
            with self.subTest(name):
                self.write(stops, messages)
                self.split = self.split_bag(messages, bags)
                maps = self.check(2 * len(stops[::20]), (1, 4), with_csv=False)
                self.check_files(maps[1])
                self.check_path(maps[1])

    def test_a_bumper_gives_one_map_by_all_ways(self):
        """The robot stands while it touches, because a bumper's message has no stamp of its own."""
        from std_msgs.msg import Bool
        stops = recording_bag.synthetic_stops()
        stops[110:] = [stop._replace(x=stops[110].x, y=stops[110].y) for stop in stops[110:]]
        messages = list(recording_bag.plain_messages(stops))
        messages.append((stops[130].stamp_ns + 2, "/contact", Bool(True)))
        maps = self.check(self.write(stops, messages), (1, 10), with_csv=False)
        self.assertEqual(len((maps[1] / "contacts.csv").read_text().split()), 2)
        untouched = self.folder / "untouched.bag"
        recording_bag.write_bag(messages[:-1], untouched)
        with RosSession(with_master=False) as self.session:
            self.mapped("untouched", "--bag", untouched)
        self.assertNotEqual((self.folder / "untouched" / "map.pgm").read_bytes(),
                            (maps[0] / "map.pgm").read_bytes(), "the contact does not matter")

    def check_files(self, saved, table=TABLE):
        """The files that ~save_map wrote give its map again."""
        with RosSession(with_master=False) as self.session:
            again = self.mapped("again", "--readings", saved / "readings.csv", "--path",
                                saved / "path.csv", table=table)
        for file in COMPARED:
            self.assertEqual((again / file).read_bytes(), (saved / file).read_bytes(), file)

    def check_path(self, saved):
        """The readings alone give another map."""
        with RosSession(with_master=False) as self.session:
            without = self.mapped("without", "--readings", saved / "readings.csv")
        self.assertNotEqual((without / "map.pgm").read_bytes(), (saved / "map.pgm").read_bytes(),
                            "the path does not matter")

    def split_bag(self, messages, parts):
        """The names of the bags that `rosbag record --split` would have made."""
        messages = sorted(messages, key=lambda entry: entry[0])
        size = -(-len(messages) // parts)
        names = ["drive_%d.bag" % i for i in range(parts)]
        for i, name in enumerate(names):
            recording_bag.write_bag(messages[i * size:(i + 1) * size], self.folder / name)
        return names

    @unittest.skipUnless(HOME_A.is_dir(), "%s is missing" % HOME_A)
    def test_a_real_drive_gives_one_map_by_all_ways(self):
        stops = recording_bag.recorded_stops(HOME_A / "two_routers.csv", 60)
        table = HOME_A / "access_points.yaml"
        readings = self.write(stops, recording_bag.plain_messages(stops))
        maps = self.check(readings, (10,), table, with_csv=False)
        self.check_files(maps[1], table)

    def test_replay_launch_does_what_mapping_launch_does(self):
        stops = recording_bag.synthetic_stops()
        self.write(stops, recording_bag.plain_messages(stops))
        with RosSession() as self.session:
            self.session.set_parameter("/launch_test/drive", False)
            launch = self.launch(8, 4)
            try:
                wait_until(lambda: self.session.master().hasParam("/t", "/mapping/ros")[2], 20,
                           "the launch file's parameters")
                self.session.run(sys.argv[2], "__name:=launch_test", seconds=60)
            except AssertionError:
                print(self.session.text_of(launch))
                raise


class BrokenBags(unittest.TestCase):
    def setUp(self):
        self.session = RosSession(with_master=False)
        self.session.__enter__()
        self.addCleanup(self.session.__exit__)
        self.stops = recording_bag.synthetic_stops(20)

    def sfw(self, messages):
        bag = self.session.folder / "drive.bag"
        recording_bag.write_bag(messages, bag)
        return self.session.start("sfw", sys.argv[1], "map", "--bag", bag, "--access-points",
                                  TABLE, "--output", self.session.folder / "map")

    def ends(self, process, status, *words):
        self.assertEqual(process.wait(60), status, self.session.text_of(process))
        for word in words:
            self.assertIn(word, self.session.text_of(process))
        self.assertEqual((self.session.folder / "map").exists(), status == 0)

    def test_no_messages(self):
        self.ends(self.sfw([]), 1, "drive.bag", "/wifi_scan", "--scan-topic")

    def test_no_scans(self):
        tf = [entry for entry in recording_bag.plain_messages(self.stops) if entry[1] == "/tf"]
        self.ends(self.sfw(tf), 1, "drive.bag", "/wifi_scan")

    def test_no_transforms(self):
        scans = [entry for entry in recording_bag.plain_messages(self.stops) if entry[1] != "/tf"]
        self.ends(self.sfw(scans), 1, "drive.bag", "no transform on /tf", "--tf-topic")

    def test_another_type_on_the_topic(self):
        messages = [(at, "/wifi_scan", message) for at, topic, message
                    in recording_bag.plain_messages(self.stops) if topic == "/tf"]
        self.ends(self.sfw(messages), 1, "drive.bag", "on /wifi_scan, its messages are of type",
                  "tf2_msgs/TFMessage")

    def test_contacts_without_coordinates_are_left_out(self):
        from sensor_msgs.msg import PointCloud2
        messages = list(recording_bag.plain_messages(self.stops))
        messages.append((self.stops[3].stamp_ns, "/contact_points", PointCloud2(width=3, height=1)))
        self.ends(self.sfw(messages), 0, "drive.bag", "left out")

    def test_wild_stamps_and_ages_do_no_harm(self):
        messages = list(recording_bag.plain_messages(self.stops))
        for stamp in (0, 1, 4 * 10**18):
            scan = recording_bag.scan_of(self.stops[3]._replace(stamp_ns=stamp))
            for age_s in (0.0, 3e9, 1e30, float("nan")):
                scan.readings[0].age_s = age_s
                messages.append((self.stops[3].stamp_ns + 2, "/wifi_scan", scan))
        self.ends(self.sfw(messages), 0, "drive.bag", "left out")

    def test_a_bag_cut_short(self):
        bag = self.session.folder / "drive.bag"
        recording_bag.write_bag(recording_bag.plain_messages(self.stops), bag)
        bag.write_bytes(bag.read_bytes()[:-100])
        self.ends(self.session.start("sfw", sys.argv[1], "map", "--bag", bag, "--access-points",
                                     TABLE, "--output", self.session.folder / "map"),
                  1, "drive.bag")


if __name__ == "__main__":
    junit.run()
