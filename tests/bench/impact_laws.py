#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Laws of contact at impact, by bars of linear elements with lumped masses and central differences: one table in about ten seconds.

usage: impact_laws.py > table.md

Lengths, masses and times are in units of a bar: its length, density and speed of sound are 1, and so are its modulus and impedance. The
striker has the speed of a steel bar at 10 m/s. N is the number of elements a length, C the Courant number; exact values stand in brackets.
Rows share no nodes, so each one is solved by itself. The results are discussed in src/contact/enforcement/IMPACT.md.
"""
import math
from functools import partial
from typing import NamedTuple

import numpy as np

SPEED = 10 / math.sqrt(2e11 / 7800)  # of the striker, over the speed of sound
IMPACT_STRESS = SPEED / 2  # between equal bars; twice as much at a wall
GAP = 1e-3  # before the impact, where the phase of the arrival does not matter
BULK = (0.06, 1.2)  # linear and quadratic coefficient of bulk viscosity
COURANT = (0.9, 0.5)
PHASES = np.arange(0.03, 1, 0.07)  # of the arrival, in steps


class Bar(NamedTuple):
    elements: int
    velocity: float = 0.0
    yields: float = math.inf  # perfectly plastic
    length: float = 1.0


WALL = Bar(0, length=0.0)  # one node of infinite mass


class Step(NamedTuple):
    """What a law knows of its row in a step."""
    dt: float
    gap: float  # at the start of the step
    before: float  # r_-, relative velocity before the step; positive where surfaces part
    free: float  # r*, relative velocity predicted without contact
    pressing: float  # F/Z: the force with which the bodies press, over the impedance of both in series
    plastic: float  # accumulated plastic strain of the adjacent elements


class RateConstraint:
    """The gap does not close before the end of the step: a perfectly plastic impact of the surface nodes."""

    def __init__(self, mass, stiffness, transit):
        """Reduced mass of the two nodes; stiffness of the two half-elements in series; longest time in which a wave crosses one."""
        self.mass, self.stiffness, self.transit = mass, stiffness, transit

    def impulse(self, step):
        return max(0.0, -max(step.gap, 0.0) / step.dt - step.free) * self.mass


class LayerSpring(RateConstraint):
    """A spring with the stiffness of the half-elements, V(g) = k min(0, g)^2 / 2, by its discrete gradient.

    p = -dt (V(g+) - V(g-)) / (g+ - g-), with the gaps g-, g+ half a step before and after. With equal steps it conserves the energy.
    """

    def impulse(self, step):
        middle = step.gap + step.dt / 2 * step.free
        before = step.gap - step.dt / 2 * step.before
        share = self.stiffness * step.dt ** 2 / (4 * self.mass)
        if before > 0 and middle >= 0:
            return 0.0
        after = (middle - share * before) / (1 + share)  # closed at both times: linear
        if before > 0:  # it closes: (1 + share) g+^2 - (middle + before) g+ + middle before = 0
            after = lesser_root(1 + share, middle + before, middle * before)
        elif after > 0:  # it opens: (g+ - middle)(g+ - before) = share before^2
            after = middle + before - lesser_root(1.0, middle + before, middle * before - share * before ** 2)
        return max(0.0, after - middle) * 2 * self.mass / step.dt


class LayerHeld(LayerSpring):
    """The spring stops an arrival. Then the rate constraint holds the compressed layer, until the spring is the stronger one."""
    arriving = True

    def impulse(self, step):
        p = super().impulse(step)
        if not self.arriving:
            p = max(p, -step.free * self.mass)
        self.arriving = p == 0 or self.arriving and step.free + p / self.mass < 0
        return p


class ReturnAtOpening(RateConstraint):
    """The rate constraint, which returns at opening what it took, unless an adjacent element has flowed since the arrival.

    State of a row, all zero while it is open: beta [velocity^2], 2/m times the energy taken; z_- [velocity], the pressing force F/Z of the
    last step; phi [velocity], F/Z with a fading memory; top [velocity], the largest F/Z; e_0, the plastic strain of the adjacent elements
    at the arrival. m is the reduced mass of the row, T = h/(2c) the time in which a wave crosses the half-element of a node, t the longer
    one of the two, and r = G v the relative velocity. A step, in this order:

    1. z = max(0, -G T (v* - v_-) / dt), which is F/Z without a mass or an area.
    2. The rate constraint: r_0 = max(r*, -max(g, 0)/dt), with the impulse p = m (r_0 - r*).
    3. The row opens if it has taken energy (beta > 0), and p = 0 or z < z_-/2: the force vanishes nearer to this step than to the next.
       It returns the share w = 0 if the adjacent elements have flowed (e > e_0); else w = min(1, max(0, 4 phi/top - 2)).
    4. Where it opens it requires the rate r with (r - r*)(r + r_-) = (r_0 - r*)(r_0 + r_-) + w beta, if that exceeds r_0. The work of an
       impulse on the bodies is p (r_- + r)/2 = m/2 (r - r*)(r + r_-). So the row gives m/2 w beta more than the rate constraint, and in
       sum no more than it took. All state is cleared.
    5. Otherwise, if p = 0, all state is cleared. If p > 0, then beta <- max(0, beta - (r_0 - r*)(r_0 + r_-)),
       phi <- max(z, phi + min(1, dt/(30 t)) (z - phi)), z_- <- z, top <- max(top, z), and e_0 <- e in the first step.
    """
    EARLY = 0.5  # of the pressing force of the last step
    FADE = 30  # crossings of a half-element; a load that has long been removed returns nothing

    def __init__(self, *row):
        super().__init__(*row)
        self.clear()

    def clear(self):
        self.beta, self.last, self.phi, self.top, self.plastic = 0.0, 0.0, 0.0, 0.0, None

    def share(self, step):
        if step.plastic > self.plastic + 1e-12:
            return 0.0
        return min(1.0, max(0.0, 4 * self.phi / self.top - 2)) if self.top > 0 else 1.0

    def impulse(self, step):
        p = super().impulse(step)
        rate = step.free + p / self.mass
        taken = -(rate - step.free) * (rate + step.before)
        if self.beta > 0 and (p == 0 or step.pressing < self.EARLY * self.last):
            half = (step.before - step.free) / 2
            square = half ** 2 + step.free * step.before - taken + self.share(step) * self.beta
            returned = (math.sqrt(max(square, 0.0)) - half - step.free) * self.mass
            if returned > p:
                self.clear()
                return returned
        if p == 0:
            self.clear()
            return p
        self.plastic = step.plastic if self.plastic is None else self.plastic
        self.beta = max(0.0, self.beta + taken)
        self.phi = max(step.pressing, self.phi + min(1.0, step.dt / (self.FADE * self.transit)) * (step.pressing - self.phi))
        self.last, self.top = step.pressing, max(self.top, step.pressing)
        return p


def lesser_root(a, b, c):
    """Of a x^2 - b x + c = 0."""
    return (b - math.sqrt(max(b * b - 4 * a * c, 0.0))) / (2 * a)


class Run(NamedTuple):
    dt: float
    velocities: list  # means of the bars at the end
    gap: float  # of the last row, before the last step
    forces: np.ndarray  # of each step and row
    rates: np.ndarray  # of the rows after each step
    given: float  # largest work of contact on the bodies up to a step, over the initial kinetic energy

    @property
    def restitution(self):
        return (self.velocities[1] - self.velocities[0]) / SPEED

    def opening_time(self):
        """From the first impulse to the end of the last step that keeps the gap closed, over the exact time of two equal bars."""
        steps = np.nonzero(self.forces[:, 0] > 0)[0]
        return (steps[-1] - steps[0] + (self.rates[steps[-1], 0] <= 1e-9 * SPEED)) * self.dt / 2


def simulate(bars, law, courant=0.9, gaps=None, end=8.0, bulk=(0.0, 0.0), load=None, damping=0.0, jitter=0.0, watch=None):
    """Bars in a row until the time `end`.

    load(t): force on the first node. damping: decay rate of all velocities. jitter: steps are shortened at random by up to this share.
    watch(velocities): called after each step.
    """
    elements, size = [bar.elements for bar in bars], [bar.length / max(bar.elements, 1) for bar in bars]
    last = np.cumsum(elements) + np.arange(len(bars))
    first, left = last - elements, np.setdiff1d(np.arange(last[-1]), last)
    right, ends = left + 1, list(zip(last[:-1], first[1:]))
    h, yields = np.repeat(size, elements), np.repeat([bar.yields for bar in bars], elements)
    starts = np.cumsum([0.0, *([GAP] * len(ends) if gaps is None else gaps)]) + np.cumsum([0.0, *(bar.length for bar in bars[:-1])])
    x = np.concatenate([starts[i] + size[i] * np.arange(n + 1) for i, n in enumerate(elements)])
    mass = np.bincount(left, h / 2, len(x)) + np.bincount(right, h / 2, len(x))
    inverse = 1 / np.where(mass > 0, mass, np.inf)
    laws = [law(1 / (inverse[a] + inverse[b]), 2 / (size[i] + size[i + 1]), max(size[i:i + 2]) / 2) for i, (a, b) in enumerate(ends)]
    adjacent = [(right == a) | (left == b) for a, b in ends]
    v = np.concatenate([np.full(bar.elements + 1, bar.velocity) for bar in bars])
    u, plastic, flow = np.zeros(len(v)), np.zeros(len(h)), np.zeros(len(h))
    zeta = bulk[0] + bulk[1] ** 2 * SPEED
    longest = courant * h.min() * (math.sqrt(1 + zeta ** 2) - zeta)
    kinetic = (mass * v * v).sum() / 2
    random = np.random.default_rng(1)
    t, dt, work, given, forces, rates = 0.0, longest, 0.0, 0.0, [], []
    while t < end:
        stress = (u[right] - u[left]) / h - plastic
        over = np.maximum(np.abs(stress) - yields, 0.0)
        flow += over
        plastic += np.sign(stress) * over
        stress = stress - np.sign(stress) * over
        if any(bulk):
            rate = (v[right] - v[left]) / h
            stress = stress + (bulk[0] * h + (bulk[1] * h) ** 2 * np.maximum(-rate, 0.0)) * rate
        force = np.zeros(len(v))
        force[left] += stress
        force[right] -= stress
        if load:
            force[0] += load(t)
        before, dt = dt, longest * (1 - jitter * random.random())
        mean = (before + dt) / 2
        star = v + mean * (force * inverse - damping * v)
        forces.append([])
        for i, (a, b) in enumerate(ends):
            pressing = ((star[a] - v[a]) * size[i] - (star[b] - v[b]) * size[i + 1]) / (2 * mean)
            gap = x[b] + u[b] - x[a] - u[a]
            step = Step(dt, gap, v[b] - v[a], star[b] - star[a], max(0.0, pressing), flow[adjacent[i]].sum())
            p = laws[i].impulse(step)
            star[a] -= p * inverse[a]
            star[b] += p * inverse[b]
            work += p * (step.before + star[b] - star[a]) / 2
            forces[-1].append(p / dt)
        given = max(given, work)
        v = star
        u, t = u + dt * v, t + dt
        rates.append([v[b] - v[a] for a, b in ends])
        if watch:
            watch(v)
    velocities = [mean_of(v[i:j + 1]) if i < j else 0.0 for i, j in zip(first, last)]
    return Run(longest, velocities, step.gap, np.array(forces), np.array(rates), given / kinetic if kinetic else 0.0)


def mean_of(velocities):
    """The mean velocity of equal elements."""
    return (velocities[1:] + velocities[:-1]).mean() / 2


def numbers(values, digits=2):
    return ", ".join(f"{value + 0.0:.{digits}f}" for value in values)


def elastic(law):
    """Elastic bars, equal ones over the phases of the arrival; then one that strikes a bar of twice its length."""
    runs = {(n, c): [simulate([Bar(n, SPEED), Bar(n)], law, c, [SPEED * c / n * (1 + phase)]) for phase in PHASES]
            for n in (1, 2, 4, 8, 16) for c in COURANT}
    rows = {}
    for n in (1, 2, 4, 8):
        found = [run.restitution for c in COURANT for run in runs[n, c]]
        rows[f"restitution (1), N = {n}: mean, least"] = numbers([np.mean(found), min(found)])
    for c in COURANT:
        rows[f"opening time (1), C = {c}, N = 2, 4, 8"] = numbers(np.mean([run.opening_time() for run in runs[n, c]]) for n in (2, 4, 8))
    slow = [simulate([Bar(4, SPEED), Bar(4)], law, 0.15, [SPEED * 0.15 / 4 * (1 + phase)]) for phase in PHASES[::2]]
    peaks = [max(run.forces.max() for n in (2, 4, 8, 16) for run in runs[n, c]) for c in COURANT] + [max(run.forces.max() for run in slow)]
    rows["peak force (1), C = 0.9, 0.5, 0.15"] = numbers([peak / IMPACT_STRESS for peak in peaks])
    longer = (simulate([Bar(n, SPEED), Bar(2 * n, length=2.0)], law, end=16).restitution for n in (2, 8))
    rows["unequal lengths (0.5), N = 2, 8"] = numbers(longer)
    return rows


def plastic(law):
    """Plates that yield at half of the stress of the impact, and a bar that yields at 0.3 of it on a wall."""
    plates = [simulate([Bar(n, SPEED, IMPACT_STRESS / 2), Bar(n, yields=IMPACT_STRESS / 2)], law).restitution for n in (4, 8, 16)]
    bars = [simulate([Bar(n, SPEED, 0.3 * SPEED), WALL], law, end=20).restitution for n in (4, 8, 16)]
    return {"plastic plates (0), N = 4, 8, 16": numbers(plates), "plastic bar (0.2), N = 4, 8, 16": numbers(bars)}


def pressed(law):
    """A bar pressed on a wall and damped, without and with an impact before; two bars pressed on a wall for 600 crossings, undamped."""
    slow = simulate([Bar(4), WALL], law, gaps=[0.0], end=120, load=lambda t: IMPACT_STRESS * min(1.0, t / 30), damping=1.0)
    sudden = simulate([Bar(4, SPEED / 2), WALL], law, end=120, load=lambda t: IMPACT_STRESS, damping=1.0)
    bars, load = [Bar(6, SPEED / 5), Bar(5), WALL], lambda t: IMPACT_STRESS / 2
    given = max(simulate(bars, law, 0.8, end=600, load=load, jitter=jitter).given for jitter in (0.0, 0.05))
    return {"static gap (0); after an impact": numbers(run.gap / (IMPACT_STRESS / 8) for run in (slow, sudden)),
            "energy given in a stack (0)": f"{given:.0g}"}


def cradles(last_speed):
    """Bars of 60 elements side by side, of which the first strikes: the speed of the last one."""
    return {f"cradle of 3, 5 bars (1), {name}C = {c}": numbers((last_speed(n, c, bulk) / SPEED for n in (3, 5)), 4)
            for name, bulk in (("", (0.0, 0.0)), ("viscous, ", BULK)) for c in COURANT}


def cradle(law, n, courant, bulk):
    return simulate([Bar(60, SPEED)] + [Bar(60)] * (n - 1), law, courant, [GAP] + [0.0] * (n - 2), 2 * n + 4, bulk).velocities[-1]


def welded(n, courant, bulk):
    """All struck bars in one piece: the largest speed that the last 60 elements ever have."""
    speeds = []
    simulate([Bar(60, SPEED), Bar(60 * (n - 1), length=n - 1.0)], RateConstraint, courant, end=2 * n + 4, bulk=bulk,
             watch=lambda v: speeds.append(mean_of(v[-61:])))
    return max(speeds)


def main():
    laws = {"rate constraint": RateConstraint, "layer spring": LayerSpring, "layer held": LayerHeld,
            "return with flow flag": ReturnAtOpening}
    columns = [{**elastic(law), **plastic(law), **pressed(law), **cradles(partial(cradle, law))} for law in laws.values()]
    columns.append(cradles(welded))
    print("| quantity | " + " | ".join([*laws, "welded bar"]) + " |")
    print("|---" * (len(columns) + 1) + "|")
    for quantity in columns[0]:
        print(f"| {quantity} | " + " | ".join(column.get(quantity, "") for column in columns) + " |")


if __name__ == "__main__":
    main()
