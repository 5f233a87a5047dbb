#!/usr/bin/env python3
"""Uses the package as others do: from the devel space and from the install space.

Usage: install_test.py RESULT.xml BUILD INSTALL VERSION
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "test" / "support"), str(ROOT / "test" / "ros")]

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

PACKAGE = "structure_from_wifi"
GENERATED = {"AccessPoint", "AccessPoints", "ApReading", "LiveConfig", "Wall", "Walls", "WifiScan"} | {
    service + part for service in ("SaveMap", "LoadMap", "ClearRegion")
    for part in ("", "Request", "Response")}


def run(*command, environment=None):
    """What a command printed; an AssertionError says why it failed."""
    done = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=environment)
    if done.returncode != 0:
        raise AssertionError("%s\n%s" % (" ".join(map(str, command)), done.stdout))
    return done.stdout


def environment_of(space):
    """What a shell has that read only this space's setup file."""
    bare = {"HOME": os.environ.get("HOME", "/"), "PATH": "/usr/bin:/bin:/usr/sbin:/sbin"}
    text = run("bash", "-c", "source %s/setup.bash && env -0" % space, environment=bare)
    return dict(line.split("=", 1) for line in text.split("\0") if "=" in line)


def remove_installed():
    """In the source tree, roslaunch would find each file of the devel space twice."""
    if BUILD in INSTALL.parents:
        shutil.rmtree(INSTALL, ignore_errors=True)


class Space:
    """The tests of both spaces; `space` is its folder."""

    def setUp(self):
        self.environment = environment_of(self.space)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw_install_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def configure(self):
        run("cmake", "-S", ROOT / "test" / "consumer", "-B", self.folder / "build",
            "-DPYTHON_EXECUTABLE=/usr/bin/python3", "-DCATKIN_ENABLE_TESTING=OFF",
            "-DSFW_PUBLIC_HEADERS=%s" % self.headers, environment=self.environment)

    def build(self, target):
        return run("cmake", "--build", self.folder / "build", "--target", target,
                   environment=self.environment)

    def test_another_package_builds_and_maps(self):
        self.configure()
        self.build("consumer")
        program = self.folder / "build/devel/lib/structure_from_wifi_consumer/consumer"
        # The program finds the library by its own path, without the space's environment.
        self.assertRegex(run(program, self.folder / "map"), r"\b%s: \d+ nodes" % re.escape(VERSION))
        report = json.loads((self.folder / "map" / "report.json").read_text())
        self.assertEqual(report["version"], VERSION)
        self.assertIn(b"P5", (self.folder / "map" / "map.pgm").read_bytes()[:2])


class Devel(Space, unittest.TestCase):
    headers = ROOT / "include" / PACKAGE

    @classmethod
    def setUpClass(cls):
        remove_installed()

    @property
    def space(self):
        return BUILD / "devel"

    def test_roslaunch_finds_each_launch_file_once(self):
        find = "import roslib.packages; print(*roslib.packages.find_resource('%s', '%s'))"
        for file in (ROOT / "launch").iterdir():
            found = run("/usr/bin/python3", "-c", find % (PACKAGE, file.name),
                        environment=self.environment)
            self.assertEqual(found.split(), [str(file)])


class Install(Space, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if BUILD not in INSTALL.parents:
            raise unittest.SkipTest("would install into %s, outside the build tree" % INSTALL)
        remove_installed()
        run("cmake", "--install", BUILD)

    @classmethod
    def tearDownClass(cls):
        remove_installed()

    space = property(lambda self: INSTALL)
    headers = property(lambda self: INSTALL / "include" / PACKAGE)

    def test_holds_what_users_need_and_no_more(self):
        headers = {path.stem for path in self.headers.iterdir()} - GENERATED
        self.assertEqual(headers, {path.stem for path in (ROOT / "include" / PACKAGE).iterdir()})
        libraries = {path.name.split(".")[0] for path in (INSTALL / "lib").glob("lib*")}
        self.assertEqual(libraries, {"libstructure_from_wifi_" + name for name in
                                     ("mapping", "mrpt", "mapping_nodelet", "simulator_nodelet",
                                      "wireless_nodelet", "exploration_nodelet",
                                      "rviz_panel")})
        programs = {path.name for path in (INSTALL / "lib" / PACKAGE).iterdir()}
        self.assertEqual(programs, {"sfw", "mapping_node", "simulator_node",
                                    "wireless_scan_node", "exploration_node"})
        for folder in ("config", "launch", "rviz"):
            shipped = {path.relative_to(ROOT) for path in (ROOT / folder).rglob("*")}
            share = INSTALL / "share" / PACKAGE
            self.assertEqual(shipped, {path.relative_to(share)
                                       for path in (share / folder).rglob("*")})

    def test_compiles_each_public_header_alone(self):
        self.configure()
        self.build("headers")

    def test_the_program_knows_its_version(self):
        self.assertEqual(run(INSTALL / "lib" / PACKAGE / "sfw", "--version").strip(),
                         "sfw " + VERSION)

    def test_works_without_the_source_tree(self):
        for path in INSTALL.rglob("*.*"):
            if path.is_file() and path.suffix != ".pyc":
                for folder in (ROOT / "include", ROOT / "launch", BUILD / "devel"):
                    self.assertNotIn(str(folder).encode(), path.read_bytes(), path)

    def test_launches_a_drive_and_maps_it(self):
        with RosSession() as session:
            session.environment = dict(session.environment, **{
                name: value for name, value in self.environment.items() if name != "HOME"})
            session.environment["ROS_MASTER_URI"] = session.uri
            demo = session.start("demo", "roslaunch", PACKAGE, "demo.launch", "rviz:=false",
                                 "manager:=manager", "time_scale:=20",
                                 "save_directory:=%s" % session.folder)
            manager = session.start("manager", "rosrun", "nodelet", "nodelet", "manager",
                                    "__name:=manager")
            try:
                wait_until(lambda: "success: True" in session.run(
                    "rosservice", "call", "--wait", "/mapping/save_map", "directory: saved"), 60,
                    "the map")
            except (AssertionError, TimeoutError, subprocess.TimeoutExpired) as error:
                raise AssertionError("%s\n%s\n%s" % (error, session.text_of(demo),
                                                     session.text_of(manager)))
            self.assertTrue((session.folder / "saved" / "map.pgm").is_file())


class Symbols(unittest.TestCase):
    """The mapping library exports functions and data of its public headers, and no others."""

    def setUp(self):
        library = BUILD / "devel" / "lib" / "libstructure_from_wifi_mapping.so"
        lines = run("nm", "--dynamic", "--defined-only", "--demangle", library).splitlines()
        self.exported = {match[1] for match in
                         (re.match(r"[0-9a-f]+ [BDRT] sfw::(\w+)", line) for line in lines) if match}
        self.headers = "".join(path.read_text() for path in (ROOT / "include").rglob("*.h"))

    def test_exports_the_public_classes_and_functions(self):
        marked = set(re.findall(r"^class SFW_EXPORT (\w+)", self.headers, re.MULTILINE))
        marked |= set(re.findall(r"^SFW_EXPORT [^;(]*?(\w+)\(", self.headers, re.MULTILINE))
        self.assertGreater(len(marked), 20)
        self.assertEqual(marked - self.exported, {"InputError"})  # all of it is in its header

    def test_marks_each_public_class_and_function(self):
        # A declaration at the start of a line that ends like one, without the mark.
        unmarked = re.findall(r"^(?!SFW_EXPORT|inline|constexpr|template|return|using|void forEach)"
                              r"(?:class \w+ .*\{|[\w:<>]+[\w:<>, *&]* \w+\(.*[;,])$",
                              self.headers, re.MULTILINE)
        self.assertEqual([line for line in unmarked if "class SFW_EXPORT" not in line], [])

    def test_hides_what_is_not_public(self):
        for name in self.exported:
            self.assertRegex(self.headers, r"\b%s\b" % name)


if __name__ == "__main__":
    BUILD, INSTALL, VERSION = pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4]
    junit.run()
