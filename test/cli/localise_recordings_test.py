#!/usr/bin/env python3
"""Localises one half of each recording on a radio map of the other, as scripts/localisation cuts them.

Usage: localise_recordings_test.py RESULT.xml SFW
Needs ../shared beside the repository; SFW_SHARED names another place. Skips without it.
"""

import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # scripts/ holds no cache
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECORDINGS = pathlib.Path(os.environ.get("SFW_SHARED", ROOT.parent / "shared"),
                          "data", "recordings")


def script():
    """scripts/localisation as a module."""
    loader = importlib.machinery.SourceFileLoader("localisation", str(ROOT / "scripts/localisation"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("localisation", loader))
    loader.exec_module(module)
    return module


@unittest.skipUnless(RECORDINGS.is_dir(), "%s is missing; SFW_SHARED may name the folder of the "
                     "recordings" % RECORDINGS)
class LocaliseRecordings(unittest.TestCase):
    def setUp(self):
        self.output = pathlib.Path(tempfile.mkdtemp(prefix="sfw_localise_"))
        self.addCleanup(shutil.rmtree, self.output)
        self.script = script()
        self.table = self.script.Table(sys.argv[1], self.output)

    def medians(self, name):
        """Median errors of filter, one scan and nearest fingerprints, each half mapped in turn."""
        how = next(row[2] for row in self.script.RECORDINGS if row[1] == name)
        scans = self.script.scans_of(RECORDINGS / (name + ".csv"), name in self.script.SURVEYS)
        first, second = self.script.cut(scans, how)
        for mapped, unknown in ((first, second), (second, first)):
            found = self.table.errors(mapped, unknown)
            medians = [found[key]["median_m"] for key in
                       ("particle_filter", "one_scan", "nearest_fingerprints")]
            print("%-30s filter %.2f, one scan %.2f, nearest fingerprints %.2f" % (name, *medians))
            yield medians

    def test_every_recording_is_better_than_nearest_fingerprints(self):
        for _, name, _, _ in self.script.RECORDINGS:
            for filtered, _, nearest in self.medians(name):
                with self.subTest(name=name):
                    self.assertLess(filtered, nearest)
                    self.assertLess(filtered, 2.5)

    def test_unknown_places_of_radios_gain_most(self):
        for name, least in (("office_robot/readings", 2.5), ("wifine_f4/tour_raw", 1.5)):
            for filtered, _, nearest in self.medians(name):
                with self.subTest(name=name):
                    self.assertGreater(nearest / filtered, least)


if __name__ == "__main__":
    junit.run()
