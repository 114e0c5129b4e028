# SPDX-License-Identifier: Apache-2.0
"""Seeded variants of one kind of pair, each judged by a function."""
import argparse
import tempfile


def wrong_of(fault_of, count):
    """fault_of(variant, folder): what is wrong, or nothing. Of `count` variants unless --count and --seed ask for others."""
    asked = argparse.ArgumentParser()
    asked.add_argument("--count", type=int, default=count)
    asked.add_argument("--seed", type=int, default=0)
    asked = asked.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for variant in range(asked.seed, asked.seed + asked.count):
            fault = fault_of(variant, folder)
            wrong += bool(fault)
            if fault:
                print(f"variant {variant}: {fault}", flush=True)
    print(f"{asked.count} variants, {wrong} wrong")
    return wrong
