#!/usr/bin/env python3
"""Runs `sfw bench`: whole, interrupted, resumed, and on bad input.

Usage: bench_test.py RESULT.xml SFW SOURCE_DIR
"""

import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import CommandLine  # noqa: E402

MAPS = ["tomography, fused belief", "tomography, shifted radio", "tomography, no radio",
        "k_visibility, K-means k", "k_visibility, true k", "k_visibility, shifted radio",
        "k_visibility, no radio", "every ray is free", "path only"]


class Bench(CommandLine):
    def bench(self, *arguments, output=None):
        return self.sfw("bench", *arguments, "--output", output or self.output)

    def tables(self, folder):
        return [(folder / name).read_bytes() for name in ("bench.md", "bench.json")]

    def recordings(self, folder):
        return sorted((folder / "recordings").iterdir())


class Tables(Bench):
    def test_each_map_has_a_row_with_mean_and_spread(self):
        run = self.good(self.bench("--generate", 1, "--noise", "none", "--seeds", 2))
        table, report = self.tables(self.output)
        self.assertEqual(run.stdout.encode(), table)
        rows = [line.split(" | ") for line in run.stdout.splitlines() if line.startswith("| none")]
        self.assertEqual([row[1] for row in rows], MAPS)
        self.assertRegex(rows[0][2], r"^[01]\.\d{3} ± 0\.\d{3}$")
        report = json.loads(report)
        self.assertEqual([row["made_by"] for row in report["summary"]], MAPS)
        counts = [row["metrics"]["free_iou"]["count"] for row in report["summary"]]
        self.assertEqual(counts, [2, 16, 2, 2, 2, 16, 2, 2, 2])
        self.assertEqual([recording["seed"] for recording in report["recordings"]], [1, 2])
        shipped = [recording["maps"][0]["metrics"]["free_iou"]
                   for recording in report["recordings"]]
        metric = report["summary"][0]["metrics"]["free_iou"]
        self.assertAlmostEqual(metric["mean"], sum(shipped) / 2)
        self.assertAlmostEqual(metric["sd"], abs(shipped[0] - shipped[1]) / 2, places=6)
        self.assertEqual(report["failed"], [])

    def test_workers_do_not_matter(self):
        for workers in (1, 3):
            self.good(self.bench("--generate", 2, "--noise", "none", "hard", "--workers", workers,
                                 output=self.folder / str(workers)))
        self.assertEqual(self.tables(self.folder / "1"), self.tables(self.folder / "3"))

    def test_a_terminal_sees_how_far_it_is(self):
        try:
            master, slave = pty.openpty()
        except OSError as error:  # as in a chroot without /dev/pts
            self.skipTest("no terminal can be made: %s" % error)
        self.addCleanup(os.close, master)
        subprocess.run([sys.argv[1], "bench", "--generate", "2", "--noise", "none", "--workers",
                        "1", "--output", self.output], stdout=subprocess.DEVNULL, stderr=slave,
                       timeout=60, check=True)
        os.close(slave)
        shown = os.read(master, 65536).decode()
        self.assertRegex(shown, r"1/2, \d+:\d\d left")
        self.assertRegex(shown, r"2/2, done in \d+:\d\d")


class Resuming(Bench):
    SCOPE = ("--generate", 2, "--noise", "none", "low", "--workers", 1)

    def whole(self):
        folder = self.folder / "whole"
        self.good(self.bench(*self.SCOPE, output=folder))
        return folder

    def test_goes_on_where_a_run_was_interrupted(self):
        whole = self.whole()
        for number in (signal.SIGINT, signal.SIGKILL):
            with self.subTest(signal=number):
                folder = self.folder / str(int(number))
                run = subprocess.Popen([sys.argv[1], "bench", *map(str, self.SCOPE), "--output",
                                        folder], stdout=subprocess.DEVNULL)
                while not list(folder.glob("recordings/*.json")) and run.poll() is None:
                    time.sleep(0.005)
                run.send_signal(number)
                self.assertEqual(run.wait(60), -number)
                self.assertFalse((folder / "bench.md").exists())
                kept = {path: path.stat().st_mtime_ns
                        for path in folder.glob("recordings/*.json")}
                self.assertTrue(0 < len(kept) < 4, len(kept))
                (folder / "recordings" / "0123456789abcdef.json.AbC123").write_text("{")
                self.good(self.bench(*self.SCOPE, output=folder))
                self.assertEqual({path: path.stat().st_mtime_ns for path in kept}, kept)
                self.assertEqual(self.tables(folder), self.tables(whole))
                self.assertEqual(self.bytes_of(folder / "recordings"),
                                 self.bytes_of(whole / "recordings"))

    def test_a_damaged_recording_is_made_again(self):
        whole = self.whole()
        before = self.bytes_of(whole / "recordings")
        tables = self.tables(whole)
        for damaged, bytes_left in zip(self.recordings(whole), (b"", b"{}", b"[1]")):
            damaged.write_bytes(bytes_left)
        last = self.recordings(whole)[3]
        last.write_bytes(last.read_bytes().replace(b'"key": "', b'"key": "x'))
        self.good(self.bench(*self.SCOPE, output=whole))
        self.assertEqual(self.bytes_of(whole / "recordings"), before)
        self.assertEqual(self.tables(whole), tables)

    def test_what_decides_a_recording_tells_it_from_others(self):
        base = {"--generate": 1, "--noise": "none"}
        config = self.write("config.yaml", "k_visibility: {window: 7}")
        known = 0
        for more in ({}, {"--seeds": 2}, {"--noise": "low"}, {"--path": "sparse"},
                     {"--access-point-count": 2}, {"--config": config}, {"--generate": 2}):
            options = {**base, **more}
            self.good(self.bench(*(word for option in options.items() for word in option)))
            self.assertEqual(len(self.recordings(self.output)), known + 1, more)
            known += 1
        # A copy of a plan is the same plan.
        first, second = self.folder / "first.yaml", self.folder / "second.yaml"
        source = pathlib.Path(sys.argv[2]) / "config/demo/flat.yaml"
        (self.folder / "flat.pgm").write_bytes((source.parent / "flat.pgm").read_bytes())
        for copy in (first, second):
            copy.write_bytes(source.read_bytes())
        self.good(self.bench("--plan", first, second, "--noise", "none", "--workers", 1))
        self.assertEqual(len(self.recordings(self.output)), known + 1)


class Suites(Bench):
    def test_a_suite_says_what_runs(self):
        (self.folder / "plans").mkdir()
        demo = pathlib.Path(sys.argv[2]) / "config/demo"
        for name in ("flat.yaml", "flat.pgm"):
            (self.folder / "plans" / name).write_bytes((demo / name).read_bytes())
        (self.folder / "plans" / "route.csv").write_bytes((demo / "route.csv").read_bytes())
        suite = self.write("suite.yaml", "plans: [plans]\npaths: [sparse, plans/route.csv]\n"
                           "levels: [none]\nmethods: [k_visibility]\naccess_points: 2\n")
        self.good(self.bench("--suite", suite))
        report = json.loads(self.tables(self.output)[1])
        self.assertEqual([recording["path"] for recording in report["recordings"]],
                         ["sparse", str(self.folder / "plans/route.csv")])
        self.assertEqual({recording["plan"] for recording in report["recordings"]},
                         {str(self.folder / "plans/flat.yaml")})

    def test_options_go_before_the_shipped_suite(self):
        suite = pathlib.Path(sys.argv[2]) / "config/bench.yaml"
        self.good(self.bench("--suite", suite, "--generate", 1, "--noise", "none", "--path",
                             "walls"))
        report = json.loads(self.tables(self.output)[1])
        self.assertEqual([(recording["plan"], recording["seed"])
                          for recording in report["recordings"]],
                         [("generated 1", 1), ("generated 1", 2)])

    def test_what_is_wrong_with_a_suite_is_named(self):
        for text, words in (("plan: [x]\n", ["'plan'", "plans"]),
                            ("seeds: many\n", ["seeds"]),
                            ("levels: loud\n", ["levels"]),
                            ("- 1\n", ["must be a map"]),
                            ("seeds: [\n", ["line"])):
            with self.subTest(text=text):
                self.bad(self.bench("--suite", self.write("bad.yaml", text)), "bad.yaml", *words)
        self.bad(self.bench("--suite", self.folder / "none.yaml"), "none.yaml")
        everything = self.write("all.yaml", "levels: [loud]\npaths: [there]\nmethods: [magic]\n"
                                "generate: -1\nseeds: 0\naccess_points: 0\nplans: [gone.json]\n")
        self.bad(self.bench("--suite", everything), "loud", "there", "magic", "k_visibility",
                 "generate", "seeds", "access_points", "gone.json")


class Failures(Bench):
    def test_nothing_to_run_on(self):
        self.bad(self.bench(), "--plan", "--generate")
        (self.folder / "empty").mkdir()
        self.bad(self.bench("--plan", self.folder / "empty"), "--plan")
        self.bad(self.bench("--plan", self.folder / "gone"), "gone")

    def test_bad_settings_stop_it_before_it_starts(self):
        config = self.write("config.yaml", "map: {resolution: -1}")
        self.bad(self.bench("--generate", 1, "--config", config), "map/resolution")
        self.bad(self.bench("--generate", 1, "--noise", "loud"), "loud", "realistic")

    def test_one_bad_plan_does_not_take_the_others_with_it(self):
        bad = self.write("bad.json", "{}")
        run = self.bench("--plan", bad, "--generate", 1, "--noise", "none")
        self.assertEqual(run.returncode, 1)
        self.assertIn("1 of 2 recordings failed", run.stderr)
        self.assertIn("bad.json, none, walls, seed 1: ", run.stderr)
        self.assertIn("'verts'", run.stderr)
        table, report = self.tables(self.output)
        self.assertIn("| none | path only |", table.decode())
        self.assertIn("Left out: %s" % bad, table.decode())
        report = json.loads(report)
        self.assertEqual([recording["plan"] for recording in report["recordings"]],
                         ["generated 1"])
        self.assertEqual([failure["plan"] for failure in report["failed"]], [str(bad)])

    def test_results_that_cannot_be_kept_end_it(self):
        way = self.write("way", "mine")
        self.bad(self.bench("--generate", 1, "--noise", "none", output=way), way)
        self.assertEqual(way.read_text(), "mine")


if __name__ == "__main__":
    junit.run()
