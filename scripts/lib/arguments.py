# SPDX-License-Identifier: Apache-2.0
"""Shared by the Python scripts: parsing of options and writing of pictures. A wrong option, or a picture that cannot be written, gives one
line on the error stream and exit code 2."""
import argparse
import math
import os
import sys

WRONG_INPUT = 2  # as of brunt itself


def shorter(name, most):
    """The name without its middle where it is longer than `most`: names mostly differ at their ends."""
    head = most // 2 - 1
    return name if len(name) <= most else f"{name[:head]}\u2026{name[head + 1 - most:]}"


def excerpt(text):
    """What a message quotes: one line of at most 60 characters, as of the program."""
    shown = "".join(c if c.isprintable() else " " if c.isspace() else "?" for c in str(text))
    return shown if len(shown) <= 60 else shown[:60] + "..."


class Fault(Exception):
    """Wrong input: one line with what is wrong and what is expected."""


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
                self.error(f"unknown option '{excerpt(name)}'; expected one of {', '.join(known)}")
        return super().parse_args(args, namespace)

    def error(self, message):
        for word in sorted(sys.argv[1:], key=len, reverse=True):  # which argparse quotes as they are, or what is behind their =
            for quoted in (word, word.partition("=")[2]):
                message = message.replace(repr(quoted), repr(excerpt(quoted))).replace(quoted, excerpt(quoted)) if excerpt(quoted) != quoted else message
        print(f"{self.prog}: {message}; see scripts/{self.prog} --help", file=sys.stderr)
        sys.exit(WRONG_INPUT)


def counted(noun):
    """A type of argument: how many of them, one at least."""
    def count(text):
        if not (text.isascii() and text.isdigit()) or int(text) < 1:
            raise argparse.ArgumentTypeError(f"invalid number of {noun} '{excerpt(text)}'; expected an integer >= 1")
        return int(text)
    return count


rank_count = counted("ranks")  # the value of -np


def finite_number(text):
    """float() also accepts nan and inf, which no picture can show."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError(f"invalid number '{excerpt(text)}'; expected a finite number, such as 0.5 or 1.0e-3")
    return number


def names(text):
    """A list of names separated by commas."""
    found = [name.strip() for name in text.split(",")]
    if not all(found):
        raise argparse.ArgumentTypeError(f"invalid list '{excerpt(text)}': an empty name; expected names separated by commas, such as bar,plate")
    return found


def refuse_place(path, fail):
    """Fails where no picture can be written, before the picture is computed."""
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        fail(f"{path}: invalid output: folder {folder} does not exist; expected a file in an existing folder")
    if os.path.isdir(path):
        fail(f"{path}: invalid output: it is a folder; expected the name of a picture, such as {os.path.join(path, 'picture.png')}")
    if not os.access(folder, os.W_OK):
        fail(f"{path}: invalid output: {folder} is not writable; expected a file in a writable folder")


def write_picture(figure, path, fail, **options):
    try:
        figure.savefig(path, **options)
    except (OSError, ValueError) as error:  # a full disk; an ending of no kind of picture
        fail(f"{path}: cannot write the file ({getattr(error, 'strerror', None) or error})")
