"""Cases without end: every format spoilt at random, hostile paths, hostile values of options."""

import os
import random
import shlex
from collections.abc import Iterator
from pathlib import Path

from pyhrg.common import cli
from tests.fuzzing.runner import Case, choose
from tests.fuzzing.samples import SAMPLES, Sample

PATHS = (
    "n" * 5000,
    "a\0b",
    ".",
    "/dev/zero",
    "/dev/full",
    "/dev/null",
    "nowhere",
    "pipe",
    "\udc80",
    "",
)
"""Paths that no input is at."""
TEXTS = (
    *("nan", "inf", "-inf", "1e400", "-1", "1_0", "9" * 5000, "-9" * 50, "", " 1", "１", "0x10"),
    *("a\nb", "\udc80", "1e308", "9223372036854775808", "-0.5", "1e-320", "text"),
)
"""Values that no numeric option takes."""
COMMANDS = {
    "bench full-circumference": "--positions --runs --dwell-s --seed --workers",
    "bench fixed-position": "--seed --workers --device --campaign",
    "validate": "--seed --hours --triads --workers --trajectory",
    "study nowhere": "--seed --workers --scheduler",
    "nav": "--hours --rate-hz --samples --align-s --seed --runs --trajectory --imu",
    "align": "--seconds --seed --imu --trajectory",
    "align log.csv": "--from-s --seconds --latitude-deg --longitude-deg --height-m",
    "parking": "--seed --hours --triads --trajectory",
    "schedule": "--seed --hours --triads --trajectory",
    "position .": "--hours --triads --seed --mission",
    "predict car --study .": "--fixed --circumference",
    "gap challenge --out out": "--none --single --pairs --outside --weak --strongest --seed "
    "--workers --level",
    "gap diagnose log.csv --out out": "--belief",
    "build": "--class",
}
"""Commands and those of their options whose hostile values are refused before any work."""


def make_cases(seed: int) -> Iterator[Case]:
    """Cases without end; case i depends on the seed and i alone."""
    number = 0
    while True:
        yield _make_case(choose(seed, number), f"seed {seed}, case {number}")
        number += 1


def _make_case(chance: random.Random, name: str) -> Case:
    kind = chance.random()
    if kind < 0.04:
        return _make_option_case(chance, name)
    format_name, sample = chance.choice(list(SAMPLES.items()))
    if kind < 0.08:
        return _make_path_case(chance, f"{name}, {format_name}", sample)
    return _make_spoilt_case(chance, f"{name}, {format_name}", sample)


def _make_spoilt_case(chance: random.Random, name: str, sample: Sample) -> Case:
    mutations = [chance.choice(sample.mutations) for _ in range(chance.choice((1, 1, 1, 2)))]

    def prepare(folder: Path) -> None:
        data = sample.content[sample.spoilt]
        for mutation in mutations:
            try:
                data = mutation(data, chance)
            except Exception:  # spoilt before, it can't be spoilt that way
                continue
        sample.put(folder, data)

    return Case(f"{name}, {', '.join(m.__name__ for m in mutations)}", prepare, sample.read)


def _make_path_case(chance: random.Random, name: str, sample: Sample) -> Case:
    """The file is a link to something else, or not there."""
    target = chance.choice(PATHS)

    def prepare(folder: Path) -> None:
        sample.put(folder, None)
        os.mkfifo(folder / "pipe")
        if target and len(target) < 100 and "\0" not in target:
            (folder / sample.spoilt).symlink_to(target)

    return Case(f"{name} at {target[:20]!r}", prepare, sample.read)


def _make_option_case(chance: random.Random, name: str) -> Case:
    command, options = chance.choice(list(COMMANDS.items()))
    arguments = [*shlex.split(command), chance.choice(options.split()), chance.choice(TEXTS)]

    def read(folder: Path) -> None:
        raise SystemExit(cli.main(arguments))

    shown = " ".join(text[:30] for text in arguments)
    return Case(f"{name}: hrg {shown!r}", lambda folder: None, read)
