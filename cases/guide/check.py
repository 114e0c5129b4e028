#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs each task of the guide as its page describes it, and compares what the page quotes with the run.

    cases/guide/check.py                  all pages
    cases/guide/check.py --page 1_drop    one page; may be given several times
    cases/guide/check.py --write          also writes quotations, figures and pictures of the pages anew
"""
import argparse
import glob
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import figures  # noqa: E402
from case_check import PROJECT, Case  # noqa: E402
from page import Page, keep_picture  # noqa: E402

MOST_BYTES = 150000  # of a picture


def own_options():
    """Those of this check alone; the rest is for Case."""
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--page", action="append", default=[])
    own, sys.argv[1:] = parser.parse_known_args()
    return own


def as_percent(hand, ours):
    return f"{100 * abs(ours - hand) / abs(hand):.2g} %" if hand else "-"


def table(rows):
    lines = ["| quantity | by hand | run | difference |", "|---|---|---|---|"]
    return lines + [f"| {name} | {hand:.4g} | {ours:.4g} | {as_percent(hand, ours)} |" for name, hand, ours, _ in rows]


def check_figures(case, page, rows):
    """The run against the formula, and the page against both."""
    for name, hand, ours, gate in rows:
        case.assert_close(f"{page.name}: {name}", hand, ours, gate, "by hand", absolute=hand == 0)
    quoted = page.figures()
    case.assert_equal(f"{page.name}: quantities quoted", [row[0] for row in rows], [row[0] for row in quoted])
    for (name, hand, ours, gate), (_, hand_quoted, ours_quoted) in zip(rows, quoted):
        case.assert_close(f"{page.name}: {name}, formula as quoted", float(hand_quoted), float(f"{hand:.4g}"), 2e-3, absolute=hand == 0)
        case.assert_close(f"{page.name}: {name}, run as quoted", float(ours_quoted), ours, max(gate, 2e-3), absolute=hand == 0)


def check_page(case, page, write):
    folder = os.path.join(case.work, page.name)
    page.run(folder, case.brunt, PROJECT)
    case.assert_equal(f"{page.name}: commands that failed", 0, len(page.faults))
    if page.faults:
        print(*page.faults, sep="\n")
        return
    rows, claims = figures.of(page.name, folder)
    for claim, holds in claims:
        case.assert_equal(f"{page.name}: {claim}", True, bool(holds))
    if write:
        page.write(table(rows))
        for image in page.images():
            keep_picture(os.path.join(folder, image), os.path.join(case.folder, image), MOST_BYTES)
    check_figures(case, page, rows)
    for quotation in page.quotations():
        case.assert_equal(f"{page.name}:{quotation.first}: quoted or printed, but not both", [], quotation.missing())
    for image in page.images():
        case.assert_within(f"{page.name}: bytes of {image}", 1000, MOST_BYTES, os.path.getsize(os.path.join(case.folder, image)))
        case.assert_equal(f"{page.name}: {image} is drawn", True, os.path.getsize(os.path.join(folder, image)) > 1000)


def main():
    own = own_options()
    case = Case(__file__)
    for path in sorted(glob.glob(os.path.join(case.folder, "[0-9]_*.md"))):
        page = Page(path)
        if not own.page or page.name in own.page:
            check_page(case, page, own.write)
    case.finish()


if __name__ == "__main__":
    main()
