#!/usr/bin/env python3
"""Tests the scripts that build and check the package, as far as nothing is built.

Usage: scripts_test.py RESULT.xml
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPTS = ROOT / "scripts"
sys.path.insert(0, str(ROOT / "test" / "support"))

import junit  # noqa: E402

PASSED = '<testcase classname="Ray" name="IsSymmetric"/>'
FAILED = '<testcase classname="Ray" name="Ends"><failure message="one cell short"/></testcase>'
SKIPPED = '<testcase classname="Ray" name="Plans"><skipped message="no floor plans"/></testcase>'
GOOD_LOG = "100% tests passed, 0 tests failed out of 1\n"
TIMEOUT_LOG = "1/1 Test #1: _ctest_package_gtest_grid_tests ...***Timeout 600.00 sec\n"


def run(script, *arguments, environment=None):
    return subprocess.run([str(SCRIPTS / script), *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=environment)


class Summary(unittest.TestCase):
    """test_summary.py, which decides whether scripts/test fails."""

    def summary(self, *cases, log=GOOD_LOG, file="gtest-grid_tests.xml"):
        with tempfile.TemporaryDirectory() as folder:
            results = pathlib.Path(folder, "results")
            results.mkdir()
            (results / file).write_text("<testsuites><testsuite>%s</testsuite></testsuites>" %
                                        "".join(cases))
            log_file = pathlib.Path(folder, "ctest.log")
            log_file.write_text(log)
            return run("test_summary.py", results, log_file)

    def test_counts_and_passes(self):
        done = self.summary(PASSED, SKIPPED)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout.splitlines()[-1], "1 passed, 0 failed, 1 skipped")
        self.assertIn("no floor plans", done.stdout)

    def test_fails_when_a_test_fails(self):
        done = self.summary(PASSED, FAILED, log="50% tests passed, 1 tests failed out of 2\n")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout.splitlines()[-1], "1 passed, 1 failed, 0 skipped")
        self.assertIn("Ray.Ends (one cell short)", done.stdout)

    def test_fails_when_a_test_takes_too_long(self):
        done = self.summary(PASSED, log=TIMEOUT_LOG)
        self.assertEqual(done.returncode, 1)
        self.assertIn("grid_tests (timeout)", done.stdout)

    def test_fails_when_nothing_passed(self):
        self.assertEqual(self.summary(SKIPPED).returncode, 1)

    def test_fails_when_ctest_failed_for_another_reason(self):
        self.assertEqual(self.summary(PASSED, log="No tests were found!!!\n").returncode, 1)


class Packages(unittest.TestCase):
    def test_no_package_is_listed_twice(self):
        names = [line for path in SCRIPTS.glob("debian-packages*.txt")
                 for line in path.read_text().splitlines() if line and not line.startswith("#")]
        self.assertGreater(len(names), 50)
        self.assertEqual(sorted(set(names)), sorted(names))
        for name in names:
            self.assertRegex(name, r"^[a-z0-9][a-z0-9+.-]+$")


class Check(unittest.TestCase):
    def test_names_its_stages_when_one_is_unknown(self):
        done = run("check", "tidiness")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tidiness", done.stdout)
        self.assertIn("coverage", done.stdout)


class WithoutMoveBase(unittest.TestCase):
    def test_scripts_that_need_it_say_so(self):
        # No package lies in an empty folder.
        with tempfile.TemporaryDirectory() as folder:
            for words in (("navigation", "cold"), ("exploration_in_ros", "move_base"),
                          ("exploration_in_ros", "explore_lite")):
                done = run(*words, "plan.yaml", environment=dict(os.environ, HOME=folder,
                                                                 ROS_PACKAGE_PATH=folder))
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertEqual(done.stdout, "skipped: move_base is not in ROS_PACKAGE_PATH\n")


if __name__ == "__main__":
    junit.run()
