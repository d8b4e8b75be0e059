# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the scripts of contrib/slurm on a Slurm of one node, which the test configures and starts in
a folder of its own."""

import os
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import guide

DAEMONS = ("slurmctld", "slurmd")
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"
if None in (shutil.which(name, path=PATH) for name in (*DAEMONS, "sbatch", "sinfo")):
    guide.skip("slurm-wlm is not installed")

# Without accounts, other users, control groups and munge.
CONFIGURATION = """ClusterName=balcony
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmctldPort={port}
SlurmdPort={next_port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ReturnToService=2
MailProg=/bin/true
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def two_free_ports():
    """The first of two ports in succession that nobody listens to."""
    for port in range(16817, 17817, 2):
        try:
            for number in (port, port + 1):
                with socket.socket() as probe:
                    probe.bind(("", number))
            return port
        except OSError:
            continue
    return 0


class Cluster:
    """A Slurm of this machine alone. `fault` says why it does not run; empty if it does."""

    def __init__(self, folder):
        self.folder, self.daemons = folder, []
        port = two_free_ports()
        user = subprocess.run(["id", "-un"], capture_output=True, text=True).stdout.strip()
        for name in ("state", "spool"):
            (folder / name).mkdir()
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=user, port=port, next_port=port + 1,
            folder=folder, processors=os.cpu_count()))
        self.environment = dict(os.environ, PATH=PATH, SLURM_CONF=str(configuration))
        for name in DAEMONS:
            self.daemons.append(subprocess.Popen(
                [name, "-D", "-f", str(configuration)], env=self.environment,
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        self.fault = self.wait_until_idle()

    def wait_until_idle(self):
        for _ in range(100):
            time.sleep(0.2)
            for name, daemon in zip(DAEMONS, self.daemons):
                if daemon.poll() is not None:
                    log = self.folder / f"{name}.log"
                    said = log.read_text().splitlines() if log.exists() else []
                    return f"{name} ends: " + (said[-1] if said else "without a word")
            if "idle" in self.run("sinfo", "--noheader", "--format", "%t").stdout:
                return ""
        return "the node does not become idle within 20 s"

    def run(self, *words, cwd=None, **more):
        return subprocess.run(words, cwd=cwd, env=dict(self.environment, **more),
                              capture_output=True, text=True)

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            daemon.wait(timeout=30)


class Slurm(unittest.TestCase):
    SCRIPTS = guide.REPOSITORY / "contrib" / "slurm"
    PICTURE = ("room.obj", "--camera", "c.cam", "--size", "150x70", "--samples", "2",
               "--ambient", "0.5")

    @classmethod
    def setUpClass(cls):
        cls.base = Path(tempfile.mkdtemp(prefix="balcony-slurm-"))
        cls.addClassCleanup(shutil.rmtree, cls.base, ignore_errors=True)
        cls.cluster = Cluster(cls.base)
        cls.addClassCleanup(cls.cluster.stop)
        if cls.cluster.fault:
            raise unittest.SkipTest(f"Slurm does not start here: {cls.cluster.fault}")

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(dir=self.base))
        (self.folder / "room.obj").write_text("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")
        (self.folder / "c.cam").write_text(
            "camera c {\n    axes y_up\n    map u = -1 .. 1, v = square\n"
            "    eye surface(u, v) = [u + t, v, 5]\n    toward surface(u, v) = [u + t, v, 0]\n"
            "    look relative\n}\n")

    def balcony(self, *words):
        done = subprocess.run([guide.BALCONY, *words], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def submit(self, shards, *words):
        """Submits shards and their merge, waits for both and returns what the jobs printed."""
        done = self.cluster.run(self.SCRIPTS / "submit", str(shards), guide.BALCONY, *words,
                                cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for _ in range(300):
            if not self.cluster.run("squeue", "--noheader").stdout.strip():
                return "".join(log.read_text() for log in sorted(self.folder.glob("*.log")))
            time.sleep(0.2)
        self.fail("jobs still run: " + self.cluster.run("squeue").stdout)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_the_tiles_of_a_picture(self):
        self.balcony("render", *self.PICTURE, "-o", "whole.png")
        said = self.submit(3, "render", *self.PICTURE, "-o", "p.png")
        self.assertEqual(self.bytes_of("p.png"), self.bytes_of("whole.png"), said)

    def test_the_frames_of_a_sequence(self):
        words = ("animate", *self.PICTURE, "--frames", "1-4", "-o")
        self.balcony(*words, "whole.##.png")
        said = self.submit(2, *words, "p.##.png")
        for frame in ("01", "02", "03", "04"):
            self.assertEqual(self.bytes_of(f"p.{frame}.png"), self.bytes_of(f"whole.{frame}.png"),
                             said)

    def test_a_shard_that_fails_keeps_the_merge_from_running(self):
        (self.folder / "c.cam").write_text("camera c {}\n")
        said = self.submit(2, "render", *self.PICTURE, "-o", "p.png")
        self.assertIn("error", said)
        self.assertFalse((self.folder / "p.png").exists())




if __name__ == "__main__":
    result = unittest.main(argv=["slurm_test.py"], verbosity=2, exit=False).result
    if result.skipped and not result.failures and not result.errors:
        print(result.skipped[0][1])
        raise SystemExit(guide.SKIPPED)
    raise SystemExit(0 if result.wasSuccessful() else 1)
