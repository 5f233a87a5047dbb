"""A ROS master of its own on a free port, with processes that are gone when it is."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import xmlrpc.client


def wait_until(condition, seconds, what):
    """Polls a condition; TimeoutError names what did not happen in time."""
    deadline = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > deadline:
            raise TimeoutError("%s: not within %g s" % (what, seconds))
        time.sleep(0.05)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class RosSession:
    """Use as a context; `folder` is for files, logs among them, and goes with it."""

    def __init__(self, with_master=True):
        self.with_master = with_master

    def __enter__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sfw_ros_"))
        self.processes = []
        port = free_port()
        self.uri = "http://127.0.0.1:%d" % port
        self.environment = dict(os.environ, ROS_MASTER_URI=self.uri, ROS_IP="127.0.0.1",
                                ROS_HOME=str(self.folder / "ros"),
                                ROS_LOG_DIR=str(self.folder / "log"),
                                HOME=str(self.folder), ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        self.environment.pop("ROS_HOSTNAME", None)
        if self.with_master:
            # Not roscore: nobody needs rosout, and roslaunch finds the master by its port.
            self.start("rosmaster", "rosmaster", "--core", "-p", port)
            wait_until(self.is_up, 20, "the ROS master's start")
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            self.stop(process)
        shutil.rmtree(self.folder, ignore_errors=True)

    def master(self):
        return xmlrpc.client.ServerProxy(self.uri)

    def is_up(self):
        try:
            return self.master().getPid("/test")[0] == 1
        except OSError:
            return False

    def set_parameter(self, name, value):
        self.master().setParam("/test", name, value)

    def start(self, name, *command):
        """Starts a process in a group of its own; its output is text_of(process)."""
        (self.folder / "out").mkdir(exist_ok=True)
        output = self.folder / "out" / ("%s.%d" % (name, len(self.processes)))
        with open(output, "wb") as sink:
            process = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL,
                                       stdout=sink, stderr=subprocess.STDOUT,
                                       env=self.environment, start_new_session=True)
        process.output = output
        self.processes.append(process)
        return process

    @staticmethod
    def text_of(process):
        return process.output.read_text(errors="replace")

    @staticmethod
    def stop(process):
        """Ends a process and its children: asks first."""
        for number, patience in ((signal.SIGINT, 15), (signal.SIGKILL, 5)):
            try:
                os.killpg(process.pid, number)
                process.wait(patience)
            except ProcessLookupError:
                return
            except subprocess.TimeoutExpired:
                continue
        process.wait(5)

    def run(self, *command, seconds=60):
        """Runs a command to its end; returns its output, an AssertionError tells of failure."""
        run = subprocess.run([str(part) for part in command], stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env=self.environment, timeout=seconds)
        if run.returncode != 0:
            raise AssertionError("%s\n%s" % (" ".join(map(str, command)), run.stdout))
        return run.stdout
