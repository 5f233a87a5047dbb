#!/usr/bin/env python3
"""Runs `sfw evaluate` on small maps whose metrics can be worked out by hand.

Usage: evaluate_test.py RESULT.xml SFW
"""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, NEAR, CommandLine  # noqa: E402


class Evaluation(CommandLine):
    """Two rooms of 1.5 m x 2 m with a wall of 0.1 m between them, and a door above the wall."""
    # Two places in each room. Three of the six lines between them meet the wall.
    PLACES = [(0.85, 0.65), (2.45, 0.65), (0.85, 1.65), (2.45, 1.65)]

    def setUp(self):
        super().setUp()
        table = ["%d,%g,%g,%s,-50" % (i, x, y, NEAR) for i, (x, y) in enumerate(self.PLACES)]
        self.places = self.write("places.csv", "\n".join([HEADER] + table) + "\n")
        self.truth = self.draw("truth", wall=12)

    def draw(self, name, wall, mode="trinary"):
        """Draws the rooms with a wall up to a row, in cells of 0.1 m; returns the file's name."""
        (self.folder / name).mkdir(exist_ok=True)
        pixels = bytearray()
        for y in range(21, -1, -1):
            row = [0 if x in (0, 32) or y in (0, 21) or (x == 16 and y <= wall) else 254
                   for x in range(33)]
            pixels += bytes(row)
        file = "probability" if mode == "scale" else "map"
        self.write("%s/%s.pgm" % (name, file), b"P5\n33 22\n255\n" + bytes(pixels))
        return self.write("%s/%s.yaml" % (name, file), "image: %s.pgm\nresolution: 0.1\n"
                          "origin: [0, 0, 0]\nnegate: 0\nmode: %s\noccupied_thresh: 0.65\n"
                          "free_thresh: 0.196\n" % (file, mode))

    def evaluate(self, name, *more):
        return self.good(self.sfw("evaluate", "--map", self.folder / name / "map.yaml", "--truth",
                                  self.truth, "--readings", self.places, *more))

    def json(self, name, *more):
        return json.loads(self.evaluate(name, "--json", *more).stdout)

    def row(self, text, table):
        lines = [line for line in table.splitlines() if line.startswith(text)]
        self.assertEqual(len(lines), 1, table)
        return re.split("  +", lines[0].strip())

    def test_the_truth_itself_is_perfect(self):
        self.draw("truth", wall=12, mode="scale")
        metrics = self.json("truth")["map"]
        for key in ("knows_wall_f1", "knows_wall_auc", "places_reached", "detour_median"):
            self.assertEqual(metrics[key], 1.0, key)
        for key in ("plans_through_walls", "no_plan", "detours_over_1m"):
            self.assertEqual(metrics[key], 0.0, key)
        table = self.evaluate("truth").stdout
        self.assertIn("6 pairs of places of the path, 3 with a true wall between", table)
        for text, value in (("knows the wall: F1", "1.00"), ("plans through walls", "0 %"),
                            ("places reached", "100 %")):
            self.assertIn(value, self.row(text, table))

    def test_half_a_wall_is_half_known(self):
        self.draw("half", wall=8)  # one of three walls is called, none too many: 2 / (1 + 3)
        metrics = self.json("half")["map"]
        self.assertEqual(metrics["knows_wall_f1"], 0.5)
        self.assertIsNone(metrics["knows_wall_auc"])
        table = self.evaluate("half").stdout
        self.assertIn("0.50", self.row("knows the wall: F1", table))
        self.assertIn("probability.yaml", table)

    def test_plans_cross_a_wall_that_the_map_lacks(self):
        self.draw("open", wall=0)
        metrics = self.json("open")["map"]
        self.assertEqual(metrics["knows_wall_f1"], 0.0)
        self.assertGreater(metrics["plans_through_walls"], 0.0)
        self.assertEqual(metrics["no_plan"], 0.0)

    def test_a_closed_door_leaves_places_out_of_reach(self):
        self.draw("closed", wall=20)
        metrics = self.json("closed")["map"]
        self.assertAlmostEqual(metrics["knows_wall_f1"], 6 / 7)
        self.assertGreater(metrics["no_plan"], 0.1)
        self.assertEqual(metrics["plans_through_walls"], 0.0)

    def test_maps_stand_beside_each_other(self):
        other = self.draw("half", wall=8)
        table = self.evaluate("truth", "--beside", "half a wall=%s" % other).stdout
        head = re.split("  +", table.splitlines()[0].strip())
        self.assertEqual(head, ["this map", "half a wall", "path alone", "what is good"])

    def test_the_long_table_comes_with_all(self):
        self.assertNotIn("free: precision", self.evaluate("truth").stdout)
        table = self.evaluate("truth", "--all").stdout
        self.assertIn("free: precision", table)
        self.assertIn("path only", table)

    def test_the_report_gives_positions_that_the_table_leaves_out(self):
        names = self.write("names.yaml", "access_points:\n  - {bssid: \"%s\"}\n" % NEAR)
        run = self.evaluate("truth", "--access-points", names, "--json")
        self.assertIn("observed walls are left out", run.stderr)
        self.assertIsNone(json.loads(run.stdout)["observed_wall_cells"])
        self.write("truth/report.json", json.dumps(
            {"access_points": [{"bssid": NEAR, "x": 2.45, "y": 0.65}]}))
        run = self.evaluate("truth", "--access-points", names, "--json")
        self.assertEqual(run.stderr, "")
        self.assertGreater(json.loads(run.stdout)["observed_wall_cells"], 0)

    def test_a_report_of_another_program_is_no_obstacle(self):
        names = self.write("names.yaml", "access_points:\n  - {bssid: \"%s\"}\n" % NEAR)
        for content in ("[1]", "{", '{"access_points": 3}', '{"access_points": [{"bssid": 1}]}'):
            self.write("truth/report.json", content)
            self.evaluate("truth", "--access-points", names)


class Comparison(CommandLine):
    def test_a_picture_lays_the_map_over_the_truth(self):
        self.good(self.map())
        picture = self.folder / "picture.png"
        judge = ("evaluate", "--map", self.output / "map.yaml", "--truth", self.output / "map.yaml",
                 "--readings", self.readings, "--picture")
        self.good(self.sfw(*judge, picture))
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
        run = self.sfw(*judge, self.folder / "none" / "picture.png")
        self.assertEqual(run.returncode, 1)
        self.assertIn("picture.png", run.stderr)

    def test_maps_beside_each_other(self):
        self.good(self.map())
        made, panels = self.output / "map.yaml", self.folder / "panels.png"
        judge = ("evaluate", "--map", made, "--truth", made, "--readings", self.readings,
                 "--beside")
        run = self.good(self.sfw(*judge, "the same=%s" % made, "--panels", panels, "--json"))
        metrics = json.loads(run.stdout)
        self.assertEqual(metrics["beside"], {"the same": metrics["map"]})
        self.assertTrue(panels.read_bytes().startswith(b"\x89PNG"))
        self.assertIn("the same", self.good(self.sfw(*judge, "the same=%s" % made)).stdout)
        for words in (made, "=%s" % made, "title=none.yaml"):
            self.assertEqual(self.sfw(*judge, words).returncode, 1)
        twice = self.sfw(*judge, "the same=%s" % made, "--beside", "the same=%s" % made)
        self.assertEqual(twice.returncode, 1)
        self.assertIn("'the same' twice", twice.stderr)

    def test_probabilities_that_are_named_are_taken_for_those_beside_the_map(self):
        self.good(self.map())
        beside = self.output / "probability.yaml"
        named = self.output / "named.yaml"
        named.write_text(beside.read_text())
        beside.write_text("broken")
        judge = ("evaluate", "--map", self.output / "map.yaml", "--truth",
                 self.output / "map.yaml", "--readings", self.readings)
        self.assertEqual(self.sfw(*judge).returncode, 1)
        self.good(self.sfw(*judge, "--probability", named))

    def test_a_map_of_another_place_is_told(self):
        self.good(self.map())
        yaml = (self.output / "map.yaml").read_text()
        far = self.output / "far.yaml"
        far.write_text(re.sub(r"origin: \[[^,]*", "origin: [900", yaml))
        run = self.good(self.sfw("evaluate", "--map", far, "--truth", self.output / "map.yaml",
                                 "--readings", self.readings))
        self.assertIn("far.yaml", run.stderr)
        self.assertIn("same frame", run.stderr)


if __name__ == "__main__":
    junit.run()
