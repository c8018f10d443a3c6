"""A draft of a mapping: columns and units guessed from the headers of logs, to be edited."""

import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign_import.column_mapping import BY_STEM
from pyhrg.records.campaign_import.sketch import Sketch, read_sketch
from pyhrg.records.campaign_import.units import ANGLE, BY_COLUMN_UNIT, RATE, TURN
from pyhrg.records.columns import LogError

PATTERNS = {
    "time": r"^t$|time|zeit|stamp",
    "table_angle": r"table|^enc|tisch|stage",
    "axis_up": r"axis_up",
    "accel_x": r"^acc.*x$|^a_?x$|^f_?x$",
    "accel_y": r"^acc.*y$|^a_?y$|^f_?y$",
    "accel_z": r"^acc.*z$|^a_?z$|^f_?z$",
    "temperature": r"^temp|^t$|^t_?(case|gyro)|^case",
    "virtual_rotation": r"virtual|^vr",
    "amplitude_setpoint": r"set_?point",
    "phase_offset": r"phase_?offset",
    "drive_on": r"drive|^drv",
    "wave_angle": r"wave|pattern|muster|theta|precession",
    "quadrature_force": r"quad|^fq$",
    "amplitude_force": r"ampl.*force|damping|^fa$",
    "frequency_offset": r"freq|^f$",
    "amplitude": r"^amp",
    "valid": r"valid",
    "gyro_angle": r"gyro|omega|angle|winkel|^out|rate",
}
"""What a column's name without its unit matches, in lower case, by stem; the first one counts."""
KINDS = {
    **{"positions": "position|circ", "ring_down": "ring|^rd", "virtual_rotation": "virtual|^vr"},
    **{"thermal": "therm", "amplitude": "ampl", "phase_step": "phase", "tumble": "tumbl"},
    **{"manoeuvre": "man", "rate": "rate", "static": ""},
}
"""Kinds of tests, each with what the name of its log may match, in lower case."""
USUAL_UNITS = {"s": "s", "deg": "deg", "rad": "rad", "deg_s": "deg/s", "m_s2": "m/s2"} | {
    **{"degC": "degC", "per_s": "1/s", "Hz": "Hz", "": "1"}
}
"""Unit that is written where a header names none, by the column's own unit."""
UNIT_NAMES = {
    **{"C": "degC", "°C": "degC", "°": "deg", "Grad": "deg", "Grad/s": "deg/s", "°/s": "deg/s"},
    **{"°/h": "deg/h", "dps": "deg/s", "m/s^2": "m/s2", "m/s²": "m/s2"},
}
"""Units as a laboratory may write them, by their names in a mapping."""
TIME_FORMATS = ("%H:%M:%S", "%H:%M:%S.%f", "%H:%M:%S,%f")
CONSTANTS = {"axis_up": "; 0 where the input axis is level and points east", "drive_on": ""}
"""Quantities that are taken to be 1 where they are not logged, with what else they may be."""
LARGEST_OFFSET = 100.0
"""A loop frequency above this, in the log's unit, is no offset from the nominal one. Chosen."""
AMPLITUDE_TOLERANCE = 0.2
"""A first amplitude further than this from 1 is in another unit than the nominal amplitude."""
MIN_TABLE_TURN = 1 * DEG
"""Smallest range of a turntable's angle, rad, of a log that is not static. Chosen."""
EVEN_STEP_TOLERANCE = 0.01
"""Largest relative departure of a step from the mean in times that rise evenly. Chosen."""
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
frequency_Hz = 7000.0           # guessed
"""


def draft_mapping(files: Sequence[Path | str], folder: Path | str = ".") -> str:
    """The text of a mapping (docs/import.md) of these logs, with guesses marked; `folder` is where
    it will lie. What several logs share stands in it once.

    Raises:
        LogError: a file can't be read, has no header, or no column that may be the gyro's.
    """
    paths = [Path(file) for file in files]
    sketches = [read_sketch(path) for path in paths]
    columns = [_guess_columns(sketch) for sketch in sketches]
    for path, sketch, guessed in zip(paths, sketches, columns, strict=True):
        if not {"gyro_angle", "wave_angle"} & guessed.keys():
            found = ", ".join(sketch.names)
            raise LogError(
                f"{path}: found the columns {found}, expected one that may be the gyro's"
            )
    layout, shared = sketches[0].layout, _share_columns(columns)
    parts = [HEAD, _write_table("layout", layout)]
    parts.append(
        "\n".join(["[columns]   # of all tests, but for what a test states", *shared.values()])
    )
    for name, path, sketch, guessed in zip(
        _name_tests(paths), paths, sketches, columns, strict=True
    ):
        place = Path(os.path.relpath(path, folder)).as_posix()
        lines = _draft_test(name, place, _guess_kind(name, sketch, guessed), guessed, shared)
        if sketch.layout != layout:
            own = {**dict.fromkeys(layout, "0"), **sketch.layout}
            lines.append(_write_table("tests.layout", own))
        parts.append("\n".join([*lines, *_draft_columns(sketch, guessed, shared)]))
    return "\n".join(f"{part.rstrip()}\n" for part in parts)


def _name_tests(paths: Sequence[Path]) -> list[str]:
    """Names of tests, by the logs' names; those that come again are counted."""
    names: list[str] = []
    for path in paths:
        stem = Path(path.name.removesuffix(".gz")).stem
        name = re.sub(r"[^A-Za-z0-9_-]+", "_", stem).strip("_-") or "log"
        again = sum(
            re.fullmatch(rf"{re.escape(name)}(_\d+)?", other) is not None for other in names
        )
        names.append(f"{name}_{again + 1}" if name in names else name)
    return names


def _share_columns(columns: Sequence[Mapping[str, str]]) -> dict[str, str]:
    """Lines of a mapping for most logs, by stem: of those that differ the most frequent."""
    shared = {}
    for stem in BY_STEM:
        lines = Counter(c[stem] for c in columns if stem in c)
        if 2 * max(lines.values(), default=0) >= len(columns):
            shared[stem] = lines.most_common(1)[0][0]
    return {stem: _write_constant(stem) for stem in CONSTANTS} | shared


def _draft_test(
    name: str, path: str, kind: str, guessed: Mapping[str, str], shared: Mapping[str, str]
) -> list[str]:
    lines = ["[[tests]]", f'id = "{name}"', f'kind = "{kind}"   # guessed']
    lines.append('role = "fit"   # or "holdout": verifies a diagnosis; neither fitted nor benched')
    lines.append(f"file = '{path}'")
    if "time" not in guessed:
        lines.append('interval_s = "edit"   # no column of times was found')
    absent = [f'"{stem}"' for stem in shared if stem not in {**guessed, **CONSTANTS}]
    return [*lines, f"absent = [{', '.join(absent)}]"] if absent else lines


def _guess_kind(name: str, sketch: Sketch, guessed: Mapping[str, str]) -> str:
    """Kind of a test by its name; where that says none, by what the table did."""
    kind = next(kind for kind, pattern in KINDS.items() if re.search(pattern, name.lower()))
    line = guessed.get("table_angle", "")
    unit = re.search(r'unit = "(.*?)"', line)
    if kind != "static" or not unit or unit[1] in RATE:
        return kind
    place = next(i for i, column in enumerate(sketch.names) if f"'{column}'" in line)
    values = sketch.read_numbers(place)
    angle = np.unwrap(values[np.isfinite(values)] * ANGLE[unit[1]].factor)
    if len(angle) < 2 or np.ptp(angle) < MIN_TABLE_TURN:
        return kind
    steps = np.abs(np.diff(angle))
    return "rate" if np.mean(steps > 0.1 * np.max(steps)) > 0.5 else "positions"


def _draft_columns(
    sketch: Sketch, guessed: Mapping[str, str], shared: Mapping[str, str]
) -> list[str]:
    """A test's own table of columns, and the columns that are not used."""
    constants = {stem: _write_constant(stem) for stem in CONSTANTS if stem in shared}
    own = [line for stem, line in {**constants, **guessed}.items() if line != shared.get(stem)]
    unused = [n for n in sketch.names if not any(f"'{n}'" in line for line in guessed.values())]
    lines = ["[tests.columns]", *own] if own else []
    return [*lines, *(f"# not used: {name}" for name in unused)]


def _write_constant(stem: str) -> str:
    return f"{stem} = 1   # guessed: not logged{CONSTANTS[stem]}"


def _write_table(name: str, values: Mapping[str, str]) -> str:
    return "\n".join([f"[{name}]", *(f"{key} = {value}" for key, value in values.items())])


def _guess_columns(sketch: Sketch) -> dict[str, str]:
    """Lines of a mapping by stem; a column takes the first stem that fits and is free."""
    lines: dict[str, str] = {}
    for place, name in enumerate(sketch.names):
        guesses = {} if "'" in name else dict(_guess_column(sketch, place))
        stem = next((stem for stem in guesses if stem not in lines), "")
        if stem:
            lines[stem] = guesses[stem]
    return _align_origins(lines)


def _align_origins(lines: dict[str, str]) -> dict[str, str]:
    """Lines whose output angle counts from zero where the table's does: one that is logged as an
    angle, since sums of rates begin at zero."""
    gyro = lines.get("gyro_angle", "")
    if "from_zero" in lines.get("table_angle", "") and gyro and "integrate" not in gyro:
        lines["gyro_angle"] = gyro.replace(" }", ", from_zero = true }")
    return lines


def _guess_column(sketch: Sketch, place: int) -> Iterator[tuple[str, str]]:
    """Stem and line of a mapping for each quantity that a column may be."""
    name, stated = sketch.names[place], sketch.units[place]
    for stem, pattern in PATTERNS.items():
        column = BY_STEM[stem]
        units = BY_COLUMN_UNIT[column.unit] | (RATE if column.unit == "deg" else {})
        names = {unit: unit for unit in units}
        names |= {name: unit for name, unit in UNIT_NAMES.items() if unit in units}
        bare, unit = _find_unit(name, stated, names)
        values = sketch.read_numbers(place)
        is_clock = stem == "time" and bool(unit) and _rises_evenly(values)
        if not (re.search(pattern, bare) or is_clock):
            continue
        guess = "" if unit or not column.unit else "   # unit guessed"
        unit = unit or USUAL_UNITS[column.unit]
        parts = [f"column = '{name}'"]
        clock = _find_time_format(sketch.rows[0][place]) if stem == "time" else ""
        if clock:
            parts, guess = [*parts, f'format = "{clock}"'], "   # guessed"
        elif column.unit:
            parts.append(f'unit = "{unit}"')
        if column.unit == "deg" and unit in RATE:
            parts.append('integrate = "means"')
        turn = 0.0 if unit in RATE else TURN / units[unit].factor
        conversion, reason = _guess_conversion(stem, values, turn)
        parts += [conversion] if conversion else []
        yield stem, f"{stem} = {{ {', '.join(parts)} }}{reason or guess}"


def _rises_evenly(values: Array) -> bool:
    steps = np.diff(values)
    mean = float(np.mean(steps)) if len(steps) else 0.0
    return mean > 0 and bool(np.all(np.abs(steps - mean) < EVEN_STEP_TOLERANCE * mean))


def _guess_conversion(stem: str, values: Array, turn: float) -> tuple[str, str]:
    """What turns an absolute frequency, an amplitude in another unit, a clock that runs or an
    encoder that jumps by a turn into a campaign's, and a remark on it; empty where none is needed.
    """
    if len(values) < 2:
        return "", ""
    first, steps = float(values[0]), np.abs(np.diff(values))
    if stem == "frequency_offset" and first > LARGEST_OFFSET:
        return f"offset = -{first:.0f}", "   # guessed: less nominal.frequency_Hz"
    is_amplitude = stem in ("amplitude", "amplitude_setpoint") and first > 0
    if is_amplitude and abs(first - 1) > AMPLITUDE_TOLERANCE:
        return f"scale = {1 / first:.6g}", "   # guessed: 1 at the nominal amplitude"
    if stem == "table_angle" and turn and np.max(steps) > turn / 2:
        return f"wraps_every = {turn:.10g}, from_zero = true", "   # guessed: it jumps by a turn"
    if stem in ("time", "table_angle") and abs(first) > 2 * steps[0]:
        return "from_zero = true", ""
    return "", ""


def _find_time_format(text: str) -> str:
    """Format of a clock's text, as in a mapping; empty for a number or an unknown one."""
    for form in TIME_FORMATS:
        try:
            datetime.strptime(text, form)
        except ValueError:
            continue
        return form
    return "iso" if re.match(r"\d{4}-\d\d-\d\d", text) else ""


def _find_unit(name: str, stated: str, units: Mapping[str, str]) -> tuple[str, str]:
    """A column's name in lower case without its unit, and the unit in a mapping's words: in
    brackets, at the end, or stated elsewhere."""
    parts = re.fullmatch(r"(.*?)\s*[\[(](.*)[\])]\s*", name)
    if parts and parts[2] in units:
        return parts[1].lower(), units[parts[2]]
    for unit in sorted(units, key=len, reverse=True):
        for suffix in ("_" + unit.replace("/", "_per_"), "_" + unit.replace("/", "_"), "_" + unit):
            if name.lower().endswith(suffix.lower()):
                return name.lower().removesuffix(suffix.lower()), units[unit]
    stated = stated.strip("[]()")
    return name.lower(), units.get(stated, "")
