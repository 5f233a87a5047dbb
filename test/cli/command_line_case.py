"""Files small enough to read, and a test case that runs `sfw` on them: sys.argv[1] names it."""

import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HEADER = "stamp,x,y,bssid,rssi_dbm"
NEAR, FAR, STRANGER = "02:00:00:00:00:01", "02:00:00:00:00:02", "02:00:00:00:00:99"
ACCESS_POINTS = """access_points:
  - {bssid: "%s", x: 0.5, y: 0.5, name: near}
  - {bssid: "%s", x: 7.0, y: 1.0}
""" % (NEAR, FAR)
MAP_FILES = ["costs.png", "costs.yaml", "map.bt", "map.ot", "map.pgm", "map.png", "map.yaml", "probability.pgm",
             "probability.png", "probability.yaml", "report.json", "wall_loss.pgm", "wall_loss.png",
             "wall_loss.yaml", "walls.dxf", "walls.svg", "walls.yaml"]


def rows(bssids=(NEAR, FAR), poses=120):
    """A drive along x = 1..7 m with a wall's loss in its second half."""
    table = []
    for i in range(poses):
        x, y = 1.0 + 0.05 * i, 2.0 + 0.3 * math.sin(0.1 * i)
        for bssid in bssids:
            behind_wall = (i > poses // 2) == (bssid == NEAR)
            table.append("%.3f,%.4f,%.4f,%s,%.1f" % (0.2 * i, x, y, bssid,
                                                    -58.0 if behind_wall else -40.0))
    return table


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw_command_line_"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.output = self.folder / "out"
        self.readings = self.write("readings.csv", "\n".join([HEADER] + rows()) + "\n")
        self.access_points = self.write("access_points.yaml", ACCESS_POINTS)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def sfw(self, *arguments):
        # A home that does not exist: nothing may need one.
        environment = dict(os.environ, HOME=str(self.folder / "no_home"), LC_ALL="C")
        return subprocess.run([sys.argv[1], *map(str, arguments)], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              errors="replace", timeout=60, env=environment)

    def map(self, *more, readings=None, access_points=None, output=None):
        return self.sfw("map", "--readings", readings or self.readings, "--access-points",
                        access_points or self.access_points, "--output", output or self.output,
                        *more)

    def good(self, run):
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def bad(self, run, *words):
        """The run failed with status 1 and said each of the words; nothing was left behind."""
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        for word in words:
            self.assertIn(str(word), run.stderr)
        self.assertNotIn("terminate", run.stderr)
        self.assertFalse(self.output.exists(), "the output directory was made")

    def bytes_of(self, folder):
        return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
