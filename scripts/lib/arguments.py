# SPDX-License-Identifier: Apache-2.0
"""What the scripts in Python share: options told wrong, and pictures that cannot be written, are one line and exit code 2."""
import argparse
import math
import os
import sys

WRONG_INPUT = 2  # as of brunt itself


def shorter(name, most):
    """With the middle left out, where it is longer: ends tell names apart."""
    head = most // 2 - 1
    return name if len(name) <= most else f"{name[:head]}\u2026{name[head + 1 - most:]}"


class Fault(Exception):
    """Wrong input: one line that says what is wrong and what is accepted."""


def fail_as(program):
    """A function that ends the script with one line."""
    def fail(message):
        print(f"{program}: {message}", file=sys.stderr)
        sys.exit(WRONG_INPUT)
    return fail


class Parser(argparse.ArgumentParser):
    def parse_args(self, args=None, namespace=None):
        known = [option for action in self._actions for option in action.option_strings]
        for word in sys.argv[1:] if args is None else args:
            name = word.split("=")[0]
            if name.startswith("--") and not any(option.startswith(name) for option in known):
                self.error(f"unknown option '{name}'; accepted: {', '.join(known)}")
        return super().parse_args(args, namespace)

    def error(self, message):
        print(f"{self.prog}: {message}; see scripts/{self.prog} --help", file=sys.stderr)
        sys.exit(WRONG_INPUT)


def counted(noun):
    """A type of argument: how many of them, one at least."""
    def count(text):
        if not (text.isascii() and text.isdigit()) or int(text) < 1:
            raise argparse.ArgumentTypeError(f"'{text}' is no number of {noun}; accepted: a whole number from 1 up")
        return int(text)
    return count


rank_count = counted("ranks")  # the value of -np


def finite_number(text):
    """float takes nan and inf too, of which no picture can be made."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError(f"'{text}' is no finite number; accepted: a number, such as 0.5 or 1.0e-3")
    return number


def names(text):
    """A list with commas."""
    found = [name.strip() for name in text.split(",")]
    if not all(found):
        raise argparse.ArgumentTypeError(f"'{text}' has an empty name; accepted: names with commas between them, such as bar,plate")
    return found


def refuse_place(path, fail):
    """Fails where no picture can be: before the work is done that leads to it."""
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        fail(f"{path}: there is no folder {folder}; accepted: a file in a folder that is there")
    if os.path.isdir(path):
        fail(f"{path}: is a folder; accepted: the name of a picture, such as {os.path.join(path, 'picture.png')}")
    if not os.access(folder, os.W_OK):
        fail(f"{path}: nothing can be written in {folder}; accepted: a file in a folder of your own")


def write_picture(figure, path, fail, **options):
    try:
        figure.savefig(path, **options)
    except (OSError, ValueError) as error:  # a full disk; an ending of no kind of picture
        fail(f"{path}: cannot be written ({getattr(error, 'strerror', None) or error})")
