#!/usr/bin/env python3
"""Runs `sfw` on good input, and asks it for help.

Usage: command_line_test.py RESULT.xml SFW
"""

import json
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import FAR, HEADER, MAP_FILES, NEAR, STRANGER, CommandLine, rows  # noqa: E402


ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
COMMANDS = ("map", "evaluate", "visibility", "dense", "choose-sites", "simulate", "bench", "fit",
            "wall-drives", "localise")
OPTION_OF = {"evaluate": "--json", "choose-sites": "--count"}


class Help(CommandLine):
    def test_each_command_explains_itself(self):
        for command in COMMANDS:
            for option in ("--help", "-h"):
                with self.subTest(command=command, option=option):
                    run = self.good(self.sfw(command, option))
                    self.assertIn("Usage: sfw " + command, run.stdout)
                    self.assertIn(OPTION_OF.get(command, "--output"), run.stdout)

    def test_help_names_placeholder_default_range_and_unit(self):
        text = " ".join(self.good(self.sfw("simulate", "--help")).stdout.split())
        self.assertIn("--access-point-count N number of access points to place if neither "
                      "--access-point nor --access-points is given, in 1..100; default: 1", text)
        self.assertIn("--robot-radius METRES radius of the robot [m]; default: 0.15", text)
        self.assertIn("--output DIRECTORY", text)

    def test_the_programs_help_names_its_commands(self):
        text = self.good(self.sfw("--help")).stdout
        self.assertIn("Usage: sfw", text)
        for command in COMMANDS:
            self.assertIn(command, text)

    def test_the_version_is_that_of_the_package(self):
        version = re.search("<version>(.*)</version>", (ROOT / "package.xml").read_text())[1]
        self.assertEqual(self.good(self.sfw("--version")).stdout, "sfw %s\n" % version)

    def test_unknown_commands_and_options_are_named(self):
        self.bad(self.sfw("mop"), "'mop'", "sfw --help")
        self.bad(self.sfw(), "subcommand")
        self.bad(self.map("--resolution", "0.1"), "--resolution", "sfw map --help")
        self.bad(self.sfw("evaluate", "--mup", "x"), "--mup", "did you mean --map?")
        self.bad(self.map("stray"), "'stray'", "sfw map --help")

    def test_missing_options_are_named(self):
        self.bad(self.sfw("map", "--readings", self.readings, "--access-points",
                          self.access_points), "--output")

    def test_a_value_that_is_missing_or_wrong_is_named(self):
        self.bad(self.sfw("choose-sites", "--generate"), "--generate")
        self.bad(self.sfw("choose-sites", "--generate", "flat", "--area", "big"),
                 "--area must be a number; it is 'big'")
        self.bad(self.sfw("choose-sites", "--generate", "flat", "--seed", "1.5"),
                 "--seed must be a whole number; it is '1.5'")
        self.bad(self.sfw("choose-sites", "--generate", "flat", "--count", "101"),
                 "--count must be in 1..100; it is '101'")
        self.bad(self.map("--output", self.folder), "--output", "more than once")

    def test_old_names_are_taken_with_a_warning(self):
        new = self.good(self.sfw("choose-sites", "--generate", "flat"))
        old = self.good(self.sfw("place", "--generate", "flat"))
        self.assertEqual(old.stdout, new.stdout)
        self.assertIn("choose-sites", old.stderr)
        self.assertEqual(new.stderr, "")
        run = self.sfw("evaluate", "--controls", "--map", "m", "--truth", "t", "--readings",
                       self.folder / "none.csv")
        self.assertIn("--controls is now called --ablations", run.stderr)
        self.assertIn("none.csv", run.stderr)

    def test_fit_warns_of_old_settings(self):
        config = self.write("old.yaml", "tomography: {bin: 0.3}\n")
        run = self.sfw("fit", "--config", config, "--plan", self.folder / "none.json", "--output",
                       self.output / "model.yaml")
        self.assertIn("tomography/bin is now called tomography/bin_size", run.stderr)
        self.assertIn("none.json", run.stderr)


class Simulate(CommandLine):
    def test_takes_negative_and_several_positions_in_every_form(self):
        flat = ["simulate", "--generate", "flat", "--noise", "none", "--output", self.output]
        away = self.sfw(*flat, "--access-point", "-1.5,2")
        self.assertEqual(away.returncode, 1)
        self.assertIn("(-1.50, 2.00)", away.stderr)
        tables = []
        for points in (["--access-point", "1.5,2", "--access-point", "3,2"],
                       ["--access-point=1.5,2", "--access-point=3,2"],
                       ["--access-point", "1.5,2", "3,2"]):
            self.good(self.sfw(*flat, *points, "--force"))
            tables.append((self.output / "access_points.yaml").read_text())
        self.assertEqual(tables[0].count("bssid"), 2)
        self.assertEqual(len(set(tables)), 1)

    def test_never_overwrites_a_recording(self):
        flat = ["simulate", "--generate", "flat", "--noise", "none", "--output", self.output]
        self.output.mkdir()
        for name in ("readings.csv", "access_points.yaml", "truth.yaml", "truth.pgm",
                     "recording.bag"):
            mine = self.output / name
            mine.write_text("mine")
            run = self.sfw(*flat)
            self.assertEqual(run.returncode, 1)
            self.assertIn("%s is there already" % mine, run.stderr)
            self.assertIn("--force", run.stderr)
            self.assertEqual([path.name for path in self.output.iterdir()], [name])
            self.assertEqual(mine.read_text(), "mine")
            mine.unlink()
        self.good(self.sfw(*flat))
        first = (self.output / "readings.csv").read_text()
        self.good(self.sfw(*flat, "--seed", 2, "--force"))
        self.assertNotEqual((self.output / "readings.csv").read_text(), first)

    def test_takes_a_table_of_access_points_or_their_number(self):
        flat = ["simulate", "--generate", "flat", "--noise", "none", "--force", "--output",
                self.output]
        table = self.write("two.yaml", 'access_points:\n  - {bssid: "%s", x: 1.5, y: 2}\n'
                                       '  - {bssid: "%s", x: 3, y: 2}\n' % (STRANGER, FAR))
        self.good(self.sfw(*flat, "--access-points", table))
        self.assertIn(STRANGER, (self.output / "readings.csv").read_text())
        self.assertIn(STRANGER, (self.output / "access_points.yaml").read_text())
        tables = []
        for option in ("--access-point-count", "--access-points"):
            run = self.good(self.sfw(*flat, option, 3))
            self.assertEqual("is now called --access-point-count" in run.stderr,
                             option == "--access-points")
            tables.append((self.output / "access_points.yaml").read_text())
        self.assertEqual(tables[0].count("bssid"), 3)
        self.assertEqual(tables[0], tables[1])
        nowhere = self.write("nowhere.yaml", 'access_points:\n  - {bssid: "%s"}\n' % FAR)
        self.assertIn(FAR + " needs x and y", self.sfw(*flat, "--access-points", nowhere).stderr)
        self.assertIn("in 1..100", self.sfw(*flat, "--access-points", 0).stderr)


class ChooseSites(CommandLine):
    FLAT = ROOT / "config" / "demo" / "flat.yaml"

    def test_prints_a_table_that_map_reads(self):
        table = self.good(self.sfw("choose-sites", "--plan", self.FLAT, "--count", 3)).stdout
        self.assertEqual(table.count("bssid"), 3)
        self.assertEqual(table.count("\n"), 4)
        self.good(self.map(access_points=self.write("chosen.yaml", table)))
        again = self.sfw("choose-sites", "--plan", self.FLAT, "--count", 3, "--parameter").stdout
        self.assertEqual("access_points:\n" + again, table)
        self.assertNotEqual(self.sfw("choose-sites", "--plan", self.FLAT, "--count", 3, "--seed", 2).stdout,
                            table)

    def test_names_what_it_cannot_use(self):
        self.bad(self.sfw("choose-sites"), "--plan", "--generate")
        self.bad(self.sfw("choose-sites", "--plan", "p.yaml", "--generate", "flat"), "--plan")
        self.bad(self.sfw("choose-sites", "--generate", "castle"), "castle", "flat, office")
        self.bad(self.sfw("choose-sites", "--plan", self.folder / "no.json"), "no.json", "No such file")
        self.bad(self.sfw("choose-sites", "--generate", "flat", "--count", 0), "--count")


class GoodInput(CommandLine):
    def test_writes_all_files_whole(self):
        self.good(self.map())
        files = self.bytes_of(self.output)
        self.assertEqual(sorted(files), MAP_FILES)
        self.assertTrue(files["map.pgm"].startswith(b"P5"))
        self.assertTrue(files["map.png"].startswith(b"\x89PNG"))
        self.assertTrue(files["map.bt"].startswith(b"# Octomap OcTree binary file\n"))
        self.assertTrue(files["map.ot"].startswith(b"# Octomap OcTree file\n"))
        report = json.loads(files["report.json"])
        self.assertEqual([ap["readings"] for ap in report["access_points"]], [120, 120])

    def test_the_same_input_gives_the_same_bytes(self):
        self.good(self.map())
        self.good(self.map(output=self.folder / "again"))
        self.assertEqual(self.bytes_of(self.output), self.bytes_of(self.folder / "again"))
        self.good(self.map())  # over its own files
        self.assertEqual(self.bytes_of(self.output), self.bytes_of(self.folder / "again"))

    def test_order_repetition_and_form_of_the_rows_do_not_matter(self):
        self.good(self.map())
        table = rows()
        shuffled = ["y , rssi_dbm,note,bssid,stamp, x"]
        for row in reversed(table + table[:40]):
            stamp, x, y, bssid, rssi_dbm = row.split(",")
            shuffled.append(", ".join([y, rssi_dbm, "-", bssid.upper().replace(":", "-"), stamp, x]))
        text = "\r\n".join(shuffled) + "\r\n\r\n"
        self.good(self.map(readings=self.write("shuffled.csv", text), output=self.folder / "again"))
        self.assertEqual(self.bytes_of(self.output)["map.pgm"],
                         self.bytes_of(self.folder / "again")["map.pgm"])

    def test_rows_with_faults_are_skipped_and_named(self):
        faults = ["1.0,nan,2,%s,-50" % NEAR, "1.0,2,2,%s,-50dBm" % NEAR, "1.0,2,2,02:00,-50",
                  "1.0,2", "1.0,2,2,%s,inf" % NEAR, "1.0,3,-inf,%s,-50" % NEAR]
        table = rows()
        text = "\n".join([HEADER] + table[:5] + faults + table[5:]) + "\n"
        run = self.good(self.map(readings=self.write("faulty.csv", text)))
        for line, words in ((7, "x 'nan'"), (8, "'-50dBm'"), (9, "'02:00'"), (10, "y ''"),
                            (11, "'inf'"), (12, "'-inf'")):
            self.assertIn("line %d: " % line, run.stderr)
            self.assertIn(words, run.stderr)
        self.assertIn("faulty.csv", run.stderr)
        left_out = json.loads((self.output / "report.json").read_text())["left_out"]["by_reason"]
        self.assertEqual(sum(left_out.values()), len(faults))
        self.good(self.map(output=self.folder / "again"))
        self.assertEqual(self.bytes_of(self.output)["map.pgm"],
                         self.bytes_of(self.folder / "again")["map.pgm"])

    def test_what_is_left_out_is_counted_and_named(self):
        more = ["1.0,2,2,%s,70" % NEAR, "1.0,2,2,%s,-50" % STRANGER, "1.2,2,2,%s,-51" % STRANGER]
        text = "\n".join([HEADER] + rows() + more)
        run = self.good(self.map(readings=self.write("more.csv", text)))
        self.assertIn("1 reading left out: rssi_dbm is not in (-120, 0]", run.stderr)
        self.assertIn("percent", run.stderr)
        self.assertIn("(1 BSSID: %s 2 times)" % STRANGER, run.stderr)

    def warnings(self, table, **options):
        run = self.map(readings=self.write("some.csv", "\n".join([HEADER] + table)), **options)
        return run, [line for line in run.stderr.splitlines() if "warning: " in line]

    def test_neighbours_are_no_warning(self):
        run, warnings = self.warnings(rows() + rows([STRANGER]))
        self.good(run)
        self.assertEqual(warnings, [])
        self.assertIn("left out: bssid is not in the table of access points", run.stderr)

    def test_a_fault_is_told_once(self):
        heard = [row.split(",") for row in rows()]
        percent = [",".join((*row[:4], str(60 + i % 30))) for i, row in enumerate(heard)]
        half = [row if FAR in row else ",".join(heard[i]) for i, row in enumerate(percent)]
        far = [",".join((row[0], str(100 * float(row[1])), str(100 * float(row[2])), *row[3:]))
               for row in heard]
        for table, words in ((half, "look like percent"), (percent, "look like percent"),
                             (far, "look like centimetres"), (rows([STRANGER]), STRANGER)):
            run, warnings = self.warnings(table)
            self.assertEqual(len(warnings), 1, run.stderr)
            self.assertIn(words, warnings[0])

    def test_other_units_of_positions_are_scaled(self):
        self.good(self.map())
        table = [row.split(",") for row in rows()]
        scaled = [",".join([stamp, "%.2f" % (100 * float(x)), "%.2f" % (100 * float(y)), *rest])
                  for stamp, x, y, *rest in table]
        readings = self.write("cm.csv", "\n".join([HEADER] + scaled))
        access_points = self.write("cm.yaml", """access_points:
  - {bssid: "%s", x: 50, y: 50, name: near}
  - {bssid: "%s", x: 700, y: 100}
""" % (NEAR, FAR))
        self.good(self.map("--scale", "0.01", readings=readings, access_points=access_points,
                           output=self.folder / "again"))
        self.assertEqual(self.bytes_of(self.output)["map.pgm"],
                         self.bytes_of(self.folder / "again")["map.pgm"])

    def test_a_misspelt_setting_is_pointed_out(self):
        config = self.write("config.yaml", "k_visibility: {windw: 7}")
        run = self.good(self.map("--config", config))
        for words in ("config.yaml", "k_visibility/windw", "k_visibility/window"):
            self.assertIn(words, run.stderr)

    def test_evaluates_what_it_made(self):
        self.good(self.map())
        run = self.good(self.sfw("evaluate", "--map", self.output / "map.yaml", "--truth",
                                 self.output / "map.yaml", "--readings", self.readings, "--json"))
        metrics = json.loads(run.stdout)
        self.assertEqual(metrics["map"]["free_precision"], 1.0)
        self.assertEqual(metrics["map"]["free_iou"], 1.0)
        table = self.good(self.sfw("evaluate", "--map", self.output / "map.yaml", "--truth",
                                   self.output / "map.yaml", "--readings", self.readings)).stdout
        self.assertRegex(table, "knows the wall: F1 +- +- +1 is perfect")  # nothing stands between
        self.assertNotIn("free: precision", table)
        self.assertIn("--all", table)

    def test_ablations_stand_beside_the_map(self):
        self.good(self.map())
        judge = ("evaluate", "--map", self.output / "map.yaml", "--truth",
                 self.output / "map.yaml", "--readings", self.readings)
        self.assertIn("--ablations", self.good(self.sfw(*judge)).stdout)
        table = self.good(self.sfw(*judge, "--access-points", self.access_points,
                                   "--ablations")).stdout
        head = re.split("  +", table.splitlines()[0].strip())
        self.assertEqual(head, ["this map", "no radio", "shifted radio", "path alone",
                                "what is good"])
        self.assertNotIn("--ablations", table)

    def test_files_are_as_readable_as_the_umask_says(self):
        self.good(self.map())
        mask = os.umask(0)
        os.umask(mask)
        self.assertEqual({path.stat().st_mode & 0o777 for path in self.output.iterdir()},
                         {0o666 & ~mask})


class KVisibility(CommandLine):
    def counts(self):
        """A room that a wall divides, looked at from its left half."""
        row = bytes([0, 254, 254, 0, 254, 254, 0])
        self.write("plan.pgm", b"P5\n7 3\n255\n" + bytes(7) + row + bytes(7))
        plan = self.write("plan.yaml", "image: plan.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n"
                          "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        self.good(self.sfw("visibility", "--plan", plan, "--access-point", "0.75,0.75", "--output",
                           self.output))
        return plan, self.output / "k.pgm"

    def test_counts_walls_and_finds_them_again(self):
        _, counts = self.counts()
        row = counts.read_bytes()[-14:-7]
        self.assertEqual(row, bytes([255, 0, 0, 255, 1, 1, 255]))
        walls = self.folder / "walls"
        self.good(self.sfw("dense", "--k-map", counts, "--output", walls))
        self.assertEqual(sorted(self.bytes_of(walls)), ["map.pgm", "map.png", "map.yaml"])
        self.assertEqual((walls / "map.pgm").read_bytes()[-14:-7],
                         bytes([205, 254, 254, 0, 254, 254, 205]))

    def test_an_access_point_out_of_reach(self):
        plan, _ = self.counts()
        run = self.sfw("visibility", "--plan", plan, "--access-point", "1e9,0", "--output",
                       self.folder / "far")
        self.assertEqual(run.returncode, 1)
        self.assertIn("--access-point 1e9,0 lies outside", run.stderr)
        self.assertFalse((self.folder / "far").exists())


if __name__ == "__main__":
    junit.run()
