# SPDX-License-Identifier: Apache-2.0
"""What is measured: scenes beside this file, what is changed in them, and on how many ranks."""
from typing import NamedTuple

RANKS = "1,4,8,16,32,64"  # above the cores: counts alone
COUNT = ("--repeat", "1")
TIME = ("--at-once", "2", "--repeat", "3")
LONG = ("--at-once", "2", "--repeat", "2")  # a million elements: each start takes a quarter of a minute


class Case(NamedTuple):
    scene: str
    overrides: dict
    options: tuple = COUNT  # of scripts/scaling
    ranks: str = RANKS
    later: bool = False  # from the checkpoint where self-contact has begun; run.steps counts from there


FEW = {"run.steps": 4}
BLOCKS = {**FEW, "mesh.0.box.elements": [32, 32, 33], "mesh.1.box.elements": [29, 29, 36]}
BLOCKS_A_RANK = {**FEW, "mesh.0.box.elements": [12, 12, 12], "mesh.1.box.elements": [11, 11, 13]}
EQUAL_BLOCKS_A_RANK = {**FEW, "mesh.0.box.elements": [12, 12, 12], "mesh.1.box.elements": [9, 16, 12]}  # whole parts in each
BODIES_A_RANK = {**FEW, **{f"mesh.{k}.box.elements": [5 - k % 2] * 3 for k in range(27)}}
NO_CONTACT = {"contact": None}
HALF_A_MILLION = {"mesh.0.box.elements": [56, 56, 83], "mesh.1.box.elements": [51, 51, 90]}

COUNTS = {
    "blocks without contact": Case("two_blocks", {**BLOCKS, **NO_CONTACT}),
    "blocks": Case("two_blocks", BLOCKS),
    "bodies": Case("many_bodies", FEW),
    "blocks without contact, weak": Case("two_blocks", {**EQUAL_BLOCKS_A_RANK, **NO_CONTACT}, ("--weak", *COUNT)),
    "blocks, weak": Case("two_blocks", BLOCKS_A_RANK, ("--weak", *COUNT)),
    "bodies, weak": Case("many_bodies", BODIES_A_RANK, ("--weak", *COUNT)),
    "crush": Case("crush", {"run.end": 3, "run.steps": 4}, later=True),
    "million": Case("two_blocks", {"run.steps": 2}, ranks="1,8,64"),
}
TIMES = {
    "blocks without contact": Case("two_blocks", NO_CONTACT, LONG, "1,2"),
    "blocks": Case("two_blocks", {}, LONG, "1,2"),
    "blocks, weak": Case("two_blocks", HALF_A_MILLION, ("--weak", *LONG), "1,2"),
    "bodies": Case("many_bodies", {}, TIME, "1,2"),
    "bodies, weak": Case("many_bodies", {}, ("--weak", *TIME), "1,2"),
    "crush": Case("crush", {"run.end": 3, "run.steps": 20}, TIME, "1,2", later=True),
}
