#!/usr/bin/env python3
"""Runs the Slurm recipe of doc/fleet.md on a cluster of one node, this machine.

Usage: slurm_test.py RESULT.xml SFW SOURCE_DIR
Starts munged, slurmctld and slurmd with files and ports of their own, and ends them. Skips itself
if they are not installed (Debian: slurm-wlm, munge) or if the user is not root.
"""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from command_line_case import HEADER, CommandLine, rows  # noqa: E402
from fleet_recipes import contents, recipe  # noqa: E402

PROGRAMS = ("munged", "mungekey", "slurmctld", "slurmd", "sbatch", "scancel", "sinfo", "squeue")
os.environ["PATH"] += ":/usr/sbin:/sbin"
MISSING = [name for name in PROGRAMS if shutil.which(name) is None]
DRIVES = 40
CONFIG = """ClusterName=fleet
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def until(condition, what, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("timed out: " + what())
        time.sleep(0.02)


@unittest.skipIf(MISSING, "Slurm is not installed, as %s is missing" % ", ".join(MISSING))
@unittest.skipIf(os.geteuid() != 0, "a Slurm node needs root")
class Slurm(CommandLine):
    def setUp(self):
        super().setUp()
        self.folder.chmod(0o755)  # munged wants its socket to be open to all
        self.cluster = self.folder / "cluster"
        for name in ("state", "spool"):
            (self.cluster / name).mkdir(parents=True)
        (self.cluster / "slurm.conf").write_text(CONFIG.format(
            host=socket.gethostname().split(".")[0], ports=free_ports(2), folder=self.cluster))
        self.environment = dict(os.environ, SLURM_CONF=str(self.cluster / "slurm.conf"),
                                PATH="%s:%s" % (pathlib.Path(sys.argv[1]).resolve().parent,
                                                os.environ["PATH"]))
        key = self.cluster / "munge.key"
        self.command("mungekey", "--create", "--keyfile", key)
        self.daemon("munged", "--foreground", "--key-file", key, "--socket",
                    self.cluster / "munge.socket", "--pid-file", self.cluster / "munge.pid",
                    "--seed-file", self.cluster / "munge.seed", "--num-threads", 2)
        until((self.cluster / "munge.socket").exists, self.logs)
        self.daemon("slurmctld", "-D", "-c")
        self.daemon("slurmd", "-D")
        until(lambda: "idle" in self.command("sinfo", "--noheader", "--format=%t", check=False),
              self.logs)

    def daemon(self, *command):
        log = open(self.cluster / (command[0] + ".log"), "w")
        self.addCleanup(log.close)
        process = subprocess.Popen([str(word) for word in command], env=self.environment,
                                   stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(process.wait, 60)
        self.addCleanup(process.terminate)

    def logs(self):
        return "\n".join(path.read_text() for path in sorted(self.cluster.glob("*.log")))

    def command(self, *command, check=True):
        run = subprocess.run([str(word) for word in command], env=self.environment,
                             cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, timeout=120)
        if check:
            self.assertEqual(run.returncode, 0, run.stdout + self.logs())
        return run.stdout

    def workers(self):
        """The processes of `sfw map` on this test's list."""
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
                if words[1:2] == [b"map"] and (entry / "cwd").resolve() == self.folder:
                    yield int(entry.name)
            except (OSError, ValueError):
                pass  # it is no process, or it has ended

    def kill_a_worker(self, done):
        """Kills one with SIGKILL once so many maps are done."""
        until(lambda: len(list(self.folder.glob("maps/*/row.json"))) >= done, self.logs)
        os.kill(next(self.workers()), signal.SIGKILL)

    def test_the_recipe_with_killed_workers(self):
        (self.folder / "drives").mkdir()
        for i in range(DRIVES):
            self.write("drives/%d.csv" % i, "\n".join([HEADER] + rows(poses=120 + i)) + "\n")
        self.command("bash", "-e", "-c", recipe(sys.argv[2], "> drives.yaml"))
        self.write("fleet.sbatch", recipe(sys.argv[2], "#SBATCH"))

        job = self.command("sbatch", "--parsable", "fleet.sbatch").strip()
        self.kill_a_worker(3)
        self.command("scancel", job + "_7")  # a worker, or one that waits
        until(lambda: self.command("squeue", "--noheader") == "", self.logs)
        parts = list(self.folder.glob("maps/shard-*.json"))
        self.assertIn(len(parts), (6, 7))
        self.assertNotEqual(self.sfw("merge", "--output", self.folder / "maps").returncode, 0)

        self.command("bash", "-e", "-c", recipe(sys.argv[2], "--parsable"))
        until(lambda: self.command("squeue", "--noheader") == "", self.logs)
        self.assertIn("names %d maps" % DRIVES, (self.folder / "merge.log").read_text())
        self.assertIn("were whole already", "".join(
            path.read_text() for path in self.folder.glob("fleet-*.log")))
        self.good(self.sfw("map", "--list", self.folder / "drives.yaml", "--output", self.output))
        self.assertEqual(contents(self.folder / "maps"), contents(self.output))


if __name__ == "__main__":
    junit.run()
