#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rigid parts as a user runs them: free, loaded, held, driven, joined to deformable parts; balances, exact motions, the same bits on any
number of ranks and after a restart, messages. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import math
import unittest

from run_test import Program, of_all


def joined_mesh(rigid=6, soft=4):
    """Gmsh 2.2: block head (x from 0), block bar behind it, which share the nodes between; surface tip at the bar's end."""
    nx, n = rigid + soft, 3
    nodes = [(i / 10, j / 10, k / 10) for k in range(n + 1) for j in range(n + 1) for i in range(nx + 1)]

    def node(i, j, k):
        return 1 + i + (nx + 1) * (j + (n + 1) * k)

    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '3 1 "head"', '3 2 "bar"', '2 3 "tip"',
             "$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements"]
    elements = []
    for k in range(n):
        for j in range(n):
            for i in range(nx):
                base = [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]
                elements.append((5, 1 if i < rigid else 2, base + [c + (nx + 1) * (n + 1) for c in base]))
            elements.append((3, 3, [node(0, j, k), node(0, j, k + 1), node(0, j + 1, k + 1), node(0, j + 1, k)]))
    lines += [str(len(elements))]
    lines += [f"{i} {kind} 2 {b} {b} " + " ".join(map(str, e)) for i, (kind, b, e) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


JOINED = """\
units: none
mesh: {file: joined.msh}
materials:
  hard: {model: rigid, density: 3000}
  soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}
parts: {head: {material: hard}, bar: {material: soft, element: hex8_full, bulk: {linear: 0, quadratic: 0}}}
initial:
  - {part: bar, velocity: [0, 0, 0], rotation: {axis: [0.3, 1, 0.5], rate: 20}}
  - {part: head, velocity: [0, 0, 0], rotation: {axis: [0.3, 1, 0.5], rate: 20}}
curves: {pulse: [[0, 0], [0.01, 1], [0.02, 0]]}
pressure: [{set: tip, value: 2.0e3, curve: pulse}]
gravity: {vector: [0, 3, -9.81]}
damping: {alpha: 2, from: 0.02, to: 0.03}
probes:
  - {name: turn, part: head, field: rotation}
  - {name: push, part: head, field: force}
  - {name: twist, part: head, field: moment}
  - {name: head, part: head, field: energy}
  - {name: bar, part: bar, field: energy}
  - {name: p, part: head, field: momentum}
  - {name: q, part: bar, field: momentum}
run: {end: 0.05}
history: {every: 1.0e-3}
"""

# A hammer of two rigid parts that lie in each other, of different density, falls on its side on a rubber block.
HAMMER = """\
units: none
mesh:
  - {box: {part: block, size: [1, 1, 0.4], elements: [4, 4, 2]}}
  - {box: {part: handle, size: [0.8, 0.1, 0.1], elements: [8, 1, 1], at: [0.1, 0.4, 0.55]}}
  - {box: {part: iron, size: [0.2, 0.5, 0.3], elements: [2, 5, 3], at: [0.75, 0.2, 0.45]}}
materials:
  wood: {model: rigid, density: 500}
  steel: {model: rigid, density: 5000}
  soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}
parts: {block: {material: soft}, handle: {material: wood, rigid: {joins: iron}}, iron: {material: steel}}
initial: [{part: iron, velocity: [0, 0, -3], rotation: {axis: [0, 1, 0], rate: 2}}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]
contact: [{between: all, friction: 0.3}]
probes: [{name: turn, part: iron, field: rotation}, {name: m, part: iron, field: mass}, {name: on, contact: [iron, block]}]
run: {end: 0.06}
history: {every: 1.0e-3}
"""

# An axle along z, off every axis of symmetry: a bar of three unequal edges.
ALONE = """\
units: none
mesh: {box: {part: tool, size: [0.6, 0.4, 0.2], elements: [6, 4, 2], at: [1, 2, 3], rotate: {axis: [1, 1, 0], degrees: 30}}}
materials: {hard: {model: rigid, density: 1000}}
parts: {tool: {material: hard}}
run: {end: 0.5, step: 1.0e-3}
history: {every: 1.0e-2}
"""


class Rigid(Program):
    def setUp(self):
        super().setUp()
        self.write("joined.msh", joined_mesh())
        self.write("joined.yaml", JOINED)

    def rows(self, result):
        lines = self.text(result, "history.csv").splitlines()
        lines[0] = ",".join(head.split("[")[0].strip() for head in lines[0].split(","))
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]

    def run_alone(self, more, *options):
        self.write("alone.yaml", ALONE + more)
        self.run_scene(1, "alone.yaml", "--out", "alone", "--force", *options)
        rows = self.rows("alone")
        self.assertLess(self.summary("alone")["energy"]["error_ratio"], 1e-12)
        self.assertLess(self.summary("alone")["momentum_error"], 1e-12)
        return rows

    def test_joined_to_a_deformable_part_it_balances_with_the_same_bits_on_any_number_of_ranks(self):
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "joined.yaml", "--out", f"out{ranks}")
        first = self.summary("out1")
        self.assertEqual(first["rigid_bodies"], 1)
        self.assertLess(first["energy"]["error_ratio"], 1e-12)
        self.assertLess(first["momentum_error"], 1e-12)
        for ranks in of_all((2, 3, 4), (3,)):
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
        last = self.rows("out1")[-1]
        self.assertGreater(last["kinetic"], 0)
        self.assertAlmostEqual(last["head.kinetic"] + last["bar.kinetic"], last["kinetic"], delta=2e-3 * last["kinetic"])
        for c in "xyz":
            self.assertAlmostEqual(last[f"p.{c}"] + last[f"q.{c}"], last[f"momentum_{c}"], delta=1e-2)

    def test_restart_from_two_ranks_on_three(self):
        self.run_scene(1, "joined.yaml", "--out", "whole")
        self.run_scene(2, "joined.yaml", "--out", "half", "--set", "run.end=0.025")
        self.run_scene(3, "joined.yaml", "--out", "half", "--restart", "half")
        self.assertEqual(self.summary("half")["state_hash"], self.summary("whole")["state_hash"])

    def test_two_halves_that_are_joined_move_as_one_block(self):
        more = ("initial: [{part: tool, velocity: [1, 0, 2], rotation: {axis: [1, 2, 3], point: [1, 2, 3], rate: 9}}]\n"
                "probes: [{name: r, part: tool, field: rotation}, {name: u, part: tool, field: displacement},\n"
                "  {name: l, part: tool, field: angular_momentum}, {name: e, part: tool, field: energy}, {name: m, part: tool, field: mass}]\n")
        whole = self.run_alone(more)
        half = "{box: {part: %s, size: [0.3, 0.4, 0.2], elements: [3, 4, 2], at: [%s], rotate: {axis: [1, 1, 0], degrees: 30}}}"
        # the second half begins 0.3 along the turned x axis
        cos, sin = math.cos(math.radians(30)), math.sin(math.radians(30))
        along = [0.3 * (1 + cos) / 2, 0.3 * (1 - cos) / 2, -0.3 * sin / math.sqrt(2)]
        at = ", ".join(repr(a + b) for a, b in zip((1, 2, 3), along))
        mesh = ALONE.splitlines()[1]
        text = ALONE.replace(mesh, f"mesh: [{half % ('tool', '1, 2, 3')}, {half % ('end', at)}]").replace(
            "parts: {", "parts: {end: {material: hard, rigid: {joins: tool}}, ") + more + "contact: [{between: all}]\n"
        self.write("halves.yaml", text)
        self.run_scene(1, "halves.yaml", "--out", "halves")
        self.assertEqual(self.summary("halves")["rigid_bodies"], 1)
        self.assertEqual(self.summary("halves")["contact"]["pairs"], 0)
        for one, two in zip(whole, self.rows("halves")):
            for key in one:
                if key.startswith(("r.", "u.", "l.", "e.", "m.")) and "impulse" not in key:
                    self.assertAlmostEqual(one[key], two[key], delta=1e-11 * max(1, abs(one[key])), msg=key)

    def test_parts_that_share_nodes_are_one_body_where_they_join(self):
        text = (JOINED.replace("soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}", "soft: {model: rigid, density: 1000}")
                .replace("element: hex8_full, bulk: {linear: 0, quadratic: 0}", "rigid: {joins: head}").replace("run: {", "run: {step: 1.0e-4, "))
        lines = [line for line in text.splitlines() if "part: bar" not in line]
        self.write("one.yaml", "\n".join(lines + [""]))
        self.run_scene(2, "one.yaml", "--out", "one")
        self.assertLess(self.summary("one")["energy"]["error_ratio"], 1e-12)
        self.assertAlmostEqual(self.rows("one")[-1]["mass"], 0.09 * (0.6 * 3000 + 0.4 * 1000), delta=1e-9)

    def test_a_body_of_two_parts_in_contact_has_the_same_bits_on_any_ranks_and_over_a_restart(self):
        self.write("hammer.yaml", HAMMER)
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "hammer.yaml", "--out", f"out{ranks}")
        first, last = self.summary("out1"), self.rows("out1")[-1]
        self.assertEqual(first["rigid_bodies"], 1)
        self.assertLess(first["energy"]["error_ratio"], 1e-12)
        self.assertLess(first["momentum_error"], 1e-12)
        self.assertGreater(abs(last["impulse_on.z"]), 1)
        self.assertAlmostEqual(last["m.mass"], 0.008 * 500 + 0.03 * 5000, delta=1e-10)  # the common volume counts twice
        for ranks in of_all((2, 3, 4), (3,)):
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
        self.run_scene(2, "hammer.yaml", "--out", "half", "--set", "run.end=0.03")
        self.run_scene(3, "hammer.yaml", "--out", "half", "--restart", "half")
        self.assertEqual(self.summary("half")["state_hash"], first["state_hash"])

    def test_weight_and_a_dead_load_move_the_centre(self):
        rows = self.run_alone("gravity: {vector: [0, 0, -10]}\nforces: [{part: tool, force: [0.1, 0, 0]}]\n"
                              "initial: [{part: tool, velocity: [1, 0, 0]}]\n"
                              "probes: [{name: u, part: tool, field: displacement}, {name: f, part: tool, field: force}]\n")
        mass, nodes = 1000 * 0.6 * 0.4 * 0.2, 7 * 5 * 3
        last = rows[-1]
        # the first step has half of its length for the forces at t = 0: u = a t^2/2 at the times of the steps
        self.assertAlmostEqual(last["u.z"], -5 * last["time"] ** 2, delta=1e-12)
        self.assertAlmostEqual(last["u.x"], last["time"] + 0.5 * nodes * 0.1 / mass * last["time"] ** 2, delta=1e-12)
        self.assertAlmostEqual(last["f.z"], -10 * mass, delta=1e-9 * mass)
        self.assertAlmostEqual(last["mass"], mass, delta=1e-11)

    def test_a_driven_angle_about_a_held_axis_is_met_to_rounding(self):
        rows = self.run_alone("curves: {angle: [[0, 0], [0.5, 2.5]]}\nfixed: [{part: tool, dofs: [x, y, z, rx, ry]}]\n"
                              "prescribed: [{part: tool, dof: rz, displacement: angle}]\n"
                              "probes: [{name: r, part: tool, field: rotation}, {name: w, part: tool, field: angular_velocity},\n"
                              "  {name: m, part: tool, field: reaction_moment}, {name: u, part: tool, field: displacement}]\n")
        for row in rows:
            self.assertAlmostEqual(row["r.z"], 5 * min(row["time"], 0.5), delta=1e-12)
            self.assertEqual([row["r.x"], row["r.y"], row["u.x"], row["u.y"], row["u.z"]], [0] * 5)
        self.assertGreater(max(abs(row["m.x"]) for row in rows[1:]), 1)  # it wobbles: the bearings hold it

    def test_an_acceleration_about_an_axis_takes_the_moment_of_inertia(self):
        self.write("plain.yaml", ALONE.replace(", rotate: {axis: [1, 1, 0], degrees: 30}", ""))
        more = ("fixed: [{part: tool, dofs: [x, y, z, rx, ry]}]\nprescribed: [{part: tool, dof: rz, acceleration: 8}]\n"
                "probes: [{name: w, part: tool, field: angular_velocity}, {name: m, part: tool, field: reaction_moment}]\n")
        self.write("plain.yaml", self.text(".", "plain.yaml") + more)
        self.run_scene(1, "plain.yaml", "--out", "plain")
        inertia = 48 / 12 * (0.6**2 + 0.4**2)
        for row in self.rows("plain")[2:]:
            self.assertAlmostEqual(row["m.z"], 8 * inertia, delta=1e-9)
            self.assertAlmostEqual(row["w.z"], 8 * (row["time"] - 0.5e-3), delta=1e-10)
        self.assertLess(self.summary("plain")["energy"]["error_ratio"], 1e-12)

    def test_a_free_axle_keeps_its_energy(self):
        rows = self.run_alone("fixed: [{part: tool, dofs: [rx, ry]}]\n"
                              "initial: [{part: tool, velocity: [0, 0, 1], rotation: {axis: [0, 0, 1], point: [1, 2, 3], rate: 30}}]\n"
                              "probes: [{name: w, part: tool, field: angular_velocity}]\n")
        for row in rows:
            self.assertAlmostEqual(row["w.z"], 30, delta=1e-10)
            self.assertAlmostEqual(math.hypot(row["w.x"], row["w.y"]), 0, delta=1e-10)

    def test_two_free_axes_keep_the_energy_to_second_order(self):
        errors = []
        for step in (2e-3, 1e-3):
            self.write("alone.yaml", ALONE + "fixed: [{part: tool, dofs: [rz]}]\n"
                       "initial: [{part: tool, velocity: [0, 0, 0], rotation: {axis: [1, 2, 0], rate: 10}}]\n")
            self.run_scene(1, "alone.yaml", "--out", "alone", "--force", "--set", f"run.step={step}")
            errors.append(self.summary("alone")["energy"]["error_ratio"])
        self.assertLess(errors[1], 1e-4)
        self.assertLess(errors[1], 0.3 * errors[0])

    def test_a_plane_of_symmetry_lets_it_slide_and_turn_about_the_normal(self):
        self.write("half.yaml", ALONE.replace("at: [1, 2, 3], rotate: {axis: [1, 1, 0], degrees: 30}", "at: [0, 0, 0]") +
                   "symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}]\n"
                   "initial: [{part: tool, velocity: [1, 0, 1], rotation: {axis: [1, 0, 1], rate: 10}}]\n"
                   "probes: [{name: w, part: tool, field: angular_velocity}, {name: u, part: tool, field: displacement}]\n")
        self.run_scene(2, "half.yaml", "--out", "half")
        last = self.rows("half")[-1]
        self.assertAlmostEqual(last["w.z"], 10 / math.sqrt(2), delta=1e-12)
        self.assertEqual(last["u.z"], 0)
        self.assertLess(math.hypot(last["w.x"], last["w.y"]), 1e-15)

    def test_given_mass_centre_and_inertia(self):
        rows = self.run_alone("initial: [{part: tool, velocity: [0, 0, 0], rotation: {axis: [0, 0, 1], rate: 3}}]\n"
                              "probes: [{name: l, part: tool, field: angular_momentum}, {name: x, part: tool, field: position}]\n",
                              "--set", "parts.tool.rigid={mass: 7, centre: [1, 2, 3], inertia: [1, 2, 2.5, 0, 0.1, 0]}")
        first = rows[0]
        self.assertEqual([first["mass"], first["x.x"], first["x.y"], first["x.z"]], [7, 1, 2, 3])
        # the scene turns the body about the origin: the centre has v = (-6, 3, 0)
        self.assertAlmostEqual(first["l.y"], 0.1 * 3 - 7 * 3 * 6, delta=1e-9)
        self.assertAlmostEqual(first["l.z"], 2.5 * 3 + 7 * 3 * 5, delta=1e-9)

    def test_one_clear_line(self):
        def wrong(name, text, *words):
            self.write("wrong.yaml", text)
            done = self.brunt("check", "wrong.yaml")
            self.assertEqual(done.returncode, 2, name + done.stdout + done.stderr)
            told = [line for line in done.stderr.splitlines() if line.strip()]
            self.assertEqual(len(told), 1, name + done.stderr)
            for word in ("wrong.yaml:", "expected", *words):
                self.assertIn(word, done.stderr, name)

        wrong("no step", ALONE.replace(", step: 1.0e-3", ""), "run", "missing step")
        wrong("mass", ALONE.replace("hard}", "hard, rigid: {mass: 0}}"), "parts.tool.rigid.mass", "> 0")
        wrong("inertia", ALONE.replace("hard}", "hard, rigid: {inertia: [1, 1, 3, 0, 0, 0]}}"), "inertia", "principal")
        wrong("flat", ALONE.replace("hard}", "hard, rigid: {inertia: [1, 1, 0, 0, 0, 0]}}"), "inertia", "principal")
        wrong("density", ALONE.replace("density: 1000", "density: 0"), "density", "> 0")
        wrong("one node", JOINED + "sets: {one: {part: head, box: [[0, 0, 0], [0, 0, 0]]}}\nfixed: [{set: one, dofs: [x]}]\n",
              "fixed.0", "moves as a whole", "'head'")
        wrong("driven node", JOINED + "sets: {one: {box: [[0.6, 0, 0], [0.6, 0, 0]]}}\nprescribed: [{set: one, dof: x, velocity: 1}]\n",
              "prescribed.0", "moves as a whole")
        wrong("rotation", JOINED + "fixed: [{part: bar, dofs: [x, rz]}]\n", "fixed.0.dofs", "rx, ry or rz of nodes", "a rigid part")
        wrong("twice", ALONE + "fixed: [{part: tool, dofs: [rx]}]\nprescribed: [{part: tool, dof: rx, velocity: 1}]\n",
              "prescribed.0", "fixed.0")
        wrong("probe", JOINED.replace("part: bar, field: energy", "part: bar, field: rotation"), "probes.4.field", "none of these nodes belongs to a shell or a rigid part")
        wrong("reaction of nodes", ALONE + "fixed: [{part: tool, dofs: [x]}]\nprobes: [{name: r, set: tool_zmin, field: reaction}]\n",
              "probes.0", "'tool_zmin' belongs to the rigid part 'tool'", "expected part: tool")
        wrong("section", JOINED.replace("{name: bar, part: bar, field: energy}",
                                        "{name: cut, section: {part: head, point: [0.3, 0, 0], normal: [1, 0, 0]}}"),
              "probes.4.section", "rigid")
        wrong("relaxation", ALONE + "gravity: {vector: [0, 0, -1]}\nrelaxation: {}\n", "relaxation", "all parts are rigid")
        wrong("two", JOINED.replace("soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}", "soft: {model: rigid, density: 1000}")
              .replace(", element: hex8_full, bulk: {linear: 0, quadratic: 0}", "").replace("run: {", "run: {step: 1.0e-4, "),
              "is shared with", "also rigid", "joins: head")
        wrong("joins nothing", HAMMER.replace("joins: iron", "joins: lead"), "parts.handle.rigid.joins", "iron")
        wrong("joins a soft part", HAMMER.replace("joins: iron", "joins: block"), "parts.handle.rigid", "'block' is not rigid")
        wrong("joins itself", HAMMER.replace("joins: iron", "joins: handle"), "parts.handle.rigid", "itself")
        wrong("joins in a row", HAMMER.replace("iron: {material: steel}", "iron: {material: steel, rigid: {joins: third}}, third: {material: steel}")
              .replace("materials:", "  - {box: {part: third, size: [1, 1, 1], elements: [1, 1, 1], at: [5, 5, 5]}}\nmaterials:").replace("[{part: iron,", "[{part: third,").replace("part: iron, field", "part: third, field"),
              "parts.handle.rigid", "joins: third")
        wrong("mass of a joined part", HAMMER.replace("joins: iron", "joins: iron, mass: 3"), "parts.handle.rigid", "whole body", "parts.iron.rigid")
        wrong("support of a joined part", HAMMER + "fixed: [{part: handle, dofs: [x]}]\n", "fixed.0", "part: iron")
        wrong("motion of a joined part", HAMMER.replace("initial: [{part: iron", "initial: [{part: handle"), "initial.0", "part: iron")
        wrong("probe of a joined part", HAMMER.replace("{name: m, part: iron", "{name: m, part: handle"), "probes.1", "part: iron")
        wrong("contact in a body", HAMMER.replace("\ncontact: [", "\ncontact: [{between: [iron, handle], tied: true}, "), "contact.0", "one rigid body")
        wrong("given", JOINED.replace("element: hex8_full", "rigid: {mass: 1}"), "parts.bar.rigid", "not rigid")


if __name__ == "__main__":
    unittest.main()
