#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two rubber rings meet: mortar contact in an implicit step against the explicit solver on the same mesh."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
from implicit_check import EXPLICIT, check_conserved, check_quadratic, energy, report  # noqa: E402

COARSE = {"mesh.0.tube.elements": [2, 50, 1], "mesh.1.tube.elements": [2, 50, 1]}
UNLIKE = {"mesh.1.tube.elements": [4, 122, 1]}
FRICTION = {"contact.0.friction": 0.5, "run.end": 1.92}
HALF_CLOSED = 2e-3  # energy that a scheme whose contact may give is allowed above the start: M7 has .12 % of hht .05


class Impact:
    """What a run says, per unit of thickness."""

    def __init__(self, result, scene):
        self.result, self.history = result, result.history
        self.thickness = scene["mesh"][0]["tube"]["length"]
        self.time = self.history["time"]

    def impulse(self, time=None):
        """On the left ring since the start, [x, y]; at the end where no time is given."""
        time = self.time[-1] if time is None else time
        return numpy.array([self.result.at(f"left.{c}", time) - self.history[f"left.{c}"][0] for c in "xy"]) / self.thickness

    def heat(self, time):
        return self.result.at("friction", time) / self.thickness

    def spin(self):
        """Change of the angular momentum of both rings."""
        total = self.history["spin_left.z"] + self.history["spin_right.z"]
        return (total[-1] - total[0]) / self.thickness

    def contact_times(self):
        """Ends of the first and of the last step in which the rings pressed on each other."""
        given = numpy.hypot(numpy.diff(self.history["right.x"]), numpy.diff(self.history["right.y"]))
        pushed = numpy.flatnonzero(given > 1e-9 * abs(self.history["left.x"][0]))
        return float(self.time[pushed[0] + 1]), float(self.time[pushed[-1] + 1])


class Rings:
    """Runs by name, each once."""

    def __init__(self, case):
        self.case, self.seen = case, {}

    def __call__(self, name, overrides=None):
        if name not in self.seen:
            overrides = overrides or {}
            impact = Impact(self.case.run(name=name, overrides=overrides), self.case.scene(overrides=overrides))
            report(self.case, name, impact.result)
            self.case.row("impulses", ["run", "impulse x", "impulse y", "drift of the spin", "touch", "release"],
                          [name, *(f"{value:.2f}" for value in (*impact.impulse(), impact.spin())),
                           *(f"{time:.3f}" for time in impact.contact_times())])
            self.seen[name] = impact
        return self.seen[name]


def check_impulse(case, label, reference, ours, gate, source, time=None):
    """Each component within a share of the whole impulse."""
    size = numpy.linalg.norm(reference.impulse(time))
    for c, expected, found in zip("xy", reference.impulse(time), ours.impulse(time)):
        case.assert_close(f"{label}: impulse {c}" + (f" at {time:g}" if time else ""), expected, found, gate * size, source,
                          absolute=True)


def check_short(case, rings):
    """Coarse rings from start to end, those of M7 to the first picture of the paper."""
    explicit, coarse = rings("coarse_explicit", {**COARSE, **EXPLICIT}), rings("coarse", {**COARSE, "solver.step": 0.02})
    check_impulse(case, "50x2, dt .02", explicit, coarse, 0.03, "explicit, same mesh; 1.5 % at .01 (M7), first order in dt")
    check_conserved(case, "50x2", coarse.result, 0.02)
    early = {"run.end": 0.32}
    explicit, ours = rings("early_explicit", {**EXPLICIT, **early}), rings("early", {**early, "solver.step": 0.02})
    check_impulse(case, "100x4, dt .02, to .32", explicit, ours, 0.03, "explicit, same mesh; 1.5 % at .01 (M7)")
    check_conserved(case, "100x4, dt .02, to .32", ours.result, 0.02)
    check_quadratic(case, "100x4, step at .32", ours.result)
    case.assert_close("touch, end of the step", 0.055, ours.contact_times()[0], 0.02, "M7, and a step", absolute=True)


def check_guard(case):
    """The trapezoidal rule with exact multipliers makes energy: a guard stops it."""
    result = case.run(name="newmark", overrides={**COARSE, "solver.scheme": "newmark", "solver.step": 0.0025}, expected_code=3)
    case.assert_equal("newmark is stopped", "guard", result.summary["stopped_by"], "M7: makes energy, not to be believed")


def check_steps(case, rings):
    explicit = rings("explicit", EXPLICIT)
    half, fine, finer = rings("dt02", {"solver.step": 0.02}), rings("dt01"), rings("dt005", {"solver.step": 0.005})
    source = "explicit, same mesh (M7)"
    check_impulse(case, "dt .01", explicit, fine, 0.015, source)
    check_impulse(case, "dt .005", explicit, finer, 0.008, source)
    for label, impact in (("dt .02", half), ("dt .01", fine), ("dt .005", finer)):
        check_conserved(case, label, impact.result, 0.01 if impact is not half else 0.015)
    for label, coarse, ours in ((".02 to .01", half, fine), (".01 to .005", fine, finer)):
        case.assert_close(f"drift of the angular momentum, dt {label}", 0.5, ours.spin() / coarse.spin(), 0.15 * 0.5,
                          "first order in dt (M7)", absolute=True)
    touch, release = fine.contact_times()
    case.assert_close("touch", 0.055, touch, 0.01, "M7", absolute=True)
    case.assert_close("release, end of the last step that pushed", 1.08, release, 0.03 + 0.01, "M7, and a step", absolute=True)


def check_meshes(case, rings):
    ours = rings("right_slave", {"contact.0.slave": "right"})
    check_impulse(case, "right ring as slave", rings("explicit", EXPLICIT), ours, 0.015, "explicit, same mesh")
    unlike = rings("unlike", UNLIKE)
    check_impulse(case, "100 on 122 facets", rings("unlike_explicit", {**UNLIKE, **EXPLICIT}), unlike, 0.015, "explicit, same mesh")
    check_conserved(case, "100 on 122 facets", unlike.result, 0.01)


def check_friction(case, rings):
    explicit = rings("friction_explicit", {**FRICTION, **EXPLICIT, "run.cfl": 0.9})  # the step of the values in M7
    ours = rings("friction", {**FRICTION, "solver.step": 0.005})
    for time, (x, y, heat) in {0.96: (0.02, 0.04, 0.05), 1.92: (0.04, 0.08, 0.12)}.items():
        for c, expected, found, gate in zip("xy", explicit.impulse(time), ours.impulse(time), (x, y)):
            case.assert_close(f"mu .5: impulse {c} at {time}", expected, found, gate, "explicit, same mesh (M7)")
        case.assert_close(f"mu .5: heat at {time}", explicit.heat(time), ours.heat(time), heat, "explicit, same mesh (M7)")


def check_schemes(case, rings):
    for alpha, low, high in ((0.05, -0.012, HALF_CLOSED), (0.3333333333333, -0.025, HALF_CLOSED)):
        ours = rings(f"hht_{alpha:.2f}", {"solver.scheme": "hht", "solver.alpha": alpha})
        case.assert_within(f"hht {alpha:.2f}: energy / at the start - 1, least and largest", low, high,
                           float(energy(ours.result).max()), "M7")
        case.assert_within(f"hht {alpha:.2f}: energy at the end", low, high, float(energy(ours.result)[-1]), "M7")


def main():
    case = Case(__file__)
    rings = Rings(case)
    check_short(case, rings)
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 2), overrides={**COARSE, "solver.step": 0.02, "run.end": 0.2})
    if case.long:
        check_guard(case)
        for check in (check_steps, check_meshes, check_friction, check_schemes):
            check(case, rings)
    case.finish()


if __name__ == "__main__":
    main()
