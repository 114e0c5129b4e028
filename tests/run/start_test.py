#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What is told before the first step: gaps, overlaps and how they are treated, sides badly chosen; and to whom a bar is shown."""
import csv
import itertools
import os
import pty
import re
import subprocess
import unittest

import scenes
from run_test import BRUNT, PATIENCE, Program, RUN, of_all


class Start(Program):
    """Cubes of edge 1, the right one at x = at: apart by at - 1, or overlapping."""

    def check(self, at, rule="error", *options):
        self.write("pair.yaml", scenes.PAIR.replace("AT", str(at)).replace("RULE", rule))
        done = self.brunt("check", "pair.yaml", *options)
        return done.returncode, done.stdout + done.stderr

    def history(self, result, *terms):
        header, *rows = csv.reader(self.text(result, "history.csv").splitlines())
        places = [[name.split(" ")[0] for name in header].index(term) for term in terms]
        return [[float(row[place]) for place in places] for row in rows]

    def test_gap_is_listed(self):
        self.assertIn("smallest gap     0.05 m", self.check(1.05)[1])
        self.assertIn("smallest gap     0 m", self.check(1.0)[1])
        self.assertIn("no two parts are closer", self.check(3)[1])

    def test_extents_are_listed_with_unit_on_any_number_of_ranks(self):
        bodies = """units: UNITS
mesh:
  - {box: {part: bar, size: [1, 2, 3], elements: [4, 5, 6], at: [-1, 0.5, 10], rotate: {axis: [0, 0, 1], degrees: 90}}}
  - {sphere: {part: ball, radius: 2, elements: 3, scale: 0.5, at: [0, 0, -7]}}
materials: {m: {model: elastic, density: 1000, young: 1.0e9, poisson: 0.3}}
parts: {ball: {material: m}, bar: {material: m}}
run: {steps: 1}
"""
        wanted = {"bar": "x -3 .. -1, y 0.5 .. 1.5, z 10 .. 13", "ball": "x -1 .. 1, y -1 .. 1, z -8 .. -6",
                  "all": "x -3 .. 1, y -1 .. 1.5, z -8 .. 13"}
        for units, unit in (("SI", " m"), ("none", "")):
            self.write("bodies.yaml", bodies.replace("UNITS", units))
            for ranks in of_all((1, 2, 3), (1, 3)):
                done = subprocess.run(["mpirun", "-np", str(ranks), BRUNT, "check", "bodies.yaml"], cwd=self.folder, capture_output=True,
                                      text=True, timeout=PATIENCE, check=False)
                told = dict(re.findall(r"^extent           (\w+): (.*)$", done.stdout, re.M))
                self.assertEqual(told, {part: text + unit for part, text in wanted.items()}, done.stderr)
        self.write("one.yaml", scenes.LONG.replace("100000000", "1"))
        self.assertEqual(self.brunt("check", "one.yaml").stdout.count("extent  "), 1)  # all are the one part

    def test_shallow_and_deep_overlap_is_an_error(self):
        for at in (0.99, 0.4, 0.05):  # 0.05: by almost a whole cube
            code, output = self.check(at)
            self.assertEqual(code, 2, output)
            self.assertRegex(output, r"node \d+ of part '(left|right)' lies [\d.]+ m inside part '(left|right)'")
        self.assertIn("lies 0.01 m inside", self.check(0.99)[1])

    def test_overlaps_are_listed_with_unit_whatever_becomes_of_them(self):
        for rule, end in (("error", ""), ("warn", "deepest overlap  0.01 m of"), ("offset", "deepest overlap  0.01 m of"), ("move", "smallest gap     0 m")):
            output = self.check(0.99, rule)[1]
            self.assertRegex(output, r"overlap          node +\d+ of \w+ +0\.01 m inside \w+", rule)
            self.assertIn(end, output)
            self.assertEqual("smallest gap" in output, rule == "move", output)

    def test_overlap_that_is_accepted_is_a_warning(self):
        code, output = self.check(0.99, "warn")
        self.assertEqual(code, 0, output)
        self.assertRegex(output, r"warning: pair\.yaml:\d+: contact\.0: initial overlap: node")

    def run_pair(self, rule, ranks, *arguments):
        self.write("pair.yaml", scenes.PAIR.replace("AT", "0.99").replace("RULE", rule))
        self.run_scene(ranks, "pair.yaml", "--out", f"{rule}{ranks}", "--force", *arguments)
        return self.summary(f"{rule}{ranks}")

    def test_overlaps_are_recovered_moved_or_kept(self):
        parted = self.run_pair("warn", 1, "--set", "run.steps=300")
        self.assertEqual(parted["stopped_by"], "steps")  # no guard takes what recovery gives for an explosion
        self.assertLess(parted["energy"]["contact"], 0)
        self.assertLess(parted["energy"]["error_ratio"], 1e-10)
        for rule in ("move", "offset"):  # nothing to do for contact, so nothing moves
            still = self.run_pair(rule, 1, "--set", "run.steps=300")
            self.assertLess(abs(still["energy"]["kinetic"]), 1e-12 * parted["energy"]["kinetic"])
            self.assertLess(still["max_penetration"], 1e-12)
        self.assertRegex(self.text("move1", "log.txt"), r"initial overlaps: \d+ nodes moved, by 0\.01")
        self.assertRegex(self.text("offset1", "log.txt"), r"initial overlaps: \d+ nodes kept as zero gap, 0.01 m")

    def test_kept_overlaps_of_edges(self):
        """Corners inside each other: nodes behind faces, and edges across edges."""
        for rule in ("warn", "offset"):
            self.write("pair.yaml", scenes.PAIR.replace("AT, 0.1, 0.1", "0.99, 0.99, 0.99").replace("RULE", rule))
            self.run_scene(2, "pair.yaml", "--out", rule, "--set", "run.steps=200")
        self.assertGreater(self.summary("warn")["energy"]["kinetic"], 0)
        self.assertLess(self.summary("offset")["energy"]["kinetic"], 1e-12 * self.summary("warn")["energy"]["kinetic"])
        self.assertLess(self.summary("offset")["max_penetration"], 1e-12)

    def test_a_body_that_overlaps_itself(self):
        self.write("fork.msh", scenes.fork(0.05))
        self.write("fork.yaml", scenes.FORK)
        done = self.brunt("check", "fork.yaml", "--all")
        self.assertEqual(done.returncode, 2)
        self.assertIn("inside part 'fork' (one body, which overlaps itself)", done.stderr)
        listed = re.findall(r"^overlap +node +\d+ of fork +0\.0(?:5|4427) inside fork, ", done.stdout, re.M)
        self.assertEqual(len(listed), 2 * 5 * 3)  # of each arm, from x = 4 to 8; at 4 the slope is nearer
        for rule, ranks in (("warn", 1), ("offset", 1), ("offset", 3)):
            self.run_scene(ranks, "fork.yaml", "--out", f"{rule}{ranks}", "--set", f"contact.0.initial_overlap={rule}")
        parted, kept = self.summary("warn1")["energy"], self.summary("offset1")["energy"]
        self.assertGreater(parted["kinetic"], 0)
        self.assertLess(parted["error_ratio"], 1e-10)
        self.assertLess(kept["kinetic"], 1e-12 * parted["kinetic"])  # zero gap: nothing pushes
        self.assertEqual(self.summary("offset1")["state_hash"], self.summary("offset3")["state_hash"])

    def test_facetted_parts_that_overlap_rest_where_they_are(self):
        """Nodes outside a facetted end count too where detection takes them for inside."""
        self.write("rings.yaml", scenes.RINGS)
        self.write("fork.msh", scenes.bent_ring(0.05))
        self.write("bent.yaml", scenes.FORK.replace("steps: 50", "steps: 1000").replace(
            "between: all", "between: all, initial_overlap: offset"))
        for scene, ranks in itertools.product(("rings", "bent"), (1, 3)):
            self.run_scene(ranks, scene + ".yaml", "--out", f"{scene}{ranks}")
            done = self.summary(f"{scene}{ranks}")
            self.assertEqual(done["stopped_by"], "steps")
            self.assertLess(done["energy"]["kinetic"], 1e-24)  # of a modulus of 100 and volumes of about 1
            self.assertLess(done["max_penetration"], 1e-12)
        for scene in ("rings", "bent"):
            self.assertEqual(self.summary(scene + "1")["state_hash"], self.summary(scene + "3")["state_hash"])

    def test_kept_overlaps_over_ranks_and_a_restart(self):
        push = ("--set", "initial=[{part: right, velocity: [-5, 0, 0]}]")
        one = self.run_pair("offset", 1, *push, "--set", "run.steps=60")
        self.assertLess(one["max_penetration"], 1e-4)  # from the overlap on, which is 0.01
        three = self.run_pair("offset", 3, *push, "--set", "run.steps=60")
        self.assertEqual(three["state_hash"], one["state_hash"])
        self.run_scene(2, "pair.yaml", "--out", "part", *push, "--set", "run.steps=25")
        self.run_scene(1, "pair.yaml", "--out", "part", "--restart", "part", *push, "--set", "run.steps=60")
        self.assertEqual(self.summary("part")["state_hash"], one["state_hash"])

    def test_what_slides_into_its_seat_is_not_pushed_out(self):
        """Frictionless contact gives no energy, though nodes that come to the seat overlap by 0.2 and 0.3 mm."""
        cases = list(itertools.product(scenes.SLIDING_FITS.items(), (("offset", 1e-6), ("move", 3e-3))))
        for (name, scene), (rule, given) in of_all(cases, cases[::3]):
            with self.subTest(scene=name, rule=rule):
                out = f"{name}_{rule}"
                self.write(out + ".yaml", scene.replace("RULE", rule))
                for ranks in (1, 3):
                    self.run_scene(ranks, out + ".yaml", "--out", f"{out}{ranks}")
                energy = self.history(out + "1", "kinetic", "contact")
                self.assertGreater(min(contact for _, contact in energy), -given * energy[0][0])
                self.assertEqual(self.summary(out + "1")["state_hash"], self.summary(out + "3")["state_hash"])
                if rule == "offset":  # zero gap all along the seat: nothing holds it
                    self.assertAlmostEqual(energy[-1][0], energy[0][0], delta=1e-3 * energy[0][0])

    def test_one_line_a_pair_and_the_nodes_in_the_list(self):
        for rule, code in (("error", 2), ("warn", 0)):
            found, output = self.check(0.99, rule, "--all")
            self.assertEqual(found, code)
            # inside the other: 9 x 9 nodes of left less those beside right, 7 x 7 of right
            told = re.findall(r"the deepest of (\d+) overlapping nodes of the two parts", output)
            self.assertEqual(len(told), 1, output)
            listed = re.findall(r"^overlap +node +\d+ of (?:left|right) +0.01 m inside (?:left|right), "
                                r"behind its face \d+-\d+-\d+-\d+, at \[[-\d., e]+\]$", output, re.M)
            self.assertEqual(len(listed), int(told[0]))
            self.assertGreater(len(listed), 7 * 7)
            short = re.findall(r"^overlap +(.*)", self.check(0.99, rule)[1], re.M)
            self.assertEqual(len(short), 11)
            self.assertIn(f"and {len(listed) - 10} more nodes of left and right", short[-1])

    def test_check_lists_what_the_scene_selects(self):
        self.write("rod.yaml", scenes.ROD)
        done = self.brunt("check", "rod.yaml")
        self.assertEqual(done.returncode, 0, done.stderr)
        around, along = 32, 5  # of 6 elements across; 8 (2 x 4)^2 / 4 + 2 rings of 32 cells in the section
        for line in ("mesh             rod: cylinder, elements: 6 across the radius, 32 around, 5 along",
                     "mesh             table: box, elements: 2 x 2 x 1",
                     "set              foot: 9 nodes",
                     "set              head: 145 nodes, 128 faces",
                     f"set of the mesh  rod_side: {around * (along + 1)} nodes, {around * along} faces",
                     "set of the mesh  table_zmin: 9 nodes, 4 faces",
                     "initial          rod: velocity (0, 0, -1) m/s, rotation 2 rad/s about (0, 0, 1), 870 nodes",
                     "fixed            foot: y z, 9 nodes",
                     "symmetry         plane through (-5, 0, 0) with normal (1, 0, 0): 6 nodes",
                     "prescribed       table_xmax: velocity x curve ramp times 3, 6 nodes",
                     "prescribed       rod_top: velocity z 0.5 m/s, 145 nodes",
                     "pressure         head: 1e+06 Pa, curve ramp, 128 faces",
                     "gravity          (0, 0, -9.81) m/s^2",
                     "damping          100 1/s from 0 to 0.001"):
            self.assertIn(line + "\n", done.stdout)
        two = subprocess.run(["mpirun", "-np", "3", BRUNT, "check", "rod.yaml"], cwd=self.folder, capture_output=True,
                             text=True, timeout=PATIENCE, check=True)
        listing = lambda text: [line for line in text.splitlines() if " nodes" in line]
        self.assertEqual(listing(two.stdout), listing(done.stdout))

    def test_check_lists_what_metals_do_and_when_elements_go(self):
        self.write("plate.yaml", """units: SI
mesh: {box: {part: plate, size: [1, 1, 1], elements: [2, 2, 2]}}
materials:
  copper: {model: johnson_cook, density: 8960, young: 1.24e11, poisson: 0.34, A: 9.0e7, B: 2.92e8, n: 0.31, C: 0.025, m: 1.09, melt: 1356,
           room: 294, heat_capacity: 383, damage: {D1: 0.54, D2: 4.89, D3: -3.03}, eos: {model: mie_gruneisen, c: 3940, s: 1.49, gamma: 2}}
parts: {plate: {material: copper, erosion: {damage: 1, pressure: -2.0e9, nodes: drop}}}
run: {end: 1.0e-5}
""")
        done = self.brunt("check", "plate.yaml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for line in ("metal            plate: mie_gruneisen, heats from 294, rates over 1 1/s, fails at damage 1",
                     "erosion          plate: damage 1, pressure -2e+09 Pa, any point; nodes go too"):
            self.assertIn(line + "\n", done.stdout)

    def test_cost_is_measured(self):
        code, output = self.check(1.05)
        self.assertEqual(code, 0)
        self.assertRegex(output, r"estimated cost +\S+ s on 1 rank without output \([1-9]\d* ns per element, step")

    def test_a_coarse_slave_is_told_at_the_start(self):
        self.write("pair.yaml", scenes.PAIR.replace("AT", "1.05").replace("RULE", "error").replace("[8, 8, 8]", "[1, 1, 1]"))
        named = ("--set", "contact.0.between=[left, right]", "--set", "contact.0.slave=left", "--set", "run.steps=2")
        told = (r"warning: (?:pair\.yaml:\d+|--set contact\.0\.slave=left): contact\.0\.slave: part 'left' is the slave of 'right', whose faces are much finer in the "
                r"contact region \(edges of 0\.167 against 1\).*; use slave: right, or passes: two")
        self.assertRegex(self.brunt("check", "pair.yaml", *named).stdout, told)
        for ranks in (1, 3):
            self.run_scene(ranks, "pair.yaml", "--out", f"out{ranks}", *named)
            self.assertRegex(self.text(f"out{ranks}", "log.txt"), told)
            self.assertEqual(self.summary(f"out{ranks}")["warnings"], 1)
        self.run_scene(1, "pair.yaml", "--out", "right", *named, "--set", "contact.0.slave=right")
        self.assertEqual(self.summary("right")["warnings"], 0)

    def said_to(self, file):
        self.write("pair.yaml", scenes.PAIR.replace("AT", "1.05").replace("RULE", "error"))
        steps = ("--set", "run.steps=60", "--force")
        subprocess.run([RUN, "-np", "2", "pair.yaml", "--out", "out", *steps], cwd=self.folder, stdout=file,
                       timeout=PATIENCE, check=True)

    def test_a_progress_bar_is_for_terminals(self):
        with open(os.path.join(self.folder, "job"), "w", encoding="utf-8") as file:
            self.said_to(file)
        self.assertIn("done; results in", self.text("job"))
        self.assertNotIn(" left \r", self.text("job"))  # though mpirun gives the first rank a terminal of its own
        try:
            master, slave = pty.openpty()
        except OSError:
            self.skipTest("this machine has no pseudo-terminals")
        self.addCleanup(os.close, master)
        self.said_to(slave)
        os.close(slave)
        self.assertIn(b" left   \r", os.read(master, 1 << 16))

    def test_a_restart_past_its_end(self):
        self.write("rod.yaml", scenes.ROD)
        self.run_scene(2, "rod.yaml", "--out", "out")
        left = self.summary("out")
        for option, value, phrases in (("run.steps", "9", ["out of range: 9: ", "at step 10", "more than 10", "count"]),
                                       ("run", "{end: 1.0e-5}", ["1e-05 has passed", "is at t = "])):
            done = subprocess.run([RUN, "-np", "2", "rod.yaml", "--out", "out", "--restart", "out", "--set", f"{option}={value}"],
                                  cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE, check=False)
            self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for phrase in ["run.", "checkpoint_", "expected", *phrases]:
                self.assertIn(phrase, done.stderr)
        self.assertEqual(self.summary("out"), left)  # refused before anything was touched
        self.run_scene(1, "rod.yaml", "--out", "out", "--restart", "out")
        self.assertEqual(self.text("out", "log.txt").count("nothing to run"), 1)
        self.assertEqual(self.text("out", "log.txt").count("after its end"), 0)
        self.assertEqual(self.summary("out"), left)  # with the times of the run itself
        os.remove(os.path.join(self.folder, "out", "summary.json"))  # as where the machine went down at the end
        self.run_scene(1, "rod.yaml", "--out", "out", "--restart", "out")
        self.assertEqual(self.summary("out")["state_hash"], left["state_hash"])

    def test_an_empty_path(self):
        self.write("rod.yaml", scenes.ROD)
        for option in ("--out", "--restart"):
            done = subprocess.run([RUN, "-np", "1", "rod.yaml", option, ""], cwd=self.folder, capture_output=True, text=True,
                                  timeout=PATIENCE, check=False)
            self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(option, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "rod.out")))

    def test_tolerances_that_are_none(self):
        for tolerance in ("-1", "abc", "nan", "inf", ""):
            done = subprocess.run([BRUNT, "compare", "a", "b", "--tol", tolerance], cwd=self.folder, capture_output=True, text=True,
                                  timeout=PATIENCE, check=False)
            self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn("--tol", done.stderr)
            self.assertLess(len(done.stderr), 200)

    def test_touching_is_no_overlap(self):
        self.assertEqual(self.check(1.0)[0], 0)
        self.assertEqual(self.check(1 - 1e-9)[0], 0)


if __name__ == "__main__":
    unittest.main()
