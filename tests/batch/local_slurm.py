# SPDX-License-Identifier: Apache-2.0
"""Slurm on this machine alone, in a temporary folder: munge, controller and nodes run as children and end with the test."""
import os
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo", "scontrol", "squeue", "scancel")
PATIENCE = 1800  # [s] for what will come for sure: bounds a hanging test, judges nothing
ENDED = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY", "BOOT_FAIL", "DEADLINE", "PREEMPTED")  # states


def missing_programs():
    """Daemons are not on every user's PATH."""
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    return [name for name in PROGRAMS if not shutil.which(name)]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def wait_until(true, what):
    end = time.monotonic() + PATIENCE
    while not true():
        if time.monotonic() > end:
            raise TimeoutError(f"in {PATIENCE} s there was no {what}")
        time.sleep(0.5)


class LocalSlurm:
    """`nodes`: names of the nodes, which share the machine and its `cores` (or as many as Slurm is told of)."""

    def __init__(self, nodes=("localhost",), cores=2):
        self.folder, self.daemons, self.nodes = tempfile.mkdtemp(prefix="local_slurm."), [], nodes
        self.watch = subprocess.Popen([sys.executable, os.path.join(HERE, "watch.py"), self.folder], stdin=subprocess.PIPE,
                                      start_new_session=True)  # a signal to the test does not reach it
        os.chmod(self.folder, 0o755)  # munge wants a folder that others can reach
        for name in ("m", "state", "log", *(f"spool.{node}" for node in nodes)):
            os.mkdir(self.path(name), 0o755)
        self.configure(cores // len(nodes))
        try:
            self.start_munge()
            self.start("slurmctld", "-D", "-f", self.path("slurm.conf"))
            for node in nodes:
                self.start("slurmd", "-D", "-f", self.path("slurm.conf"), "-N", node)
            wait_until(self.is_idle, "node that takes jobs")
        except BaseException:
            self.stop()
            raise

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def configure(self, cores):
        ports = free_ports(1 + len(self.nodes))
        lines = [f"NodeName={node} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs={cores} State=UNKNOWN"
                 for node, port in zip(self.nodes, ports[1:])]
        with open(os.path.join(HERE, "slurm.conf"), encoding="utf-8") as stream:
            text = stream.read().replace("@DIR@", self.folder).replace("@CONTROLLER_PORT@", str(ports[0]))
        with open(self.path("slurm.conf"), "w", encoding="utf-8") as stream:
            stream.write(text.replace("@NODES@", "\n".join(lines)))
        os.environ["SLURM_CONF"] = self.path("slurm.conf")

    def start(self, *command):
        words = self.path("log", f"{command[0]}.{len(self.daemons)}.out")
        with open(words, "w", encoding="utf-8") as log:
            daemon = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd=self.folder)
        self.daemons.append((daemon, words))

    def start_munge(self):
        key = self.path("m", "key")
        with open(os.open(key, os.O_CREAT | os.O_WRONLY, 0o400), "wb") as stream:
            stream.write(secrets.token_bytes(1024))
        self.start("munged", "--foreground", f"--key-file={key}", f"--socket={self.path('m', 'munge.sock')}",
                   f"--pid-file={self.path('m', 'pid')}", f"--log-file={self.path('m', 'log')}", f"--seed-file={self.path('m', 'seed')}")
        wait_until(lambda: self.is_up() and os.path.exists(self.path("m", "munge.sock")), "socket of munge")

    def is_up(self):
        """Daemons are children: one that has ended is told with its last words."""
        for daemon, words in self.daemons:
            if daemon.poll() is not None:
                with open(words, encoding="utf-8", errors="replace") as stream:
                    raise RuntimeError(f"{daemon.args[0]} ended with {daemon.returncode}: {stream.read()[-2000:]}")
        return True

    def is_idle(self):
        states = self.ask("sinfo", "--Node", "--noheader", "--format=%T", check=False).split() if self.is_up() else []
        return states == ["idle"] * len(self.nodes)

    def ask(self, *command, check=True):
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
        if check and done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: {done.stderr}")
        return done.stdout

    def jobs(self, number):
        """What Slurm knows of a job, {key: value}; of an array one for each task, in their order."""
        lines = self.ask("scontrol", "--oneliner", "show", "job", str(number)).splitlines()
        found = [dict(word.split("=", 1) for word in line.split() if "=" in word) for line in lines if line.strip()]
        return sorted(found, key=lambda job: job.get("ArrayTaskId", "").zfill(9))

    def has_ended(self, number):
        self.is_up()
        return all(job["JobState"] in ENDED for job in self.jobs(number))

    def wait_for_end(self, number):
        wait_until(lambda: self.has_ended(number), f"end of job {number}")
        return self.jobs(number)

    def stop(self):
        """Jobs first: their processes are no children of ours."""
        if len(self.daemons) == 2 + len(self.nodes):
            self.ask("scancel", "--signal=KILL", "--full", f"--user={os.getuid()}", check=False)
            self.ask("scancel", f"--user={os.getuid()}", check=False)
            wait_until(lambda: not self.ask("squeue", "--noheader", check=False).strip(), "empty queue")
        for daemon, _ in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(60)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        os.environ.pop("SLURM_CONF", None)
        self.watch.communicate()  # ends what is left, and removes the folder
