#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Ten parts that overlap are placed: nothing overlaps, no energy appears, the common centre stays."""
import os
import re
import subprocess
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "the parts are at rest"


def told(result):
    """What the log says of each part: largest displacement, translation, turn [degrees]."""
    with open(os.path.join(result.folder, "log.txt"), encoding="utf-8") as stream:
        found = re.findall(r"placed +part '(\w+)': moved by (\S+) m at most, translation \((\S+), (\S+), (\S+)\), (?:no turn|turned by (\S+) degrees)",
                           stream.read())
    return {part: (float(most), numpy.array([float(x), float(y), float(z)]), float(turn or 0)) for part, most, x, y, z, turn in found}


def masses(case):
    done = subprocess.run([case.brunt, "check", "scene.yaml"], cwd=case.folder, capture_output=True, text=True, check=True)
    return {part: float(mass) for part, mass in re.findall(r"^(\w+) +hex8 +\w+ +\d+ +(\S+)$", done.stdout, re.M)}, done.stdout


def main():
    case = Case(__file__)
    result = case.run()
    moves = told(result)
    mass, listing = masses(case)
    parts = case.scene()["parts"]
    for part in parts:
        most, shift, turn = moves.get(part, (0, numpy.zeros(3), 0))
        case.row("parts", ["part", "mass [kg]", "largest displacement [mm]", "displacement of the centre x, y, z [mm]", "rotation [degrees]"],
                 [part, mass[part], f"{1e3 * most:.3f}", ", ".join(f"{1e3 * x:.3f}" for x in shift), f"{turn:.2f}"])
    overlapping = re.findall(r"^smallest motion .*", listing, re.M)
    case.assert_within("pairs that overlap as drawn", 9, 45, len(overlapping))
    largest = max(most for most, _, _ in moves.values())
    case.assert_below("largest displacement of a point [m]", largest, 0.01, "overlaps of 1 to 4 mm")
    drift = numpy.linalg.norm(sum(mass[part] * shift for part, (_, shift, _) in moves.items())) / sum(mass.values())
    case.assert_below("the common centre moves / largest displacement", drift / largest, 1e-4, "least sum of m sigma")
    energy = result.summary["energy"]
    # against the strain energy of a strain of 1e-6 in all parts, about 1e-12 of their moduli times volumes
    scale = 1e-12 * 2e11 * sum(mass.values()) / 7800
    case.assert_below("kinetic energy after 500 steps / that of a strain of 1e-6", energy["kinetic"] / scale, 1e-12, SOURCE)
    case.assert_below("energy of contact / the same", abs(energy["contact"]) / scale, 1e-12, SOURCE)
    case.assert_below("deepest penetration [m]", result.summary["max_penetration"], 1e-12, SOURCE)
    case.assert_same_on_ranks((1, 2, 3), overrides={"run.steps": 50})
    case.finish()


if __name__ == "__main__":
    main()
