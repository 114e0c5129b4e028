#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Ends what a Slurm in a temporary folder has started, once the test that owns it has ended in whatever way.

Usage: watch.py FOLDER    waits for the end of its standard input, which the test holds open

Jobs are no children of the test, and a step whose controller is gone never ends by itself. All are known by FOLDER: in their environment
(SLURM_CONF), on their command line, or as where they work.
"""
import glob
import os
import shutil
import signal
import sys


def belongs(process, folder):
    try:
        for name, start in (("environ", "SLURM_CONF="), ("cmdline", "")):
            with open(os.path.join(process, name), "rb") as stream:
                if any(word.startswith(f"{start}{folder}/".encode()) for word in stream.read().split(b"\0")):
                    return True
        return (os.readlink(os.path.join(process, "cwd")) + "/").startswith(folder + "/")
    except OSError:  # has ended, or is another user's
        return False


def processes_of(folder):
    numbers = [int(path.rsplit("/", 1)[1]) for path in glob.glob("/proc/[0-9]*") if belongs(path, folder)]
    return [number for number in numbers if number != os.getpid()]


def main():
    folder = sys.argv[1]
    sys.stdin.read()
    for number in processes_of(folder):
        try:
            os.kill(number, signal.SIGKILL)
        except ProcessLookupError:
            continue
    shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
