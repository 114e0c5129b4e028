#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Jobs of scripts/submit on a Slurm that runs on this machine alone: one that completes, one that needs several time limits, one that
is cancelled, an array; one on two nodes, which are this machine twice. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment; exit code 77 (skipped) without Slurm, which
scripts/setup --slurm installs, or without root, as whom the configuration starts it."""
import csv
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

from local_slurm import PATIENCE, LocalSlurm, missing_programs, wait_until

RUN = os.environ["BRUNT_RUN"]
SCRIPTS = os.path.dirname(RUN)
SKIPPED = 77

# Two blocks of steel, pressed onto each other and a wall, with friction: contact in nearly all steps.
SCENE = """\
title: a block on another
units: SI
mesh:
  - {box: {part: low, size: [0.01, 0.01, 0.01], elements: [4, 4, 4]}}
  - {box: {part: top, size: [0.01, 0.01, 0.01], elements: [5, 5, 5], at: [0.001, 0.002, 0.01001]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {low: {material: steel}, top: {material: steel}}
gravity: {vector: [0, 0, -1.0e5]}
initial: [{part: top, velocity: [0.5, 0, -5]}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]
contact: [{between: all, friction: 0.3}]
run: {steps: 60}
"""
STUDY = """\
scene: scene.yaml
runs:
  short: {run.steps: 20}
  rough: {run.steps: 30, contact.0.friction: 0.6}
  'fast, and named oddly': {run.steps: 40, initial.0.velocity: [0.5, 0, -9]}
columns: [steps, state_hash]
"""
ENDLESS = 10 ** 8  # steps of a run that only a request ends
os.environ["OMPI_MCA_mpi_yield_when_idle"] = "1"  # two nodes share the cores of one
for chosen in ("OMPI_MCA_pml", "OMPI_MCA_btl"):  # by ctest, for one node: scripts/run chooses
    os.environ.pop(chosen, None)
HOLD = 5  # [s] a credential made in the second in which the job's last one was revoked counts as revoked too


class Jobs(unittest.TestCase):
    """What the tests share."""
    nodes = ("localhost",)

    @classmethod
    def setUpClass(cls):
        cls.slurm = LocalSlurm(cls.nodes)
        cls.addClassCleanup(cls.slurm.stop)

    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = self.keeper.name
        for name, text in (("scene.yaml", SCENE), ("study.yaml", STUDY)):
            with open(self.path(name), "w", encoding="utf-8") as stream:
                stream.write(text)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def script(self, name, *arguments, code=0):
        done = subprocess.run([os.path.join(SCRIPTS, name), *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done.stdout + done.stderr

    def submit(self, *arguments):
        """The number of the job."""
        told = self.script("submit", *arguments)
        self.tell(told.strip())
        return re.match(r"job (\d+); ", told)[1]

    def tell(self, what):
        print(f"  {self._testMethodName}: {what.replace(self.folder + '/', '')}", flush=True)

    def tell_job(self, job):
        name = f"{job['ArrayJobId']}_{job['ArrayTaskId']}" if "ArrayJobId" in job else job["JobId"]
        self.tell(f"job {name}: " + ", ".join(f"{key} {job[key]}" for key in ("JobState", "ExitCode", "Restarts", "RunTime")))

    def assert_ended(self, job, state, restarts=0):
        self.tell_job(job)
        if state == "COMPLETED":
            self.assertEqual(job["ExitCode"], "0:0", self.log())
        self.assertEqual((job["JobState"], job["Restarts"]), (state, str(restarts)), self.log())

    def log(self):
        """What the jobs have printed, and Slurm's own logs."""
        texts = []
        for path in sorted(glob.glob(self.path("**", "*.log"), recursive=True)) + glob.glob(self.slurm.path("log", "slurm*.log")):
            with open(path, encoding="utf-8") as stream:
                texts.append(f"{path}:\n{stream.read()}")
        return "\n".join(texts)

    def summary(self, out):
        with open(self.path(out, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def hash_of(self, *options):
        """The state after a run without Slurm that nothing breaks."""
        self.script("run", "-np", "2", "scene.yaml", "--out", "unbroken", "--quiet", "--force", *options)
        return self.summary("unbroken")["state_hash"]

    def assert_same(self, out, unbroken):
        found = self.summary(out)
        self.tell(f"{out}: {found['steps']} steps on {found['ranks']} ranks, state_hash {found['state_hash']}; unbroken {unbroken}")
        self.assertEqual(found["state_hash"], unbroken)


class OneNode(Jobs):
    def test_one_completes(self):
        job = self.submit("scene.yaml", "-np", "2", "--time", "10")
        self.assert_ended(self.slurm.wait_for_end(job)[0], "COMPLETED")
        self.assertEqual(self.summary("scene.out")["ranks"], 2)
        self.assert_same("scene.out", self.hash_of())

    def next_turn(self, job, turns):
        """Slurm holds a requeued job back for two minutes, once a turn it is told that seconds are enough. True when the job has ended."""
        now = self.slurm.jobs(job)[0]
        if now["JobState"] == "PENDING" and now["Reason"] == "BeginTime" and now["Restarts"] not in turns:
            turns.add(now["Restarts"])
            self.slurm.ask("scontrol", "update", f"JobId={job}", f"StartTime=now+{HOLD}")
        return self.slurm.has_ended(job)

    def chain(self, steps):
        """The job of a chain that has ended."""
        job = self.submit("scene.yaml", "-np", "2", "--time", "1", "--chain", "--out", f"chain_{steps}.out", "--set", f"run.steps={steps}")
        turns = set()
        wait_until(lambda: self.next_turn(job, turns), f"end of chain {job}")
        return self.slurm.jobs(job)[0]

    def test_one_needs_several_time_limits(self):
        steps = 1000
        ended = self.chain(steps)
        while ended["JobState"] == "COMPLETED" and ended["Restarts"] == "0":  # until the run is longer than the limit, on any machine
            steps *= 2
            ended = self.chain(steps)
        self.assert_ended(ended, "COMPLETED", ended["Restarts"])
        self.assertNotEqual(ended["Restarts"], "0")
        stops = re.findall(rf"^chain: stopped before the time limit at checkpoint_0*(\d+)\.h5; job {ended['JobId']} ", self.log(), re.M)
        self.tell(f"stopped at steps {', '.join(stops)}")
        self.assertEqual(len(stops), int(ended["Restarts"]))
        self.assertEqual(sorted(set(map(int, stops))), list(map(int, stops)), "each turn goes further")
        self.assertLess(int(stops[-1]), steps)
        self.assert_same(f"chain_{steps}.out", self.hash_of("--set", f"run.steps={steps}"))

    def history_rows(self, out):
        try:
            with open(self.path(out, "history.csv"), encoding="utf-8") as stream:
                return len(list(csv.reader(stream))) - 1
        except OSError:
            return 0

    def test_one_is_cancelled(self):
        for chain in ([], ["--chain"]):
            with self.subTest(chain=chain):
                out = f"cancelled_{len(chain)}.out"
                job = self.submit("scene.yaml", "-np", "2", "--time", "10", "--out", out, "--set", f"run.steps={ENDLESS}", "--set",
                                  "history.every=1.0e-6", "--set", "run.wall_limit=20m", *chain)
                wait_until(lambda: self.history_rows(out) > 3 or self.slurm.has_ended(job), "history")
                self.slurm.ask("scancel", job)
                self.assert_ended(self.slurm.wait_for_end(job)[0], "CANCELLED")
                self.assert_goes_on(out)

    def assert_goes_on(self, out):
        """The checkpoint is whole: what follows from it is the run that was never stopped."""
        found = glob.glob(self.path(out, "checkpoint_*.h5"))
        self.assertTrue(found, self.log())
        steps = int(re.search(r"_(\d+)\.h5$", max(found))[1])
        self.tell(f"{out}: checkpoint at step {steps}")
        self.assertGreater(steps, 0)
        options = ["--set", f"run.steps={steps + 20}", "--set", "history.every=1.0e-6"]
        self.script("run", "-np", "1", "scene.yaml", "--out", out, "--restart", out, "--quiet", *options)
        self.assert_same(out, self.hash_of(*options))

    def test_array_of_three(self):
        job = self.submit("study.yaml", "-np", "2", "--time", "10")
        ended = self.slurm.wait_for_end(job)
        self.assertEqual([one["ArrayTaskId"] for one in ended], ["1", "2", "3"])
        for one in ended:
            self.assert_ended(one, "COMPLETED")
        self.tell("\n" + self.script("study", "study.yaml", "--table"))
        with open(self.path("study.out", "table.csv"), encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([row["steps"] for row in rows], ["20", "30", "40"])
        self.script("study", "study.yaml", "-np", "1")  # the same without Slurm
        with open(self.path("study.out", "table.csv"), encoding="utf-8") as stream:
            self.assertEqual(list(csv.DictReader(stream)), rows)

    def test_what_could_never_start_is_refused(self):
        for phrase, options in (("unknown --partition 'none'; expected one of debug", ["-np", "2", "--time", "5", "--partition", "none"]),
                                ("expected at most 10:00, the limit of partition debug", ["-np", "2", "--time", "11"]),
                                ("not available", ["-np", "200", "--time", "5"]),
                                ("unrecognized option '--nonsense", ["-np", "2", "--time", "5", "--slurm", "nonsense=1"])):
            with self.subTest(options=options):
                told = self.script("submit", "scene.yaml", *options, code=2)
                self.tell(told.strip())
                self.assertIn(phrase, told)
                self.assertEqual(len(told.splitlines()), 1, told)
        self.assertEqual(sorted(os.listdir(self.folder)), ["scene.yaml", "study.yaml"], "nothing is left behind")


class TwoNodes(Jobs):
    nodes = ("n1", "n2")

    def test_ranks_on_two_nodes(self):
        job = self.submit("scene.yaml", "-np", "2", "--nodes", "2", "--time", "10", "--set", "run.steps=20")
        ended = self.slurm.wait_for_end(job)[0]
        self.assert_ended(ended, "COMPLETED")
        self.assertEqual(ended["NodeList"], "n[1-2]")
        for node in self.nodes:  # mpirun started its half of the ranks through srun
            with open(self.slurm.path("log", f"slurmd.{node}.log"), encoding="utf-8") as stream:
                self.assertIn(f"launch task StepId={job}.0", stream.read())
        self.assert_same("scene.out", self.hash_of("--set", "run.steps=20"))


if __name__ == "__main__":
    lacking = missing_programs()
    if lacking or os.getuid() != 0:
        print(f"skipped: {'not found: ' + ', '.join(lacking) + ' (scripts/setup --slurm)' if lacking else 'not root'}")
        sys.exit(SKIPPED)
    unittest.main()
