"""A draft of a mapping: columns and units guessed from the headers of logs, to be edited."""

import os
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

from pyhrg.records.campaign_import.column_mapping import BY_STEM
from pyhrg.records.campaign_import.drafting.guesses import (
    Guess,
    Value,
    guess_columns,
    guess_kind,
)
from pyhrg.records.campaign_import.drafting.header_words import KINDS
from pyhrg.records.campaign_import.drafting.shared_units import align_amplitudes, align_frequencies
from pyhrg.records.campaign_import.drafting.sketch import Sketch, read_sketch

CONSTANTS = {"axis_up": "; 0 where the input axis is level and points east", "drive_on": ""}
"""Quantities that are taken to be 1 where they are not logged, with what else they may be."""
NEEDED = {
    "gyro_angle": 'no column was found that may be it: { column = "NAME", unit = "deg" }',
    "wave_angle": "no pattern angle was found: docs/import.md, Where a log lacks something",
}
"""Quantities without which logs tell little, with what is to be done where they are not found."""
DEFAULTS = {"encoding": '"utf-8-sig"'}
"""Values of layout keys that a log leaves out while another states them; of others 0."""
HEAD = f"""\
# A draft by `hrg campaign init`: check every line that says "guessed"; where a value is "edit",
# only you know it, and an import refuses the file until it is there.
# `hrg campaign import THIS_FILE --check` says what it makes of it; docs/import.md has all keys.
# What a column may be: {", ".join(list(BY_STEM)[:8])},
#   {", ".join(list(BY_STEM)[8:14])},
#   {", ".join(list(BY_STEM)[14:])}.
# Kinds of tests: {", ".join(KINDS)}.
device = "my gyro"

[site]
latitude_deg = "edit"           # Earth's rate is taken out with it
gravity_m_s2 = 9.806            # guessed

[nominal]
coriolis_factor = 0.277         # guessed: angular gain of the resonator
decay_time_s = 450.0            # guessed
"""

FITTED = 'role = "fit"   # or "holdout": verifies a diagnosis; neither fitted nor benched'
HELD_OUT = 'role = "holdout"   # guessed: verifies a diagnosis; neither fitted nor benched'
TOLERANCES = """\
[tolerances]                    # how well values are known, one standard deviation each
amplitude_scale = 0.01          # guessed: of what was logged in volts
amplitude_force_scale = 0.01    # guessed
quadrature_force_scale = 0.01   # guessed
"""
"""Lines where amplitudes are scaled."""


def draft_mapping(files: Sequence[Path | str], folder: Path | str = ".") -> str:
    """The text of a mapping (docs/import.md) of these logs, with guesses marked; `folder` is where
    it will lie. What several logs share stands in it once.

    Raises:
        LogError: a file can't be read, or has no header.
    """
    paths = [Path(file) for file in files]
    sketches = [read_sketch(path) for path in paths]
    guesses = [guess_columns(sketch) for sketch in sketches]
    frequency = f"frequency_Hz = {align_frequencies(guesses):.1f}           # guessed"
    scale = align_amplitudes(sketches, guesses)
    layout, shared = sketches[0].layout, _share_guesses(guesses)
    lines = [_write_column(stem, guess) for stem, guess in shared.items()]
    lines += [
        f'{stem} = "edit"   # {how}'
        for stem, how in NEEDED.items()
        if not any(stem in own for own in guesses)
    ]
    constants = [_write_constant(stem) for stem in CONSTANTS if stem not in shared]
    head = "[columns]   # of all tests, but for what a test states"
    parts = [
        HEAD + frequency,
        *([] if scale == 1 else [TOLERANCES]),
        _write_table("layout", layout) + _write_missing(sketches),
        "\n".join([head, *constants, *lines]),
    ]
    for name, path, sketch, own in zip(_name_tests(paths), paths, sketches, guesses, strict=True):
        place = Path(os.path.relpath(path, folder)).as_posix()
        lines = _draft_test(name, place, guess_kind(name, sketch, own), own, shared)
        if sketch.layout != layout:
            values = {key: DEFAULTS.get(key, "0") for key in layout} | sketch.layout
            lines.append(_write_table("tests.layout", values))
        parts.append("\n".join([*lines, *_draft_columns(sketch, own, shared)]))
    return "\n".join(f"{part.rstrip()}\n" for part in parts)


def _write_missing(sketches: Sequence[Sketch]) -> str:
    """A line on the texts that seem to stand for a missing value in any log; empty where there are
    none."""
    texts = sorted(set[str]().union(*(sketch.placeholders for sketch in sketches)))
    listed = ", ".join(f"'{text}'" for text in texts)
    return f"\nmissing = [{listed}]   # guessed: no value" if texts else ""


def _name_tests(paths: Sequence[Path]) -> list[str]:
    """Names of tests, by the logs' names; those that come again are counted."""
    names: list[str] = []
    for path in paths:
        stem = Path(path.name.removesuffix(".gz")).stem
        name = re.sub(r"[^A-Za-z0-9_-]+", "_", stem.replace("+", "plus")).strip("_-") or "log"
        again = sum(
            re.fullmatch(rf"{re.escape(name)}(_\d+)?", other) is not None for other in names
        )
        names.append(f"{name}_{again + 1}" if name in names else name)
    return names


def _share_guesses(guesses: Sequence[Mapping[str, Guess]]) -> dict[str, Guess]:
    """Guesses for most logs, by stem: of those that differ the most frequent."""
    shared = {}
    for stem in BY_STEM:
        counts = Counter(own[stem] for own in guesses if stem in own)
        if 2 * max(counts.values(), default=0) >= len(guesses):
            shared[stem] = counts.most_common(1)[0][0]
    return shared


def _draft_test(
    name: str, path: str, kind: str, own: Mapping[str, Guess], shared: Mapping[str, Guess]
) -> list[str]:
    lines = ["[[tests]]", f'id = "{name}"', f'kind = "{kind}"   # guessed']
    lines.append(HELD_OUT if kind == "manoeuvre" else FITTED)
    lines.append(f"file = '{path}'")
    if "time" not in own:
        lines.append('interval_s = "edit"   # no column of times was found')
    absent = [f'"{stem}"' for stem in shared if stem not in {**own, **CONSTANTS}]
    if "accel_z" in own and "axis_up" not in own:  # the accelerometers say where the axis points
        absent.append('"axis_up"')
    return [*lines, f"absent = [{', '.join(absent)}]"] if absent else lines


def _draft_columns(
    sketch: Sketch, own: Mapping[str, Guess], shared: Mapping[str, Guess]
) -> list[str]:
    """A test's own table of columns, and the columns that are not used."""
    lines = [_write_constant(stem) for stem in CONSTANTS if stem in shared and stem not in own]
    lines += [
        _write_column(stem, guess) for stem, guess in own.items() if guess != shared.get(stem)
    ]
    used = {guess.column for guess in own.values()}
    unused = [f"# not used: {name}" for name in sketch.names if name not in used]
    return [*(["[tests.columns]", *lines] if lines else []), *unused]


def _write_constant(stem: str) -> str:
    return f"{stem} = 1   # guessed: not logged{CONSTANTS[stem]}"


def _write_column(stem: str, guess: Guess) -> str:
    parts = [f"column = '{guess.column}'", *(f"{k} = {_write_value(v)}" for k, v in guess.keys)]
    remark = f"   # {guess.remark}" if guess.remark else ""
    return f"{stem} = {{ {', '.join(parts)} }}{remark}"


def _write_value(value: Value) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, tuple):
        return "{ " + ", ".join(f"'{word}' = {number}" for word, number in value) + " }"
    return f'"{value}"' if isinstance(value, str) else f"{value:.10g}"


def _write_table(name: str, values: Mapping[str, str]) -> str:
    return "\n".join([f"[{name}]", *(f"{key} = {value}" for key, value in values.items())])
