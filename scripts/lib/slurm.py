# SPDX-License-Identifier: Apache-2.0
"""What scripts/submit knows of Slurm: its times, its commands, and how a template of scripts/slurm is filled in."""
import re
import shlex
import shutil
import subprocess

from arguments import excerpt

WRONG_INPUT, MACHINE = 2, 4
LONGEST_LEAD = 120  # [s] before the time limit that the signal is sent: what the templates say
TIMES = "expected minutes, hours:minutes:seconds, days-hours:minutes, or such as 45m, 4h, 3h55m, 2d; Slurm counts whole minutes"
UNITS = {"d": 86400, "h": 3600, "m": 60, "s": 1}


class Refused(Exception):
    """One line that says what is wrong, and the exit code."""

    def __init__(self, message, code=WRONG_INPUT):
        super().__init__(message)
        self.code = code


def overflows(parts, after_days):
    """Is a part as large as the unit before it? 3:99 is a slip of the hand."""
    hours = after_days and int(parts[0]) >= 24
    return hours or any(int(part) >= 60 for part in parts[1:])


def seconds_of(text):
    """[s] of a time limit as Slurm writes it, or as brunt's run.wall_limit does."""
    with_units = re.fullmatch(r"(?=.)(?:(\d+)d)?(?:(\d+)h)?(?:(\d+)m)?(?:(\d+)s)?", text)
    days, dash, rest = text.rpartition("-")
    parts = rest.split(":")
    if with_units:
        seconds = sum(int(count or 0) * unit for count, unit in zip(with_units.groups(), UNITS.values()))
    elif all(part.isdecimal() for part in ([days] if dash else []) + parts) and len(parts) <= 3 and not overflows(parts, bool(dash)):
        units = (3600, 60, 1) if dash or len(parts) == 3 else (60, 1)  # days-hours[:minutes[:seconds]], or minutes[:seconds]
        seconds = int(days or 0) * 86400 + sum(int(part) * unit for part, unit in zip(parts, units))
    else:
        raise Refused(f"invalid --time '{excerpt(text)}'; {TIMES}")
    if seconds < 60:
        raise Refused(f"out of range: --time '{excerpt(text)}'; {TIMES}, at least one minute")
    return seconds


def time_text(seconds):
    """days-hours:minutes:seconds, of whole minutes: Slurm rounds up."""
    minutes = -(-seconds // 60)
    return f"{minutes // 1440}-{minutes // 60 % 24:02}:{minutes % 60:02}:00"


def lead_of(seconds):
    """[s] before the limit for the last checkpoint: a third of a short limit, so that most of it is left for the run."""
    return min(LONGEST_LEAD, seconds // 3)


NO_SLURM = ("expected a machine from which jobs are submitted (scripts/setup --slurm installs what Debian has; SLURM_CONF names its "
            "configuration), or --dry-run")


def demand_slurm():
    missing = [name for name in ("sbatch", "sinfo") if not shutil.which(name)]
    if missing:
        raise Refused(f"missing Slurm: {' and '.join(missing)} not found; {NO_SLURM}")


def ask(*command, text=None):
    """The output of one of Slurm's commands; what it complains of is one line."""
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return done.stdout
    told = "; ".join(re.sub(r"^\w+: ((error|fatal): )?", "", line) for line in done.stderr.splitlines() if line.strip())
    if "configuration source" in told:
        raise Refused(f"missing Slurm: {command[0]} finds no configuration; {NO_SLURM}")
    silent = re.search(r"[Uu]nable to contact|Connection refused|authentication error", told)  # the machine, not the input
    raise Refused(f"{command[0]}: {told or 'failed without a message'}", MACHINE if silent else WRONG_INPUT)


def demand_partition(name, seconds):
    """The partition (without a name Slurm's default) must be there and admit jobs of this length: Slurm would let them wait forever."""
    lines = [line.split("|") for line in ask("sinfo", "--noheader", "--format=%R|%P|%l").split()]
    if name is not None and name not in (line[0] for line in lines):
        raise Refused(f"unknown --partition '{excerpt(name)}'; expected one of {', '.join(sorted({line[0] for line in lines}))}")
    for found, marked, limit in lines:
        is_meant = found == name if name is not None else marked.endswith("*")
        if is_meant and limit[0].isdigit() and seconds > seconds_of(limit):
            raise Refused(f"out of range: --time {time_text(seconds)}; expected at most {limit}, the limit of partition {found}")


def option_text(value):
    """A value as a line #SBATCH has it: % of a path is none of Slurm's patterns unless it is one of ours."""
    return value if re.fullmatch(r"[\w.,:=%@/+-]+", value) else '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def replaced_once(text, pattern, line, what):
    text, count = re.subn(pattern, lambda _: line, text, flags=re.M)
    if count != 1:
        raise ValueError(f"the template has {count} lines {what}, and must have one")
    return text


def filled(template, options, variables, more):
    """The template with the values of its lines `#SBATCH --KEY=` and `NAME=` replaced, and `more` lines #SBATCH after the last one."""
    for key, value in options.items():
        template = replaced_once(template, rf"^#SBATCH --{key}=.*$", f"#SBATCH --{key}={option_text(str(value))}", f"#SBATCH --{key}=")
    for name, value in variables.items():
        text = f"({shlex.join(value)})" if isinstance(value, list) else shlex.quote(value)
        template = replaced_once(template, rf"^{name}=.*$", f"{name}={text}", f"{name}=")
    lines = "".join(f"#SBATCH --{key}{'=' + option_text(value) if value else ''}\n" for key, value in more)
    return template.replace("set -euo pipefail\n", lines + "set -euo pipefail\n", 1)
