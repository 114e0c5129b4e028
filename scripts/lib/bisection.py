# SPDX-License-Identifier: Apache-2.0
"""The part `bisect` of a study file: the value of a key at which a column passes a threshold, by halving a bracket."""
import math

KEYS = ("key", "between", "column", "threshold", "within")
EXPECTED = "a map of key, between: [a, b], column, threshold, within"


class Bisection:
    def __init__(self, study):
        self.study, tree = study, study.value("bisect", dict, EXPECTED)
        for key in tree:
            if key not in KEYS:
                study.stop(f"bisect.{key}: unknown key; expected one of {', '.join(KEYS)}")
        for key in KEYS:
            if key not in tree:
                study.stop(f"bisect.{key}: missing; expected {EXPECTED}")
        self.key, self.column = str(tree["key"]), str(tree["column"])
        ends = tree["between"]
        if not isinstance(ends, list) or len(ends) != 2:
            study.stop("bisect.between: invalid interval; expected two different numbers")
        self.ends = tuple(self.number("between", end) for end in ends)
        if self.ends[0] == self.ends[1]:
            study.stop("bisect.between: invalid interval; expected two different numbers")
        self.threshold, self.within = self.number("threshold", tree["threshold"]), self.number("within", tree["within"])
        if self.within <= 0:
            study.stop(f"bisect.within: out of range: {self.within:g}; expected a number > 0")

    def number(self, key, value):
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            self.study.stop(f"bisect.{key}: invalid number {value!r}; expected a finite number")
        return float(value)

    def bracket(self, value_at):
        """The two values between which the column passes the threshold, the last two that were run on either side of it.

        value_at(x): the column with the key set to x, None where the run failed. None where a run has failed or the
        ends lie on one side.
        """
        def above(x):
            found = value_at(x)
            return None if found is None else found > self.threshold

        low, high = self.ends
        sides = above(low), above(high)
        if None in sides or sides[0] == sides[1]:
            return None
        while abs(high - low) > self.within:
            middle = (low + high) / 2
            if middle in (low, high):  # no number lies between them
                break
            side = above(middle)
            if side is None:
                return None
            low, high = (middle, high) if side == sides[0] else (low, middle)
        return low, high
