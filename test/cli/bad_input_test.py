#!/usr/bin/env python3
"""Runs `sfw` on bad input.

Usage: bad_input_test.py RESULT.xml SFW
Each run must end with status 1, a message that names file and line, option or parameter, and an
output directory as it was before.
"""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import ACCESS_POINTS, FAR, HEADER, NEAR, STRANGER, CommandLine, rows  # noqa: E402


class BadReadings(CommandLine):
    def check(self, content, *words):
        readings = self.write("bad.csv", content)
        self.bad(self.map(readings=readings), "bad.csv", *words)
        # evaluate reads the same file in the same way
        self.bad(self.sfw("evaluate", "--map", "m.yaml", "--truth", "t.yaml", "--readings",
                          readings), "bad.csv", *words)

    def test_a_missing_column(self):
        self.check("stamp,x,y,bssid,signal\n0,1,1,%s,-40\n" % NEAR, "line 1", "'rssi_dbm'")

    def test_nan_in_every_row(self):
        self.check(HEADER + "\n0,nan,1,%s,-40\n1,1,1,%s,nan\n" % (NEAR, NEAR), "line 2", "line 3",
                   "not finite")

    def test_no_rows(self):
        self.check(HEADER + "\n", "no rows")

    def test_binary(self):
        self.check(bytes(range(256)) * 10, "'stamp'")

    def test_an_empty_file(self):
        self.bad(self.map(readings=self.write("empty", "")), "empty: the file is empty")

    def test_a_file_that_is_not_there(self):
        missing = self.folder / "missing.csv"
        self.bad(self.map(readings=missing), missing, "No such file")

    def test_a_directory(self):
        self.bad(self.map(readings=self.folder), self.folder, "directory")

    def test_only_unknown_access_points(self):
        readings = self.write("strangers.csv", "\n".join([HEADER] + rows([STRANGER])))
        self.bad(self.map(readings=readings), "strangers.csv", STRANGER, self.access_points)

    def test_only_percent(self):
        text = HEADER + "\n" + "\n".join("%d,%d,1,%s,70" % (i, i, NEAR) for i in range(5))
        self.bad(self.map(readings=self.write("percent.csv", text)), "percent.csv", "(a percentage, or")

    def test_percent_is_named_before_the_program_gives_up(self):
        text = HEADER + "\n" + "\n".join("%d,%d,1,%s,%d" % (i, i, NEAR, 90 - i) for i in range(30))
        self.bad(self.map(readings=self.write("percent.csv", text)), "look like percent")

    def test_millimetres_are_named_where_no_map_is_possible(self):
        table = [row.split(",") for row in rows()]
        text = "\n".join([HEADER] + [",".join([row[0], str(1000 * float(row[1])),
                                               str(1000 * float(row[2])), *row[3:]]) for row in table])
        far = ACCESS_POINTS.replace("0.5", "500").replace("7.0", "7000").replace("1.0", "1000")
        run = self.map(readings=self.write("mm.csv", text),
                       access_points=self.write("mm.yaml", far))
        self.bad(run, "mm.csv", "x and y look like millimetres", "--scale 0.001")

    def test_a_scale_that_is_none(self):
        for scale in ("0", "-1", "nan"):
            self.bad(self.map("--scale", scale), "--scale")

    def test_a_drive_beyond_all_bounds(self):
        far = ["%d,%d,1,%s,-50" % (i, 400000 + i, NEAR) for i in range(3)]
        readings = self.write("far.csv", "\n".join([HEADER] + far))
        self.bad(self.map(readings=readings), self.access_points, "(400000.0, 0.0)", "in one frame")


class BadAccessPoints(CommandLine):
    def check(self, content, *words):
        self.bad(self.map(access_points=self.write("bad.yaml", content)), "bad.yaml", *words)

    def test_malformed_yaml(self):
        self.check("access_points:\n  - {bssid: \"%s\", x: 1, y: 1}\n - {x: ]}\n" % NEAR, "line 3")

    def test_no_list(self):
        for text in ("", "a: 1", "[1, 2]", "access_points: {x: 1}", "text"):
            with self.subTest(text=text):
                self.check(text, "access_points")

    def test_every_problem_is_named(self):
        self.check("access_points:\n"
                   "  - {bssid: \"%s\", x: 1, y: 1}\n"
                   "  - {bssid: \"%s\", x: 2, y: 1}\n"
                   "  - {bssid: \"02:00\", x: 2}\n"
                   "  - {bssid: \"%s\", x: .nan, y: here}\n"
                   "  - 7\n" % (NEAR, NEAR.upper(), FAR),
                   "access_points[1]: %s is in the list twice" % NEAR,
                   "access_points[2]: 'bssid'", "access_points[2]: 'y' is missing",
                   "access_points[3]: 'x'", "access_points[3]: 'y'", "access_points[4]")

    def test_a_point_beyond_all_bounds(self):
        self.check("access_points:\n  - {bssid: \"%s\", x: 1, y: 1}\n"
                   "  - {bssid: \"%s\", x: 1000000, y: 1000000}\n" % (NEAR, FAR), "map/max_cells")

    def test_a_file_that_is_not_there(self):
        missing = self.folder / "missing.yaml"
        self.bad(self.map(access_points=missing), missing, "No such file")

    def test_a_directory(self):
        self.bad(self.map(access_points=self.folder), self.folder, "directory")


class PoseAstray(CommandLine):
    def test_one_that_jumps_away_and_back_changes_nothing(self):
        rows = ["%d,%.1f,%.1f,%s,-50" % (i, 0.1 * i, i // 10, NEAR) for i in range(20)]
        self.good(self.map(readings=self.write("good.csv", "\n".join([HEADER] + rows))))
        rows.insert(10, "9.5,900,1,%s,-50" % NEAR)
        run = self.good(self.map(readings=self.write("bad.csv", "\n".join([HEADER] + rows)),
                                 output=self.folder / "astray"))
        self.assertIn("bad.csv: 1 pose is left out", run.stderr)
        self.assertIn("at 9.500 s", run.stderr)
        for name in ("map.pgm", "map.yaml", "probability.pgm"):
            self.assertEqual((self.output / name).read_bytes(),
                             (self.folder / "astray" / name).read_bytes(), name)

    def test_a_path_too_long_for_the_map(self):
        path = [HEADER] + ["%d,%.1f,1,%s,-50" % (i, 0.1 * i, NEAR) for i in range(20)]
        table = self.write("table.yaml",
                           "access_points:\n  - {bssid: \"%s\", x: 1, y: 1}\n" % NEAR)
        config = self.write("config.yaml",
                            "map: {max_cells: 1200, growth_step: 0.5, margin: 0.1}")
        readings = self.write("path.csv", "\n".join(path))
        self.bad(self.map("--config", config, readings=readings, access_points=table),
                 "map/max_cells (1200)", "stray poses")


class BadConfig(CommandLine):
    def check(self, content, *words):
        config = self.write("config.yaml", content)
        self.bad(self.map("--config", config), "config.yaml", *words)

    def test_resolution_zero(self):
        self.check("map: {resolution: 0}", "map/resolution must be finite and positive; it is 0")

    def test_wrong_type(self):
        self.check("k_visibility: {window: wide}", "k_visibility/window must be a whole number")
        self.check("k_visibility: {window: 2.5}", "k_visibility/window must be a whole number")
        self.check("map: {resolution: [1, 2]}", "map/resolution must be a number")

    def test_every_problem_is_named(self):
        self.check("map: {resolution: .nan, margin: -1}\n"
                   "k_visibility: {window: 4, filter: mode, wall_count: many}\n"
                   "belief: {free_threshold: 0.9, occupied_threshold: 0.2}\n",
                   "map/resolution", "map/margin", "k_visibility/window", "k_visibility/filter", "k_visibility/wall_count",
                   "belief/free_threshold")

    def test_malformed(self):
        self.check("map:\n  resolution: 0.05\n margin: 1\n", "line 3")
        self.check("[1, 2]", "settings")
        self.check("? [a, b]\n: 1\n", "settings")

    def test_a_directory(self):
        self.bad(self.map("--config", self.folder), self.folder)

    def test_a_model_that_is_not_there(self):
        missing = self.folder / "missing_model.yaml"
        config = self.write("config.yaml", f"belief: {{model: {missing}}}")
        run = self.map("--config", config)
        self.bad(run, missing, "No such file")
        self.assertNotIn(str(self.access_points), run.stderr)

    def test_contacts(self):
        contacts = self.write("contacts.csv", "stamp,x,y\n0,1,1\n1,inf,1\n")
        self.bad(self.map("--contacts", contacts), "contacts.csv", "line 3")


class BadBag(CommandLine):
    def bag(self, bag):
        return self.sfw("map", "--bag", bag, "--access-points", self.access_points, "--output",
                        self.output)

    def test_readings_or_bag(self):
        rest = ["--access-points", self.access_points, "--output", self.output]
        self.bad(self.sfw("map", *rest), "--readings", "--bag")
        self.bad(self.sfw("map", "--readings", self.readings, "--bag", "b.bag", *rest),
                 "--readings", "--bag")

    def test_not_a_bag(self):
        for content in (b"", b"hello", b"#ROSBAG V2.0\n", b"#ROSBAG V2.0\n" + bytes(5000)):
            with self.subTest(content=content[:20]):
                path = self.write("empty" if not content else "broken.bag", content)
                self.bad(self.bag(path), path)

    def test_a_bag_that_is_not_there(self):
        self.bad(self.bag(self.folder / "missing.bag"), "missing.bag")

    def test_a_directory(self):
        self.bad(self.bag(self.folder), self.folder)


class BadEvaluation(CommandLine):
    def setUp(self):
        super().setUp()
        self.made = self.folder / "made"
        self.good(self.map(output=self.made))

    def evaluate(self, more=(), **changes):
        options = {"map": self.made / "map.yaml", "truth": self.made / "map.yaml",
                   "readings": self.readings}
        options.update(changes)
        arguments = []
        for name, value in options.items():
            arguments += ["--" + name.replace("_", "-"), value] if value else []
        return self.sfw("evaluate", *arguments, *more)

    def test_files_that_are_not_there(self):
        for option in ("map", "truth", "readings", "access_points", "probability"):
            with self.subTest(option=option):
                self.bad(self.evaluate(**{option: self.folder / "missing"}),
                         self.folder / "missing")

    def test_no_readings(self):
        self.bad(self.evaluate(readings=None), "--readings")

    def test_broken_maps(self):
        self.write("no_image.yaml", "resolution: 0.05\n")
        self.bad(self.evaluate(truth=self.folder / "no_image.yaml"), "no_image.yaml", "image")
        self.write("broken.pgm", b"P5\n10 10\n255\n123")
        self.write("broken.yaml", "image: broken.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n")
        self.bad(self.evaluate(truth=self.folder / "broken.yaml"), "broken.pgm")
        self.write("half.yaml", "image: {\n")
        self.bad(self.evaluate(map=self.folder / "half.yaml"), "half.yaml", "line")

    def test_access_points_that_nobody_hears(self):
        strangers = self.write("strangers.yaml", ACCESS_POINTS.replace("02:00", "02:11"))
        self.bad(self.evaluate(access_points=strangers), "strangers.yaml", "none of its access points")

    def test_a_report_with_settings_of_another_version(self):
        report = json.loads((self.made / "report.json").read_text())
        report["settings"]["method"] = "magic"
        (self.made / "report.json").write_text(json.dumps(report))
        self.good(self.evaluate())
        more = ["--access-points", self.access_points, "--ablations"]
        self.bad(self.evaluate(more=more), "report.json", "magic", "--config")

    def test_prediction_without_positions(self):
        names = self.write("names.yaml", "access_points:\n  - {bssid: \"%s\"}\n" % NEAR)
        (self.made / "report.json").unlink()
        self.bad(self.evaluate(more=["--access-points", names, "--prediction"]), "--prediction",
                 "positions")

    def test_a_path_outside_the_truth(self):
        away = [row.split(",") for row in rows()]
        text = "\n".join([HEADER] + [",".join([a, str(float(b) + 500), *c]) for a, b, *c in away])
        self.bad(self.evaluate(readings=self.write("away.csv", text)), "path")


if __name__ == "__main__":
    junit.run()
