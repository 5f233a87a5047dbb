#!/usr/bin/env python3
"""Explores simulated buildings with `sfw explore`, and ranks goals of maps with `sfw next`.

Usage: explore_test.py RESULT.xml SFW
"""

import csv
import io
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import CommandLine  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FLAT = ROOT / "config" / "demo" / "flat.yaml"


class Case(CommandLine):
    """A case of either command."""

    def complains(self, words, *arguments):
        run = self.sfw(*arguments)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn(words, run.stderr)
        self.assertNotIn("terminate", run.stderr)


class Explore(Case):
    def explore(self, *options):
        run = self.good(self.sfw("explore", "--plan", FLAT, "--start", "3.0,3.65", *options))
        return list(csv.DictReader(io.StringIO(run.stdout)))

    def test_reports_what_is_known_after_each_time(self):
        rows = self.explore("--minutes", 6, "--output", self.output)
        self.assertEqual([row["time_s"] for row in rows], ["300", "360"])
        self.assertLess(float(rows[0]["driven_m"]), float(rows[1]["driven_m"]))
        self.assertGreater(float(rows[1]["known_m2"]), 15.0)
        self.assertTrue((self.output / "map.png").exists())
        self.assertEqual(len((self.output / "exploration.csv").read_text().splitlines()), 3)

    def test_the_same_seed_explores_the_same(self):
        self.assertEqual(self.explore("--minutes", 1), self.explore("--minutes", 1))
        self.assertNotEqual(self.explore("--minutes", 1),
                            self.explore("--minutes", 1, "--seed", 2))

    def test_names_an_unknown_policy(self):
        self.complains("there is no policy 'greedy'", "explore", "--plan", FLAT,
                       "--policy", "greedy")

    def test_names_a_start_in_a_wall(self):
        self.complains("does not fit at (0.10, 0.10)", "explore", "--plan", FLAT,
                       "--start", "0.1,0.1")


class Next(Case):
    def next(self, *options):
        run = self.good(self.sfw("next", "--map", self.output, *options))
        return list(csv.DictReader(io.StringIO(run.stdout))), run.stderr

    def test_ranks_goals_from_a_place_and_draws_them(self):
        self.good(self.map())
        goals, says = self.next("--from", "4.0,2.0", "--count", 3)
        self.assertEqual([goal["rank"] for goal in goals], ["1", "2", "3"])
        gains = [float(goal["gain_m2_s"]) for goal in goals]
        self.assertEqual(gains, sorted(gains, reverse=True))
        self.assertIn("of new free space", says)
        self.assertTrue((self.output / "next.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_recording_beside_the_map_tells_where_the_robot_is(self):
        self.good(self.map())
        self.complains("give --from", "next", "--map", self.output)
        (self.output / "readings.csv").write_text(self.readings.read_text())
        (self.output / "access_points.yaml").write_text(self.access_points.read_text())
        goals, _ = self.next()
        self.assertTrue(goals)

    def test_names_what_is_no_map(self):
        self.complains("map.yaml", "next", "--map", self.folder / "nothing", "--from", "0,0")
        self.good(self.map())
        walls = self.output / "walls.yaml"
        walls.write_text("walls: 3\n")
        self.complains("walls.yaml: it holds no list", "next", "--map", self.output,
                       "--from", "0,0")
        walls.write_text("walls:\n  - {from: [0, 0], to: [1], confidence: 0.5, outer: false}\n")
        self.complains("wall 1 needs", "next", "--map", self.output, "--from", "0,0")


if __name__ == "__main__":
    junit.run()
