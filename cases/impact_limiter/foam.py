# SPDX-License-Identifier: Apache-2.0
"""Shock theory of a foam bar that strikes a rigid wall."""
import os

import h5py
import numpy


class Foam:
    """Rigid, perfectly plastic, locking foam: a shock behind which all is crushed to the locking strain and at rest.

    Ahead of it the rest, of length L - x, is slowed by the plateau stress: rho (L - x) dv/dt = -plateau, dx/dt = v/locking.
    """

    def __init__(self, scene):
        bar, law = scene["mesh"]["box"], scene["materials"]["foam"]
        self.area, self.length = bar["size"][0] * bar["size"][1], bar["size"][2]
        (_, self.plateau), (self.locking, _) = law["yield_table"]
        self.rho, self.young = law["density"], law["young"]
        self.speed = numpy.linalg.norm(scene["initial"][0]["velocity"])
        jump = self.rho * self.speed**2 / self.locking
        self.wall = self.plateau + jump
        self.crushed = 1 - numpy.exp(-jump / (2 * self.plateau))
        self.left = self.length * (1 - self.locking * self.crushed)
        x = numpy.linspace(0, self.length * self.crushed, 20001)
        squared = self.speed**2 + 2 * self.plateau * self.locking / self.rho * numpy.log1p(-x / self.length)
        # dt = locking dx / v; with v as the variable the end, v = 0, is regular: dx = -(L - x) rho v dv / (plateau locking)
        v = numpy.sqrt(numpy.maximum(squared, 0))
        rest = self.rho * (self.length - x) / self.plateau
        self.stop = numpy.trapz(rest[::-1], v[::-1])
        self.wave = numpy.sqrt(self.young / self.rho)
        self.kick = self.plateau / (self.rho * self.wave)  # what an elastic wave of the plateau stress takes [m/s]

    def measure(self, result):
        """Wall stress at t = 0, crushed share, stop, length at the stop."""
        h = result.history
        time, impulse, momentum = h["time"], h["impulse_wall.z"] / self.area, h["momentum_z"]
        early = time < 0.65 * self.stop
        stress = numpy.polyfit(time[early], impulse[early], 4)[-2]  # slope at 0: elements crush one by one, the sum is smooth
        k = int(numpy.argmax(momentum > 0))
        stop = numpy.interp(0, momentum[k - 1:k + 1], time[k - 1:k + 1])
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
            record = state[max(key for key in state if key.startswith("record"))]
            crushed = ((1 - record["element/relative_volume"][:]) / self.locking).mean()
        return {"wall": stress, "crushed": crushed, "stop": stop, "left": result.at("top.z", stop)}

    def curve(self):
        """Times and stress at the wall until the stop."""
        x = numpy.linspace(0, self.length * self.crushed, 2001)[:-1]
        squared = self.speed**2 + 2 * self.plateau * self.locking / self.rho * numpy.log1p(-x / self.length)
        v = numpy.sqrt(squared)
        time = numpy.concatenate([[0], numpy.cumsum(numpy.diff(x) * self.locking * 2 / (v[1:] + v[:-1]))])
        return time, self.plateau + self.rho * squared / self.locking
