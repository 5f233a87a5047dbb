#!/usr/bin/env python3
"""Files as other programs write them: the same drive in other clothes makes the same map.

Usage: file_kinds_test.py RESULT.xml SFW
The cases need ../shared beside the repository; SFW_SHARED names another place. They skip without it.
"""

import hashlib
import json
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import ACCESS_POINTS, FAR, HEADER, NEAR, CommandLine, rows  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CASES = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"), "cases")


def split_rows():
    return [row.split(",") for row in rows()]


class SameDrive(CommandLine):
    """The map of a drive is the same bytes, whatever its file looks like."""

    def setUp(self):
        super().setUp()
        self.good(self.map(output=self.folder / "plain"))
        self.plain = self.bytes_of(self.folder / "plain")

    def is_the_same(self, text, *more):
        run = self.good(self.map(*more, readings=self.write("dressed.csv", text)))
        self.assertNotIn("skipped", run.stderr)
        self.assertEqual(self.bytes_of(self.output)["map.pgm"], self.plain["map.pgm"])
        self.assertEqual(self.bytes_of(self.output)["probability.pgm"],
                         self.plain["probability.pgm"])

    def test_quoted(self):
        names = '"%s"' % '","'.join(HEADER.split(","))
        self.is_the_same("\r\n".join([names] + ['"%s"' % '","'.join(row) for row in split_rows()]))

    def test_a_quoted_comma_beside(self):
        table = ["ssid," + HEADER] + ['"Hotspot 2,4 ""GHz""",' + row for row in rows()]
        self.is_the_same("\n".join(table))

    def test_semicolons_and_decimal_commas(self):
        table = [HEADER.replace(",", ";")] + [";".join(row).replace(".", ",")
                                              for row in split_rows()]
        self.is_the_same("\xef\xbb\xbf".encode("latin1") + "\r\n".join(table).encode())

    def test_tabs_and_network_notation(self):
        table = [HEADER.replace(",", "\t")]
        for row in split_rows():
            row[3] = row[3].replace(":", "")
            row[3] = ".".join((row[3][:4], row[3][4:8], row[3][8:])).upper()
            table.append("\t".join(row))
        self.is_the_same("\n".join(table))

    def test_row_names_of_r(self):
        table = ['"%s"' % '" "'.join(HEADER.split(","))]
        for number, row in enumerate(split_rows(), 1):
            row[3] = '"%s"' % row[3]
            table.append('"%d" %s' % (number, " ".join(row)))
        self.is_the_same("\n".join(table))

    def test_poses_beside(self):
        poses = sorted({(float(row[0]), row[1], row[2]) for row in split_rows()})
        file = self.write("path.csv", "stamp,x,y\n" +
                          "".join("%.3f,%s,%s\n" % pose for pose in poses))
        table = ["stamp,bssid,rssi"] + [",".join((row[0], row[3], row[4])) for row in split_rows()]
        self.is_the_same("\n".join(table), "--path", file)

    def test_wigle_with_poses(self):
        path = self.write("path.csv", "stamp,x,y\n" + "".join(
            "%.1f,%.2f,1\n" % (1000 + 0.5 * i, 0.1 * i) for i in range(120)))
        text = ("WigleWifi-1.6,appRelease=2.78,model=X,\"brand=Moog, LLC\",star=Sol\n"
                "MAC,SSID,AuthMode,FirstSeen,Channel,Frequency,RSSI,CurrentLatitude,"
                "CurrentLongitude,AltitudeMeters,AccuracyMeters,RCOIs,MfgrId,Type\n")
        for i in range(55):
            text += ('%s,"Cafe, 1st",[WPA2],1970-01-01 00:%02d:%02d,6,2437,%d,52.5,13.4,30,8,,,WIFI\n'
                     % (NEAR, (1000 + i) // 60, (1000 + i) % 60, -40 - i // 2))
        readings = self.write("wigle.csv", text)
        self.good(self.map("--path", path, readings=readings))
        report = json.loads((self.output / "report.json").read_text())
        self.assertEqual(report["access_points"][0]["readings"], 55)
        self.assertAlmostEqual(report["path"]["length_m"], 10.8, delta=0.01)

    def test_missing_positions_name_the_option(self):
        readings = self.write("none.csv", "stamp,bssid,rssi\n1,%s,-50\n" % NEAR)
        self.bad(self.map(readings=readings), "line 1: the column 'x' is missing; the file has "
                 "'stamp', 'bssid', 'rssi'", "--path")


class FarFromZero(CommandLine):
    """UTM and national grids: positions far from zero."""

    PLACES = {"national grid": (530000, 180000), "UTM": (691000, 5334000),
              "web Mercator": (-8238000, 4970000), "Gauss-Krueger": (3468000, 5553000)}

    def moved(self, by):
        x0, y0 = by
        table = [HEADER] + ["%s,%.4f,%.4f,%s,%s" % (row[0], float(row[1]) + x0, float(row[2]) + y0,
                                                    row[3], row[4]) for row in split_rows()]
        points = ("access_points:\n  - {bssid: \"%s\", x: %.1f, y: %.1f, name: near}\n"
                  "  - {bssid: \"%s\", x: %.1f, y: %.1f}\n" %
                  (NEAR, x0 + 0.5, y0 + 0.5, FAR, x0 + 7.0, y0 + 1.0))
        return self.write("far.csv", "\n".join(table)), self.write("far.yaml", points)

    def origin(self, folder):
        text = (folder / "map.yaml").read_text()
        line = next(line for line in text.splitlines() if line.startswith("origin"))
        return [float(part) for part in line.split("[")[1].split("]")[0].split(",")]

    def test_is_the_same_map_elsewhere(self):
        self.good(self.map(output=self.folder / "plain"))
        plain = self.bytes_of(self.folder / "plain")
        x, y, _ = self.origin(self.folder / "plain")
        for name, by in self.PLACES.items():
            with self.subTest(name):
                readings, points = self.moved(by)
                run = self.good(self.map(readings=readings, access_points=points))
                note = "the map was made with an offset of (%d, %d) m" % by
                self.assertIn(note, run.stderr)
                far = self.bytes_of(self.output)
                self.assertEqual(far["map.pgm"], plain["map.pgm"])
                self.assertEqual(far["probability.pgm"], plain["probability.pgm"])
                self.assertNotIn("map.bt", far)
                origin = self.origin(self.output)
                self.assertAlmostEqual(origin[0], x + by[0], delta=1e-4)
                self.assertAlmostEqual(origin[1], y + by[1], delta=1e-4)
                report = json.loads(far["report.json"])
                self.assertEqual(report["map"]["offset"], list(by))
                self.assertTrue(any(note in text for text in report["notes"]))
                self.assertAlmostEqual(report["access_points"][1]["x"], by[0] + 7.0, delta=1e-4)

    def test_estimates_and_walls_are_in_the_given_frame(self):
        readings, _ = self.moved(self.PLACES["UTM"])
        points = self.write("noxy.yaml", "access_points: [{bssid: \"%s\"}, {bssid: \"%s\"}]\n" %
                            (NEAR, FAR))
        run = self.good(self.map(readings=readings, access_points=points))
        self.assertIn("is estimated at (69", run.stderr)
        self.assertIn("x 69", (self.output / "walls.svg").read_text().replace('"', " ")
                      .replace("M", "x ").replace("L", "x "))

    def test_is_evaluated_alike(self):
        readings, points = self.moved(self.PLACES["web Mercator"])
        scores = []
        for given, table, output in ((self.readings, self.access_points, self.folder / "near"),
                                     (readings, points, self.output)):
            self.good(self.map(readings=given, access_points=table, output=output))
            run = self.good(self.sfw("evaluate", "--map", output / "map.yaml", "--truth",
                                     output / "map.yaml", "--readings", given, "--access-points",
                                     table, "--json"))
            scores.append(json.loads(run.stdout)["map"])
        self.assertEqual(scores[0], scores[1])

    def test_contacts_lie_in_the_same_frame(self):
        near = self.write("contacts.csv", "stamp,x,y\n5,3,2.5\n6,3.2,2.5\n")
        self.good(self.map("--contacts", near, output=self.folder / "plain"))
        readings, points = self.moved((691000, 5334000))
        far = self.write("far_contacts.csv", "stamp,x,y\n5,691003,5334002.5\n6,691003.2,5334002.5\n")
        self.good(self.map("--contacts", far, readings=readings, access_points=points))
        self.assertEqual(self.bytes_of(self.output)["map.pgm"],
                         self.bytes_of(self.folder / "plain")["map.pgm"])

    def test_names_an_access_point_of_another_frame(self):
        readings, _ = self.moved(self.PLACES["UTM"])
        self.bad(self.map(readings=readings), NEAR, "(0.5, 0.5)", "(691000.0, 5334000.0)",
                 "in one frame")


@unittest.skipUnless(CASES.is_dir(), "%s is missing; SFW_SHARED may name its parent" % CASES)
class Cases(CommandLine):
    def map_case(self, readings, table=CASES / "access_points.yaml"):
        return self.good(self.map(readings=CASES / readings, access_points=table))

    def pgm(self):
        return (self.output / "map.pgm").read_bytes()

    def test_csv(self):
        self.map_case("csv_quoted/readings.csv")
        run = self.map_case("csv_ssid_comma/readings.csv")
        self.assertNotIn("malformed", run.stderr)
        self.assertNotIn("never heard", run.stderr)

    def test_never_heard(self):
        self.assertNotIn("never heard", self.map_case("never_heard/excel.csv").stderr)

    def test_utm(self):
        folder = CASES / "utm"
        for name in ("grid", "uji"):
            for table in (folder / (name + ".yaml"), folder / "noxy.yaml"):
                run = self.map_case(folder / (name + ".csv"), table)
                self.assertIn("the map was made with an offset of", run.stderr)

    def test_maps_of_map_server(self):
        def k_map(plan):
            self.good(self.sfw("visibility", "--plan", CASES / plan, "--access-point", "2,2",
                               "--output", self.output))
            return hashlib.md5((self.output / "k.pgm").read_bytes()).hexdigest()
        self.assertEqual(k_map("yaml_png/m.yaml"), k_map("yaml_png/m_pgm.yaml"))
        self.assertEqual(k_map("free_thresh_025/nav2.yaml"), k_map("free_thresh_025/ros1.yaml"))
        for name in ("full_turn", "noise"):
            self.assertEqual(k_map("yaml_yaw/yaw_%s.yaml" % name), k_map("yaml_png/m_pgm.yaml"))
        half = self.good(self.sfw("visibility", "--plan", CASES / "yaml_yaw/yaw314.yaml",
                                  "--access-point", "-2,-2", "--output", self.output))
        self.assertIn("wrote", half.stderr)
        run = self.sfw("choose-sites", "--plan", CASES / "yaml_yaw/yaw_nan.yaml", "--count", 1)
        self.bad_without_output(run, "yaw_nan.yaml", "write 0 in its place")
        sites = [self.good(self.sfw("choose-sites", "--plan", CASES / "free_thresh_025" / name,
                                    "--count", 2)).stdout for name in ("nav2.yaml", "ros1.yaml")]
        self.assertEqual(sites[0], sites[1])

    def bad_without_output(self, run, *words):
        self.assertEqual(run.returncode, 1)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_plans_on_transparent_ground(self):
        plans = []
        for name in ("plan.png", "plan_white.png"):
            self.good(self.sfw("visibility", "--plan", CASES / "png_transparent" / name,
                               "--metres-per-pixel", 0.05, "--access-point", "2,2", "--output",
                               self.output))
            plans.append((self.output / "k.pgm").read_bytes())
        self.assertEqual(plans[0], plans[1])

    def test_bssid_of_base_60(self):
        table = CASES / "sexagesimal" / "access_points.yaml"
        readings = self.write("own.csv", self.readings.read_text().replace(NEAR,
                                                                           "52:54:00:12:34:56"))
        self.good(self.map(readings=readings, access_points=table))


if __name__ == "__main__":
    junit.run()
