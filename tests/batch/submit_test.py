#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/submit where no Slurm is: the scripts it writes, run by hand, and what it refuses. Needs BRUNT and BRUNT_RUN in the environment."""
import json
import os
import shlex
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = os.path.dirname(os.environ["BRUNT_RUN"])
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import slurm  # noqa: E402

PATIENCE = 600  # [s] for one script
FOLDER = "a folder, 'so' named 100%"  # paths are quoted wherever they stand

SCENE = """\
units: SI
mesh: {box: {part: cube, size: [0.01, 0.01, 0.01], elements: [3, 3, 3]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {cube: {material: steel}}
initial: [{part: cube, velocity: [0, 0, -10]}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]
run: {steps: 20}
"""
STUDY = "scene: scene.yaml\nruns: {short: {run.steps: 5}, 'it''s $long': {run.steps: 9, title: 'a \"b\" $c'}}\ncolumns: [steps]\n"


class Submit(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = os.path.join(self.keeper.name, FOLDER)
        os.mkdir(self.folder)
        self.write("scene.yaml", SCENE)
        self.write("study.yaml", STUDY)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)

    def run_script(self, command, **more):
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE, check=False,
                              env={**os.environ, **more})

    def submit(self, *arguments, **more):
        return self.run_script([os.path.join(SCRIPTS, "submit"), *arguments], **more)

    def script(self, *arguments):
        done = self.submit(*arguments, "--dry-run")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def options(self, text):
        """{key: value} of the lines #SBATCH."""
        lines = [shlex.split(line[len("#SBATCH --"):]) for line in text.splitlines() if line.startswith("#SBATCH --")]
        self.assertTrue(all(len(words) == 1 for words in lines), lines)
        return dict((words[0].split("=", 1) + [""])[:2] for words in lines)

    def assert_runs(self, text, steps, out, **more):
        """The script under bash, as Slurm starts it."""
        self.write("job", text)
        done = self.run_script(["bash", "job"], SLURM_NTASKS="2", SLURM_JOB_ID="1", **more)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        with open(os.path.join(self.folder, out, "summary.json"), encoding="utf-8") as stream:
            found = json.load(stream)
        self.assertEqual((found["steps"], found["ranks"]), (steps, 2))

    def test_one_node(self):
        text = self.script("scene.yaml", "-np", "2", "--time", "3h55m", "--set", "run.steps=7", "--partition", "fast", "--slurm", "mem=4G")
        found = self.options(text)
        expected = {"nodes": "1", "ntasks": "2", "time": "0-03:55:00", "signal": "B:USR2@120", "job-name": "scene", "partition": "fast",
                    "mem": "4G", "output": os.path.join(self.folder, "scene-%j.log").replace("100%", "100%%")}
        self.assertEqual(found, expected)
        self.assert_runs(text, 7, "scene.out")
        self.assertEqual(self.submit("scene.yaml", "-np", "2", "--time", "1").returncode, 2, "results are not replaced")
        self.assert_runs(self.script("scene.yaml", "-np", "2", "--time", "1", "--restart"), 20, "scene.out")

    def test_several_nodes(self):
        found = self.options(self.script("scene.yaml", "-np", "64", "--time", "1-12", "--nodes", "4", "--out", "here"))
        self.assertEqual([found[key] for key in ("nodes", "ntasks", "time", "job-name", "exclusive")], ["4", "64", "1-12:00:00", "here", ""])

    def test_chain(self):
        text = self.script("scene.yaml", "-np", "2", "--time", "90s", "--chain", "--out", "c.out", "--set", "run.steps=7")
        found = self.options(text)
        self.assertEqual([found[key] for key in ("time", "signal", "requeue", "open-mode")], ["0-00:02:00", "B:USR2@30", "", "append"])
        self.assert_runs(text, 7, "c.out")
        longer = self.script("scene.yaml", "-np", "2", "--time", "1", "--chain", "--out", "c.out", "--restart")
        self.assert_runs(longer, 20, "c.out", SLURM_RESTART_COUNT="1")
        self.assert_runs(longer, 20, "c.out")  # nothing is left to run

    def test_chain_begins_anew_where_an_earlier_start_left_no_checkpoint(self):
        text = self.script("scene.yaml", "-np", "2", "--time", "1", "--chain")
        os.mkdir(os.path.join(self.folder, "scene.out"))
        self.write("scene.out/history.csv", "")
        self.assert_runs(text, 20, "scene.out", SLURM_RESTART_COUNT="1")

    def test_array(self):
        text = self.script("study.yaml", "-np", "2", "--time", "1:0")
        self.assertEqual(self.options(text)["array"], "1-2")
        listed = self.run_script([os.path.join(SCRIPTS, "study"), "study.yaml", "--list"])
        self.assertEqual(len(listed.stdout.splitlines()), 2, listed.stderr)
        os.mkdir(os.path.join(self.folder, "study.out"))
        self.write("study.out/runs.txt", listed.stdout)
        self.assert_runs(text, 5, "study.out/short", SLURM_ARRAY_TASK_ID="1")
        table = self.run_script([os.path.join(SCRIPTS, "study"), "study.yaml", "--table"])
        self.assertEqual(table.returncode, 1, table.stderr)
        self.assertIn("| it's $long | no results |", table.stdout)
        self.assert_runs(text, 9, "study.out/it's $long", SLURM_ARRAY_TASK_ID="2")
        with open(os.path.join(self.folder, "study.out", "it's $long", "summary.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["title"], 'a "b" $c')
        self.write("job", text)
        beyond = self.run_script(["bash", "job"], SLURM_NTASKS="2", SLURM_JOB_ID="1", SLURM_ARRAY_TASK_ID="3")
        self.assertEqual(beyond.returncode, 2, beyond.stderr)
        self.assertIn("no line 3", beyond.stderr)

    def test_templates_are_scripts(self):
        for name in sorted(os.listdir(os.path.join(SCRIPTS, "slurm"))):
            if name.endswith((".sbatch", ".sh")):
                done = self.run_script(["bash", "-n", os.path.join(SCRIPTS, "slurm", name)])
                self.assertEqual((done.returncode, done.stderr), (0, ""), name)

    def test_times(self):
        for text, seconds in (("30", 1800), ("1:30", 90), ("4:00:00", 14400), ("1-12", 129600), ("1-12:30", 131400), ("2-0:0:1", 172801),
                              ("45m", 2700), ("3h55m", 14100), ("2d", 172800), ("90s", 90)):
            self.assertEqual(slurm.seconds_of(text), seconds, text)
        self.assertEqual([slurm.time_text(s) for s in (60, 61, 86400, 129600)], ["0-00:01:00", "0-00:02:00", "1-00:00:00", "1-12:00:00"])

    def test_faults_are_one_line(self):
        self.write("rowless.yaml", "scene: scene.yaml\nruns: {}\ncolumns: [steps]\n")
        self.write("runless.yaml", "scene: scene.yaml\ncolumns: [steps]\n")
        self.write("halving.yaml", STUDY + "bisect: {}\n")
        self.write("broken.yaml", "units: [SI\n")
        self.write("empty.yaml", "")
        self.write("README.md", "# A page\n\n- `code`: text\n    and *more*: of it\n")
        self.write("prose.md", "Words alone.\n")
        os.mkdir(os.path.join(self.folder, "there"))
        faults = [("out of range", ["scene.yaml", "-np", "2", "--time", time]) for time in ("0", "0:00", "0h", "59s", "0-0:0")]
        faults += [("invalid --time", ["scene.yaml", "-np", "2", "--time", time]) for time in ("", "soon", "-5", "1:2:3:4", "1.5h", "4h30", "nan", "3:99",
                                                                                                "1:60:00", "1-24", "1-2:60")]
        faults += [(phrase, [*words, "-np", "2", "--time", "5"]) for phrase, words in (
            ("cannot read none.yaml", ["none.yaml"]), ("rowless.yaml: runs: missing", ["rowless.yaml"]),
            ("runless.yaml: runs: missing", ["runless.yaml"]), ("bisect", ["halving.yaml"]), ("invalid YAML", ["broken.yaml"]),
            ("neither scene nor study", ["empty.yaml"]), ("exists", ["scene.yaml", "--out", "there"]),
            ("README.md:3: invalid YAML: found character '`' that cannot start any token; expected a scene or a study", ["README.md"]),
            ("prose.md: invalid file, neither scene nor study", ["prose.md"]), ("invalid number of nodes '0'", ["scene.yaml", "--nodes", "0"]),
            ("invalid --set 'foo'; expected KEY.PATH=VALUE", ["scene.yaml", "--set", "foo"]),
            ("invalid --set '=3'", ["scene.yaml", "--set", "=3"]),
            ("missing checkpoint", ["scene.yaml", "--out", "there", "--restart"]), ("--nodes 3", ["scene.yaml", "--nodes", "3"]),
            ("for a study", ["study.yaml", "--out", "x"]), ("invalid --slurm", ["scene.yaml", "--slurm", "two words"]),
            ("printable characters", ["scene.yaml", "--set", "title=a\nb"]), ("unknown option '--nodse'", ["scene.yaml", "--nodse"]))]
        faults += [("invalid number of ranks '0'", ["scene.yaml", "-np", "0", "--time", "5"]), ("required: -np", ["scene.yaml", "--time", "5"]),
                   ("required: --time", ["scene.yaml", "-np", "2"])]
        for phrase, arguments in faults:
            with self.subTest(arguments=arguments):
                done = self.submit(*arguments, "--dry-run")
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn(phrase, done.stderr)

    def test_without_slurm(self):
        done = self.submit("scene.yaml", "-np", "2", "--time", "5", PATH=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r"^submit: missing Slurm: sbatch and sinfo not found; expected .*\n$")
        self.assertEqual(sorted(os.listdir(self.folder)), ["scene.yaml", "study.yaml"])


if __name__ == "__main__":
    unittest.main()
