#!/usr/bin/env python3
"""Runs `sfw map --list` and `sfw bench` in shards: by GNU parallel, killed, resumed and merged.

Usage: shards_test.py RESULT.xml SFW SOURCE_DIR
The tests with GNU parallel skip themselves if it is not installed.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, MAP_FILES, CommandLine, rows  # noqa: E402
from fleet_recipes import contents, recipe  # noqa: E402

DRIVES = 7
BENCH = ("--generate", 2, "--noise", "none", "low", "--methods", "k_visibility", "--workers", 1)
KILLED_ONCE = """#!/bin/sh
{sfw} --shard "$1/2" &
if [ -e "{first}.$1" ]; then
  wait $!
  exit
fi
until ls "{recordings}"/*.json >"{first}.$1" 2>/dev/null; do sleep 0.01; done
kill -9 $!
wait $!
echo $? >"{first}.$1"
exit 1
"""
NEEDS_PARALLEL = unittest.skipIf(shutil.which("parallel") is None, "GNU parallel is not installed")


class Shards(CommandLine):
    def setUp(self):
        super().setUp()
        (self.folder / "drives").mkdir()
        for i in range(DRIVES):
            self.write("drives/%d.csv" % i, "\n".join([HEADER] + rows(poses=100 + i)) + "\n")
        self.list = self.write_list([{"name": "drive %d" % i, "readings": "drives/%d.csv" % i}
                                     for i in range(DRIVES)])

    def write_list(self, entries, name="list.yaml"):
        return self.write(name, "".join("- %s\n" % json.dumps(entry) for entry in entries))

    def maps(self, *more, output=None, list_file=None):
        return self.sfw("map", "--list", list_file or self.list, "--access-points",
                        self.access_points, "--output", output or self.output, *more)

    def bench(self, *more, output=None):
        return self.sfw("bench", *BENCH, "--output", output or self.output, *more)

    def merge(self, output=None):
        return self.sfw("merge", "--output", output or self.output)

    def start(self, *arguments):
        worker = subprocess.Popen([sys.argv[1], *map(str, arguments)], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True)
        self.addCleanup(worker.stderr.close)
        self.addCleanup(worker.wait)
        self.addCleanup(worker.kill)
        return worker

    def start_maps(self, *more):
        return self.start("map", "--list", self.list, "--access-points", self.access_points,
                          "--output", self.output, *more)

    def wait_for(self, pattern, worker, count=1):
        until = time.monotonic() + 60
        while len(list(self.output.glob(pattern))) < count:
            self.assertIsNone(worker.poll(), "the worker ended early")
            self.assertLess(time.monotonic(), until, "no %s appeared" % pattern)
            time.sleep(0.002)

    def damaged(self, run, *words):
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        for word in words:
            self.assertIn(str(word), run.stderr)
        self.assertNotIn("terminate", run.stderr)


class Lists(Shards):
    def test_each_row_has_the_map_of_its_recording(self):
        self.good(self.maps())
        for i in (0, DRIVES - 1):
            alone = self.folder / "alone"
            self.good(self.map(readings=self.folder / "drives" / ("%d.csv" % i), output=alone))
            made = self.bytes_of(self.output / ("drive %d" % i))
            row = json.loads(made.pop("row.json"))
            self.assertEqual(made, self.bytes_of(alone))
            self.assertEqual(sorted(row["files"]), MAP_FILES)
        index = json.loads((self.output / "maps.json").read_text())
        self.assertEqual([entry["name"] for entry in index["maps"]],
                         ["drive %d" % i for i in range(DRIVES)])

    def test_a_row_has_options_of_its_own(self):
        self.list = self.write_list([
            {"name": "shared", "readings": "drives/0.csv"},
            {"name": "own", "readings": "drives/0.csv", "scale": 0.5,
             "config": "own.yaml"}])
        own = self.write("own.yaml", "map: {resolution: 0.2}")
        self.good(self.maps("--scale", 2))
        for name, more in (("shared", ["--scale", 2]), ("own", ["--scale", 0.5, "--config", own])):
            alone = self.folder / name
            self.good(self.map(*more, readings=self.folder / "drives/0.csv", output=alone))
            made = self.bytes_of(self.output / name)
            made.pop("row.json")
            self.assertEqual(made, self.bytes_of(alone), name)

    def test_a_failed_row_does_not_stop_the_others(self):
        self.write("drives/2.csv", "hello\n")
        for shard in ([], ["--shard", "3/7"]):
            run = self.maps(*shard)
            self.damaged(run, "drive 2: ", "2.csv", "1 of %d" % (1 if shard else DRIVES))
        self.assertEqual(len(list(self.output.glob("drive */row.json"))), DRIVES - 1)
        self.write("drives/2.csv", "\n".join([HEADER] + rows()) + "\n")
        self.assertIn("6 of 7 maps were whole", self.good(self.maps()).stderr)

    def test_what_decides_a_map_makes_it_again(self):
        self.good(self.maps())
        whole = contents(self.output)
        self.assertIn("7 of 7 maps were whole", self.good(self.maps()).stderr)
        self.write("drives/1.csv", "\n".join([HEADER] + rows(poses=90)) + "\n")
        self.assertIn("6 of 7 maps were whole", self.good(self.maps()).stderr)
        self.assertNotEqual(contents(self.output)["drive 1/row.json"], whole["drive 1/row.json"])
        self.assertNotIn("were whole", self.good(self.maps("--scale", 1.1)).stderr)

    def test_a_damaged_map_is_made_again(self):
        self.good(self.maps())
        whole = contents(self.output)
        (self.output / "drive 0/map.pgm").write_bytes(b"")
        (self.output / "drive 1/walls.svg").unlink()
        (self.output / "drive 2/other").write_bytes(b"")
        (self.output / "drive 3/row.json").write_bytes(b"{")
        self.assertIn("3 of 7 maps were whole", self.good(self.maps()).stderr)
        self.assertEqual(contents(self.output), whole)

    def test_what_somebody_else_made_stays(self):
        mine = self.output / "drive 1"
        mine.mkdir(parents=True)
        (mine / "mine").write_text("mine")
        self.damaged(self.maps(), mine, "in the way")
        self.assertEqual(self.bytes_of(mine), {"mine": b"mine"})

    def test_bad_lists(self):
        good = {"name": "a", "readings": "r.csv"}
        for entries, words in (
                ([dict(good, name="a/b")], ["line 1", "'a/b'"]),
                ([dict(good, name="..")], ["'..'"]),
                ([dict(good, name="")], ["'name'"]),
                ([dict(good, name="n" * 201)], ["200 bytes"]),
                ([{"readings": "r.csv"}], ["'name' is missing"]),
                ([good, dict(good, name="b"), good], ["line 3", "'a'", "line 1"]),
                ([dict(good, acess_points="x")], ["acess-points", "--access-points"]),
                ([dict(good, bag="b.bag")], ["exactly one"]),
                ([{"name": "a"}], ["exactly one"]),
                ([dict(good, scale="two")], ["--scale", "two"]),
                ([dict(good, path={"x": 1})], ["'path'"]),
                (["a"], ["line 1", "must be a map"]),
                ([], ["must be a list"])):
            with self.subTest(entries=entries):
                self.bad(self.maps(list_file=self.write_list(entries, "bad.yaml")), "bad.yaml",
                         *words)
        many = self.write_list([dict(good, name="/")] * 100, "bad.yaml")
        self.assertEqual(self.maps(list_file=many).stderr.count("\n"), 21)
        self.bad(self.maps(list_file=self.folder / "gone.yaml"), "gone.yaml")
        self.bad(self.maps("--readings", self.readings), "--readings", self.list)
        self.bad(self.map("--shard", "1/2"), "--shard", "--list")

    def test_bad_shards(self):
        for shard in ("0/0", "0/4", "5/4", "-1/4", "1", "1/", "/4", "1/2/3", "a/b", "", " 1/4",
                      "1.0/4", "1/1000001", "18446744073709551617/18446744073709551618"):
            with self.subTest(shard=shard):
                self.bad(self.maps("--shard", shard), "--shard", "1 <= I <= N", "'%s'" % shard)
                self.bad(self.bench("--shard", shard), "--shard", "'%s'" % shard)


class Merging(Shards):
    def setUp(self):
        super().setUp()
        self.whole = self.folder / "whole"

    def test_maps_are_those_of_one_process(self):
        self.good(self.maps(output=self.whole))
        for count in (2, 3, 9):
            shutil.rmtree(self.output, ignore_errors=True)
            for i in range(count, 0, -1):
                self.good(self.maps("--shard", "%d/%d" % (i, count)))
            self.assertFalse((self.output / "maps.json").exists())
            self.good(self.merge())
            self.assertEqual(contents(self.output), contents(self.whole))

    def test_tables_are_those_of_one_process(self):
        table = self.good(self.bench(output=self.whole)).stdout
        for i in (1, 2, 3):
            run = self.good(self.bench("--shard", "%d/3" % i))
            self.assertEqual(run.stdout, "")
        self.assertFalse((self.output / "bench.md").exists())
        self.assertEqual(self.good(self.merge()).stdout, table)
        self.assertEqual(contents(self.output), contents(self.whole))

    def test_machines_without_a_common_disk(self):
        self.good(self.maps(output=self.whole))
        for i in (1, 2):
            machine = self.folder / ("machine %d" % i)
            self.good(self.maps("--shard", "%d/2" % i, output=machine))
            shutil.copytree(machine, self.output, dirs_exist_ok=True)
        self.good(self.merge())
        self.assertEqual(contents(self.output), contents(self.whole))

    def test_failures_are_told_again(self):
        self.write("drives/2.csv", "hello\n")
        alone = self.maps(output=self.whole)
        for i in (1, 2):
            self.maps("--shard", "%d/2" % i)
        self.damaged(self.merge(), "1 of 7", alone.stderr.splitlines()[-1])
        self.assertEqual(contents(self.output), contents(self.whole))

    def test_a_failed_recording_of_a_benchmark(self):
        bad = self.write("bad.json", "{}")
        self.damaged(self.bench("--plan", bad, output=self.whole), "bad.json")
        for i in (1, 2):
            self.bench("--plan", bad, "--shard", "%d/2" % i)
        self.damaged(self.merge(), "2 of 6 recordings failed", "bad.json")
        self.assertEqual(contents(self.output), contents(self.whole))

    def test_missing_shards_are_named(self):
        for make in (self.maps, self.bench):
            shutil.rmtree(self.output, ignore_errors=True)
            self.good(make("--shard", "2/4"))
            self.damaged(self.merge(), "shard 1/4 is missing", "--shard 3/4", "--shard 4/4")
            self.assertNotIn("shard 2/4", self.merge().stderr)
        self.damaged(self.merge(output=self.folder / "gone"), "gone", "no part")

    def test_doubled_rows_are_named(self):
        for i in (1, 2):
            self.good(self.maps("--shard", "%d/2" % i))
        shutil.copy(self.output / "shard-1-of-2.json", self.output / "shard-2-of-2.json")
        self.damaged(self.merge(), "shard-1-of-2.json and shard-2-of-2.json both have row 1")
        self.good(self.maps("--shard", "1/4"))
        self.damaged(self.merge(), "divide the list differently", "shard-1-of-4.json")

    def test_other_work_is_named(self):
        for i, more in ((1, []), (2, ["--scale", 2])):
            self.good(self.maps("--shard", "%d/2" % i, *more))
        self.damaged(self.merge(), "differ in the options", "shard-2-of-2.json")
        self.write_list([{"name": name, "readings": "drives/1.csv"}
                         for name in ("other", "drive 1")])
        self.good(self.maps("--shard", "2/2"))
        self.damaged(self.merge(), "differ in the list")
        part = self.output / "shard-2-of-2.json"
        first = json.loads((self.output / "shard-1-of-2.json").read_text())
        for key in ("program", "version"):
            other = json.loads(json.dumps(first))
            other["work"][key] = "another"
            part.write_text(json.dumps(other))
            self.damaged(self.merge(), "differ in the " + key)
        part.write_text("{")
        self.damaged(self.merge(), part, "is damaged")

    def test_another_benchmark_is_named(self):
        self.good(self.bench("--shard", "1/2"))
        for more, word in ((["--seeds", 2], "number of rows"), (["--path", "sparse"], "recordings"),
                           (["--methods", "tomography"], "methods"),
                           (["--access-point-count", 2], "access_points"),
                           (["--config", self.write("c.yaml", "k_visibility: {window: 7}")],
                            "config")):
            self.good(self.bench("--shard", "2/2", *more))
            self.damaged(self.merge(), "differ in the " + word)

    def test_inputs_that_changed_between_shards_are_named(self):
        self.good(self.maps("--shard", "1/2"))
        self.write("access_points.yaml", self.access_points.read_text().replace("7.0", "7.1"))
        self.good(self.maps("--shard", "2/2"))
        self.damaged(self.merge(), "drive 1", "another %s than drive 0" % self.access_points)

    def test_maps_that_are_missing_or_damaged_are_named(self):
        for i in (1, 2):
            self.good(self.maps("--shard", "%d/2" % i))
        shutil.rmtree(self.output / "drive 1")
        (self.output / "drive 2/map.pgm").write_bytes(b"")
        self.damaged(self.merge(), "drive 1: the map is missing", "drive 2: the map is missing")
        self.assertFalse((self.output / "maps.json").exists())


class Workers(Shards):
    def test_a_killed_worker_goes_on(self):
        self.good(self.maps(output=self.folder / "whole"))
        for number in (signal.SIGKILL, signal.SIGTERM):
            with self.subTest(signal=number):
                shutil.rmtree(self.output, ignore_errors=True)
                worker = self.start_maps("--shard", "1/2")
                self.wait_for("drive*/row.json", worker)
                self.wait_for(".drive*", worker)  # in the midst of a map
                worker.send_signal(number)
                self.assertEqual(worker.wait(60), -number)
                self.assertFalse((self.output / "shard-1-of-2.json").exists())
                kept = {path: path.stat().st_mtime_ns for path in self.output.glob("drive*/*")}
                self.assertTrue(kept)
                self.damaged(self.merge(), "no part")
                self.assertIn("maps were whole", self.good(self.maps("--shard", "1/2")).stderr)
                self.assertEqual({path: path.stat().st_mtime_ns for path in kept}, kept)
                self.good(self.maps("--shard", "2/2"))
                self.good(self.merge())
                self.assertEqual(contents(self.output), contents(self.folder / "whole"))
                self.assertEqual(list(self.output.glob(".drive*")), [])

    def test_two_workers_on_one_shard(self):
        worker = self.start_maps("--shard", "1/2")
        self.wait_for(".drive*", worker)
        worker.send_signal(signal.SIGSTOP)
        made = set(self.output.glob(".drive*"))
        self.damaged(self.maps("--shard", "1/2"), self.output, "another worker", "shard 1/2")
        self.good(self.maps("--shard", "2/2"))  # beside it, and it removes nothing of the other
        self.assertEqual(set(self.output.glob(".drive*")), made)
        worker.send_signal(signal.SIGCONT)
        self.assertEqual(worker.wait(60), 0)
        self.good(self.merge())

    def test_two_workers_on_the_same_rows(self):
        self.good(self.maps(output=self.folder / "whole"))
        worker = self.start_maps("--shard", "1/2")
        self.wait_for(".drive*", worker)
        worker.send_signal(signal.SIGSTOP)
        self.good(self.maps())
        worker.send_signal(signal.SIGCONT)
        self.assertEqual(worker.wait(60), 0)
        self.assertEqual(contents(self.output), contents(self.folder / "whole"))

    @NEEDS_PARALLEL
    def test_gnu_parallel_by_its_recipe(self):
        self.write("machines", "2/:\n")
        environment = dict(os.environ, HOME=str(self.folder), PATH="%s:%s" % (
            pathlib.Path(sys.argv[1]).resolve().parent, os.environ["PATH"]))
        for word in ("> drives.yaml", "--sshloginfile"):
            run = subprocess.run(["bash", "-e", "-c", recipe(sys.argv[2], word)], cwd=self.folder, env=environment,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=60)
            self.assertEqual(run.returncode, 0, run.stdout)
        self.good(self.sfw("map", "--list", self.folder / "drives.yaml", "--output", self.output))
        self.assertEqual(contents(self.folder / "maps"), contents(self.output))

    @NEEDS_PARALLEL
    def test_gnu_parallel_tries_a_killed_worker_again(self):
        more = ["--seeds", "4"]
        self.good(self.bench(*more, output=self.folder / "whole"))
        # Each worker is killed once, when there is a first recording.
        killer = self.write("worker", KILLED_ONCE.format(
            first=self.folder / "first", recordings=self.output / "recordings",
            sfw=" ".join([sys.argv[1], "bench", *map(str, BENCH), *more, "--output",
                          str(self.output)])))
        killer.chmod(0o755)
        run = subprocess.run(["parallel", "--will-cite", "--jobs", "2", "--retries", "3",
                              "--joblog", self.folder / "log", killer, ":::", "1", "2"],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=60)
        self.assertEqual(run.returncode, 0, run.stdout)
        for i in (1, 2):
            self.assertEqual((self.folder / ("first.%d" % i)).read_text(), "137\n")
        self.good(self.merge())
        self.assertEqual(contents(self.output), contents(self.folder / "whole"))


if __name__ == "__main__":
    junit.run()
