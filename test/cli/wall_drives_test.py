#!/usr/bin/env python3
"""Runs `sfw wall-drives`, reads its files, and trains a network of walls for two steps.

Usage: wall_drives_test.py RESULT.xml SFW
The steps of training are skipped without PyTorch.
"""

import ast
import importlib.util
import json
import pathlib
import struct
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402
from command_line_case import CommandLine  # noqa: E402

TRAIN = ROOT / "scripts" / "train_walls.py"
HAS_TORCH = all(map(importlib.util.find_spec, ("numpy", "torch")))


def channels_of(file):
    """The shape of a NumPy file, and one tuple of values for each channel."""
    data = file.read_bytes()
    length, = struct.unpack("<H", data[8:10])
    header = ast.literal_eval(data[10:10 + length].decode())
    count, height, width = header["shape"]
    values = struct.unpack("<%df" % (count * height * width), data[10 + length:])
    cells = height * width
    return header["shape"], [values[i * cells:(i + 1) * cells] for i in range(count)]


class WallDrives(CommandLine):
    def make(self, *arguments, output=None):
        self.good(self.sfw("wall-drives", *arguments, "--output", output or self.output))
        return json.loads(((output or self.output) / "drives.json").read_text())

    def test_each_file_holds_the_rasters_that_the_index_names(self):
        index = self.make("--drives", 3)
        shipped = json.loads((ROOT / "config" / "wall_network.json").read_text())
        self.assertEqual(index["inputs"], shipped["inputs"])
        self.assertLess(set(index["radio_inputs"]), set(index["inputs"]))
        names = index["inputs"] + index["labels"]
        self.assertGreater(len(index["drives"]), 0)
        for drive in index["drives"]:
            shape, channels = channels_of(self.output / drive["file"])
            self.assertEqual(shape[0], len(names))
            raster = dict(zip(names, channels))
            self.assertEqual(set(raster["described"]), {0.0, 1.0})
            for name in index["inputs"]:
                self.assertTrue(all(value == 0.0 for value, described
                                    in zip(raster[name], raster["described"]) if not described), name)
            self.assertTrue(all(free + wall <= 1.0 for free, wall
                                in zip(raster["free"], raster["wall"])))

    def test_workers_do_not_matter(self):
        outputs = [self.folder / name for name in ("one", "three")]
        for output, workers in zip(outputs, (1, 3)):
            self.make("--drives", 3, "--workers", workers, output=output)
        self.assertEqual(*map(self.bytes_of, outputs))

    def test_excluded_plans_are_not_used(self):
        plans, tests = self.folder / "plans", self.folder / "tests"
        for folder in (plans, tests):
            folder.mkdir()
        room = {"verts": [[0, 0], [6, 0], [6, 5], [0, 5]]}
        for name in ("abc_stats.json", "abd_stats.json"):
            (plans / name).write_text(json.dumps(room))
        (tests / "abc.json").write_text(json.dumps(room))
        index = self.make("--drives", 6, "--plan", plans, "--exclude", tests)
        self.assertEqual(index["plans"], 1)
        self.assertLessEqual({drive["plan"] for drive in index["drives"]},
                             {"abd_stats.json", "generated"})

    def test_a_plan_to_exclude_must_exist(self):
        self.bad(self.sfw("wall-drives", "--exclude", self.folder / "tests", "--output", self.output),
                 self.folder / "tests", "--exclude")

    @unittest.skipUnless(HAS_TORCH, "PyTorch is not installed, so no network is trained")
    def test_two_steps_of_training_give_a_network_of_the_same_form(self):
        self.make("--drives", 4)
        network = self.folder / "network.json"
        self.good(subprocess.run([sys.executable, "-B", str(TRAIN), str(self.output), "--steps", "2",
                                  "--output", str(network)], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True, timeout=120))
        trained = json.loads(network.read_text())
        shipped = json.loads((ROOT / "config" / "wall_network.json").read_text())
        self.assertEqual(trained["format"], shipped["format"])
        self.assertEqual(trained["inputs"], shipped["inputs"])
        self.assertEqual(trained["made_by"]["settings"]["steps"], 2)
        self.assertEqual([[len(layer["weights"]), len(layer["bias"]), layer["edge"]]
                          for layer in trained["layers"]],
                         [[len(layer["weights"]), len(layer["bias"]), layer["edge"]]
                          for layer in shipped["layers"]])


if __name__ == "__main__":
    junit.run()
