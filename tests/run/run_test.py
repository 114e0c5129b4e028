#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The program end to end. Needs BRUNT (the program) and BRUNT_RUN (scripts/run) in the environment.
--long: on every number of ranks, and all of what is run in part without it (of_all)."""
import csv
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import scenes

BRUNT, RUN = os.environ["BRUNT"], os.environ["BRUNT_RUN"]
PATIENCE = 60  # [s] until a run has done what was asked of it


LONG = "--long" in sys.argv
if LONG:
    sys.argv.remove("--long")


def of_all(cases, few):
    """All of them with --long, otherwise those that stand for them."""
    return cases if LONG else few


def number_asked(option, default):
    """`--option N` of the command, which is taken out of it, or the default."""
    if option not in sys.argv:
        return default
    at = sys.argv.index(option)
    _, number = sys.argv[at:at + 2]
    del sys.argv[at:at + 2]
    return int(number)


def variants_asked(default):
    """Of a test with random scenes, how many."""
    return number_asked("--variants", default)


class Program(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = self.keeper.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)

    def run_scene(self, ranks, *arguments, code=0):
        done = subprocess.run([RUN, "-np", str(ranks), *arguments, "--quiet"], cwd=self.folder, capture_output=True,
                              text=True, timeout=4 * PATIENCE)
        self.assertIn(done.returncode, code if isinstance(code, tuple) else (code,), done.stderr + done.stdout)
        return done.stderr

    def brunt(self, *arguments):
        return subprocess.run([BRUNT, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)

    def summary(self, result):
        with open(os.path.join(self.folder, result, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def history(self, result):
        """Rows of history.csv, by the names of the columns without units."""
        lines = list(csv.reader(self.text(result, "history.csv").splitlines()))
        names = [head.split(" ")[0] for head in lines[0]]
        return [dict(zip(names, map(float, line))) for line in lines[1:]]

    def text(self, *path):
        with open(os.path.join(self.folder, *path), encoding="utf-8") as stream:
            return stream.read()

    def wait_for(self, *path):
        end = time.monotonic() + PATIENCE
        while not os.path.exists(os.path.join(self.folder, *path)):
            self.assertLess(time.monotonic(), end, f"no {'/'.join(path)} in time")
            time.sleep(0.05)

    def checkpoints(self, result):
        return [n for n in os.listdir(os.path.join(self.folder, result)) if n.startswith("checkpoint_")]


class Ranks(Program):
    def setUp(self):
        super().setUp()
        self.write("mixed.msh", scenes.mixed_mesh())
        self.write("scene.yaml", scenes.MIXED)

    def test_same_bits_on_any_number_of_ranks(self):
        hashes = {}
        for ranks in (1, 2, 3, 4, 7):
            self.run_scene(ranks, "scene.yaml", "--out", f"r{ranks}")
            found = self.summary(f"r{ranks}")
            self.assertGreater(found["energy"]["contact"], 0, "the bodies never met: the test proves nothing")
            hashes[ranks] = found["state_hash"]
        self.assertEqual(len(set(hashes.values())), 1, hashes)
        self.assertEqual(self.text("r1", "history.csv"), self.text("r7", "history.csv"))
        self.assertEqual(self.brunt("compare", "r1", "r7").returncode, 0)

    def test_restart_on_another_number_of_ranks_continues_bitwise(self):
        self.run_scene(2, "scene.yaml", "--out", "whole")
        self.run_scene(2, "scene.yaml", "--out", "part", "--set", "run.end=0.02")
        self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("whole")["state_hash"])
        self.assertEqual(self.text("part", "history.csv"), self.text("whole", "history.csv"))
        compared = self.brunt("compare", "whole/state.h5", "part/state.h5")
        self.assertEqual(compared.returncode, 0, compared.stdout)

    def test_two_passes_with_friction_on_any_ranks_and_over_a_restart(self):
        for method in ("rate", "kinematic"):
            with self.subTest(method=method):
                self.write("rubber.yaml", scenes.RUBBER.replace("METHOD", method))
                wanted = []
                for ranks in of_all((1, 2, 3, 4), (1, 3)):
                    self.run_scene(ranks, "rubber.yaml", "--out", f"{method}{ranks}")
                    wanted.append(self.summary(f"{method}{ranks}")["state_hash"])
                self.assertEqual(len(set(wanted)), 1)
                self.run_scene(2, "rubber.yaml", "--out", f"{method}_part", "--set", "run.steps=20")
                self.assertGreater(self.summary(f"{method}_part")["contact"]["active"], 0)
                self.run_scene(3, "rubber.yaml", "--out", f"{method}_part", "--restart", f"{method}_part", "--set", "run.steps=60")
                self.assertEqual(self.summary(f"{method}_part")["state_hash"], wanted[0])
                self.run_scene(1, "rubber.yaml", "--out", f"{method}_one", "--set", "contact.0.passes=one")
                self.assertNotEqual(self.summary(f"{method}_one")["state_hash"], wanted[0])

    def test_the_reference_method_ends_on_all_ranks_at_once(self):
        """Each rank took its own accuracy from its own rows: one went on and waited for the others for ever."""
        self.write("unlike.yaml", scenes.UNLIKE_BARS)
        taken = []
        for ranks in of_all((1, 2, 3), (1, 3)):
            self.run_scene(ranks, "unlike.yaml", "--out", f"unlike{ranks}")
            taken.append(self.summary(f"unlike{ranks}")["energy"]["contact"])
        self.assertGreater(taken[0], 0)
        for other in taken[1:]:  # sums of PETSc depend on the ranks in their last bits
            self.assertAlmostEqual(other / taken[0], 1, delta=1e-9)

    def test_ties_across_gaps_on_any_ranks_and_over_a_restart(self):
        self.write("rings.yaml", scenes.TIED_RINGS)
        hashes = []
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "rings.yaml", "--out", f"rings{ranks}")
            hashes.append(self.summary(f"rings{ranks}")["state_hash"])
        self.assertEqual(len(set(hashes)), 1)
        self.assertGreater(self.summary("rings1")["contact"]["active"], 0)
        self.assertLess(self.summary("rings1")["angular_momentum_error"], 1e-13)
        self.run_scene(2, "rings.yaml", "--out", "rings_part", "--set", "run.steps=30")
        self.run_scene(3, "rings.yaml", "--out", "rings_part", "--restart", "rings_part", "--set", "run.steps=80")
        self.assertEqual(self.summary("rings_part")["state_hash"], hashes[0])

    def test_compare_tells_results_apart(self):
        self.run_scene(1, "scene.yaml", "--out", "a", "--set", "run.steps=5")
        self.run_scene(1, "scene.yaml", "--out", "b", "--set", "run.steps=5", "--set", "initial.0.velocity=[0.5,0,-1.001]")
        self.assertEqual(self.brunt("compare", "a", "a").returncode, 0)
        self.assertEqual(self.brunt("compare", "a", "b").returncode, 1)


class Stops(Program):
    def setUp(self):
        super().setUp()
        self.write("long.yaml", scenes.LONG)

    def start(self, ranks=2):
        run = subprocess.Popen([RUN, "-np", str(ranks), "long.yaml", "--out", "out"], cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: run.poll() is None and run.terminate())
        self.addCleanup(run.stderr.close)
        self.wait_for("out", "history.csv")
        time.sleep(0.3)  # the handlers are set before the files are opened; some steps shall have passed
        return run

    def assert_stopped(self, run, by):
        self.assertEqual(run.wait(PATIENCE), 5, run.stderr.read())
        self.assertEqual(self.summary("out")["stopped_by"], by)
        self.assertEqual(self.summary("out")["exit_code"], 5)
        self.assertTrue(self.checkpoints("out"))

    def test_signals_that_stop(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR2):
            with self.subTest(signal=number.name):
                run = self.start()
                run.send_signal(number)
                self.assert_stopped(run, "signal")
                subprocess.run(["rm", "-r", "out"], cwd=self.folder, check=True)

    def test_usr1_checkpoints_and_goes_on(self):
        run = self.start()
        run.send_signal(signal.SIGUSR1)
        end = time.monotonic() + PATIENCE
        while not self.checkpoints("out") and time.monotonic() < end:
            time.sleep(0.05)
        self.assertTrue(self.checkpoints("out"))
        self.assertIsNone(run.poll())
        run.send_signal(signal.SIGTERM)
        self.assert_stopped(run, "signal")

    def test_control_file(self):
        run = self.start(1)
        self.write("out/stop", "")
        self.assert_stopped(run, "control")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out", "stop")))

    def test_wall_limit_and_restart_to_the_end(self):
        self.run_scene(2, "long.yaml", "--out", "out", "--set", "run.wall_limit=1s", code=5)
        stopped = self.summary("out")
        self.assertEqual(stopped["stopped_by"], "wall_limit")
        wanted = stopped["steps"] + 50
        self.run_scene(1, "long.yaml", "--out", "out", "--restart", "out", "--set", f"run.steps={wanted}")
        self.assertEqual(self.summary("out")["steps"], wanted)

    def test_a_moving_wall_brings_energy_and_trips_no_guard(self):
        self.write("wall.yaml", scenes.PUSHED_BY_WALL)
        self.run_scene(2, "wall.yaml", "--out", "out", code=0)
        self.assertLess(self.summary("out")["energy"]["walls"], 0)

    def test_flat_plates_at_rest_stay_at_rest(self):
        self.write("plates.yaml", scenes.FLAT_PLATES_AT_REST)
        self.run_scene(2, "plates.yaml", "--out", "out", code=0)
        self.assertEqual(self.summary("out")["energy"]["kinetic"], 0)
        self.assertEqual(self.summary("out")["max_penetration"], 0)

    def test_guard(self):
        self.write("guard.yaml", scenes.ENERGY_FROM_NOWHERE)
        self.assertIn("stopped", self.run_scene(2, "guard.yaml", "--out", "out", code=3) + self.text("out", "log.txt"))
        self.assertEqual(self.summary("out")["stopped_by"], "guard")

    def test_after_a_guard_the_last_good_state_is_there_to_go_on_from(self):
        self.write("guard.yaml", scenes.INVERTED_LATER)
        self.run_scene(2, "guard.yaml", "--out", "out", code=3)
        failed = self.summary("out")["steps"]
        saved = self.checkpoints("out")
        self.assertEqual(len(saved), 1, saved)
        step = int(saved[0][len("checkpoint_"):-len(".h5")])
        self.assertLess(step, failed)
        self.assertGreater(step, failed - 402)  # 200 steps, or twice where the energy gave it away
        wanted = step + 1  # what the guard watches falls on from there, and would stop it again
        self.run_scene(1, "guard.yaml", "--out", "out", "--restart", "out", "--set", f"run.steps={wanted}",
                       "--set", "output.every=1.0e-9")
        self.assertEqual(self.summary("out")["stopped_by"], "steps")
        self.assertEqual(self.summary("out")["steps"], wanted)

    def assert_stopped_by_a_guard(self, scene):
        """With a clear word, and a state saved from before it that the run goes on from."""
        self.run_scene(1, scene, "--out", "out", "--force", code=3)
        self.assertRegex(self.text("out", "log.txt"), "stopped: (the stable step has decreased|element . .* has no volume left)")
        self.assertEqual(self.summary("out")["stopped_by"], "guard")
        self.assertEqual(self.summary("out")["exit_code"], 3)
        saved = max(int(name[len("checkpoint_"):-len(".h5")]) for name in self.checkpoints("out"))
        self.assertLess(saved, int(re.search(r"step (\d+)", self.text("out", "log.txt").split("stopped:")[1])[1]))
        self.run_scene(1, scene, "--out", "out", "--restart", "out", "--set", f"run.steps={saved + 1}")

    def write_spear(self, law, kind, density, speed):
        scene = scenes.SPEAR.replace("LAW", law).replace("KIND", kind)
        self.write("spear.yaml", scene.replace("DENSITY", str(density)).replace("SPEED", str(speed)))

    def test_an_element_driven_through_itself_stops_the_run(self):
        for law in ("elastic", "neo_hookean"):
            for kind in ("hex8", "hex8_full"):
                with self.subTest(law=law, kind=kind):
                    self.write_spear(law, kind, 800000, 700)
                    self.assert_stopped_by_a_guard("spear.yaml")

    def test_an_element_speared_stops_the_run_or_is_told_to_be_folded(self):
        """At 500 m/s neo-Hooke's law may bear the spear: then corners lie inside out, and the run says so."""
        for law in ("elastic", "neo_hookean"):
            for kind in ("hex8", "hex8_full"):
                with self.subTest(law=law, kind=kind):
                    self.write_spear(law, kind, 80000, 500)
                    done = self.brunt("run", "spear.yaml", "--out", "out", "--force", "--quiet")
                    self.assertIn(done.returncode, (0, 3))
                    self.assertLess(abs(self.summary("out")["energy"]["error_ratio"]), 1e-10)
                    if done.returncode == 0:
                        self.assertGreater(self.summary("out")["folded_elements"], 0)
                        self.assertIn("folded at t =", self.text("out", "log.txt"))

    def test_a_bar_pressed_to_a_twentieth_is_borne_and_one_pressed_to_nothing_stops_the_run(self):
        for law in ("elastic", "neo_hookean"):
            for kind in ("hex8", "hex8_full"):
                with self.subTest(law=law, kind=kind):
                    scene = scenes.PRESSED.replace("LAW", law).replace("KIND", kind)
                    self.write("borne.yaml", scene.replace("END", "9.5e-3"))
                    self.run_scene(1, "borne.yaml", "--out", "out", "--force")
                    self.write("pressed.yaml", scene.replace("END", "1.1e-2"))
                    self.assert_stopped_by_a_guard("pressed.yaml")

    def test_a_checkpoint_newer_than_the_good_state_is_kept(self):
        self.write("guard.yaml", scenes.INVERTED_LATER)
        self.run_scene(1, "guard.yaml", "--out", "out", code=3)
        good = self.checkpoints("out")
        # the same end again, from the good state on: with a checkpoint at each step
        self.run_scene(1, "guard.yaml", "--out", "out", "--restart", "out", "--set", "checkpoint.every=1.0e-9", code=3)
        self.assertNotEqual(self.checkpoints("out"), good)
        steps = sorted(int(name[len("checkpoint_"):-len(".h5")]) for name in self.checkpoints("out"))
        # the guard stops in the pass over the state of the step before: that checkpoint is accepted by nothing
        self.assertGreaterEqual(steps[-1], self.summary("out")["steps"] - 2)

    def test_history_has_some_200_rows_unasked(self):
        self.run_scene(1, "long.yaml", "--out", "out", "--set", "run.steps=1000")
        self.assertEqual(len(self.text("out", "history.csv").splitlines()), 1 + 200 + 1)  # header, rows, the end
        self.run_scene(1, "long.yaml", "--out", "timed", "--set", "run.steps=null", "--set", "run.end=0.04")
        rows = len(self.text("timed", "history.csv").splitlines()) - 1
        self.assertLessEqual(abs(rows - 201), 1)
        self.assertEqual(self.summary("timed")["warnings"], 0)

    def test_an_end_passed_by_far_is_a_warning(self):
        self.run_scene(1, "long.yaml", "--out", "out", "--set", "run.steps=null", "--set", "run.end=1.0e-6")
        self.assertEqual(self.summary("out")["warnings"], 1)
        self.assertRegex(self.text("out", "log.txt"), r"warning: the run ended at t = \S+, \S+ % after its end")

    def test_iterations_that_end_at_their_limit_are_told_once_and_counted(self):
        self.write("rubber.yaml", scenes.RUBBER.replace("METHOD", "rate"))
        self.run_scene(1, "rubber.yaml", "--out", "enough")
        parted = "warning: contact dissipated"  # of the energy: of three elements on four, which is right, and no matter here
        self.assertEqual(self.summary("enough")["warnings"], self.text("enough", "log.txt").count(parted))
        self.assertEqual(self.summary("enough")["contact"]["steps_at_limit"], 0)
        self.assertNotIn("max_iterations", self.text("enough", "log.txt"))
        for passes in ("one", "two"):
            with self.subTest(passes=passes):
                self.run_scene(2, "rubber.yaml", "--out", passes, "--set", "contact.0.max_iterations=3", "--set",
                               f"contact.0.passes={passes}")
                found, log = self.summary(passes), self.text(passes, "log.txt")
                self.assertEqual(found["warnings"], 1 + log.count(parted))
                told = re.findall(r"warning: contact: the iteration of step (\d+) \(t = (\S+)\) ended at max_iterations 3 "
                                  r"with a residual of (\S+), above the tolerance of 0.001", log)
                self.assertEqual(len(told), 1, log)
                self.assertGreater(float(told[0][2]), 1e-3)
                contact = found["contact"]
                self.assertGreater(contact["steps_at_limit"], 1)
                self.assertLessEqual(contact["steps_at_limit"], contact["steps"])
                self.assertIn(f"{contact['steps_at_limit']} of {contact['steps']} steps with contact ended at max_iterations 3",
                              log)

    def test_folded_elements_are_told_once_and_counted(self):
        self.write("ball.yaml", scenes.FAST_BALL)
        found, told = [], []
        for ranks in (1, 3):
            self.run_scene(ranks, "ball.yaml", "--out", f"on{ranks}")
            found.append(self.summary(f"on{ranks}"))
            told.append(re.findall(r"warning: (\d+) hex8 elements? (?:is|are) folded at t = (\S+), .* worst is element (\d+) "
                                   r"\(position in the input\) of part 'ball'", self.text(f"on{ranks}", "log.txt")))
            self.assertEqual(found[-1]["warnings"], 1 + self.deep(f"on{ranks}"))
        self.assertEqual(len(told[0]), 1)
        self.assertEqual(told[0], told[1])
        self.assertGreaterEqual(found[0]["folded_elements"], int(told[0][0][0]))
        for same in ("folded_elements", "state_hash"):
            self.assertEqual(found[0][same], found[1][same])
        for number, remedy in enumerate(("hourglass.kind=elastic", "element=hex8_full")):
            self.run_scene(1, "ball.yaml", "--out", str(number), "--set", f"parts.plate.{remedy}", "--set",
                           f"parts.ball.{remedy}")
            self.assertEqual(self.summary(str(number))["folded_elements"], 0, remedy)
            self.assertNotIn("folded", self.text(str(number), "log.txt"), remedy)
            # springs that stay take a tenth of the internal energy and more here; full integration has none
            energy = self.summary(str(number))["energy"]  # internal energy only grows in this impact
            much = energy["hourglass"] > 0.1 * energy["internal"]
            self.assertEqual(much, remedy == "hourglass.kind=elastic", remedy)
            self.assertEqual(self.text(str(number), "log.txt").count("hourglass energy is"), int(much), remedy)
            self.assertEqual(self.summary(str(number))["warnings"], int(much) + self.deep(str(number)), remedy)

    def deep(self, result):
        """Warnings of the look at positions: where elements are coarse or fold, nodes and edges may lie in other bodies."""
        return len(re.findall(r"warning: .* deep in part ", self.text(result, "log.txt")))

    def test_results_are_not_overwritten_unasked(self):
        self.run_scene(1, "long.yaml", "--out", "out", "--set", "run.steps=3")
        self.assertIn("--force", self.run_scene(2, "long.yaml", "--out", "out", "--set", "run.steps=3", code=2))
        self.run_scene(1, "long.yaml", "--out", "out", "--set", "run.steps=4", "--force")
        self.assertEqual(self.summary("out")["steps"], 4)
        self.run_scene(1, "long.yaml", "--out", "other", "--set", "run.steps=5")
        before = self.text("other", "history.csv")
        told = self.run_scene(1, "long.yaml", "--out", "other", "--restart", "out", code=2)  # not its own run
        self.assertIn("other: invalid result folder: it contains results", told)
        self.assertEqual(self.text("other", "history.csv"), before)

    def test_a_folder_belongs_to_one_run_at_a_time(self):
        run = self.start()
        self.wait_for("out", "log.txt")
        told = self.run_scene(1, "--set", "run.steps=3", "long.yaml", "--out", "out", "--force", code=2)
        self.assertIn("another run writes into it", told)
        run.send_signal(signal.SIGTERM)
        self.assert_stopped(run, "signal")


if __name__ == "__main__":
    unittest.main()
