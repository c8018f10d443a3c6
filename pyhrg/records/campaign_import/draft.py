"""A draft of a mapping: columns and units guessed from the headers of logs, to be edited."""

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.records.campaign import FILE_NAME
from pyhrg.records.campaign_import.column_mapping import BY_COLUMN_UNIT, BY_STEM, RATE
from pyhrg.records.campaign_import.layout import SEPARATORS
from pyhrg.records.columns import LogError

PATTERNS = {
    "time": r"^(t|time|timestamp|zeit|uhrzeit)$",
    "table_angle": r"table|encoder|tisch",
    "axis_up": r"axis_up",
    "accel_x": r"^acc.*x$|^a_?x$|^f_?x$",
    "accel_y": r"^acc.*y$|^a_?y$|^f_?y$",
    "accel_z": r"^acc.*z$|^a_?z$|^f_?z$",
    "temperature": r"^temp|^t$|^t_?(case|gyro)|^case",
    "virtual_rotation": r"virtual",
    "amplitude_setpoint": r"set_?point",
    "phase_offset": r"phase_?offset",
    "drive_on": r"drive",
    "wave_angle": r"wave|pattern|theta|precession",
    "quadrature_force": r"quad",
    "amplitude_force": r"ampl.*force|damping",
    "frequency_offset": r"freq",
    "amplitude": r"^ampl",
    "valid": r"valid",
    "gyro_angle": r"gyro|omega|angle|winkel|output|rate",
}
"""What a column's name without its unit matches, in lower case, by stem; the first one counts."""
KINDS = {
    **{"positions": "position", "ring_down": "ring", "virtual_rotation": "virtual"},
    **{"thermal": "therm", "amplitude": "ampl", "phase_step": "phase", "tumble": "tumbl"},
    **{"manoeuvre": "man", "rate": "rate"},
}
"""Kinds of tests, each with a word that the name of its log may have."""
USUAL_UNITS = {"s": "s", "deg": "deg", "rad": "rad", "deg_s": "deg/s", "m_s2": "m/s2"} | {
    **{"degC": "degC", "per_s": "1/s", "Hz": "Hz", "": "1"}
}
"""Unit that is written where a header names none, by the column's own unit."""
HEAD = """\
# A draft by `hrg campaign init`: every line that says "guessed" or "edit" is to be checked.
# `hrg campaign import THIS_FILE --check` says what it makes of it; docs/import.md has all keys.
device = "my gyro"              # edit

[site]
latitude_deg = 45.0             # edit
gravity_m_s2 = 9.806            # edit

[nominal]
coriolis_factor = 0.277         # edit: angular gain of the resonator
decay_time_s = 450.0            # edit
frequency_Hz = 7000.0           # edit
"""


@dataclass(frozen=True)
class Sketch:
    """What the first lines of a log show: its separator's name, decimal comma, and header."""

    separator: str
    comma: bool
    names: tuple[str, ...]


def draft_mapping(files: Sequence[Path | str], folder: Path | str = ".") -> str:
    """The text of a mapping (docs/import.md) of these logs, with guesses marked; `folder` is where
    it will lie.

    Raises:
        LogError: a file can't be read, has no header, or no column that may be the gyro's.
        HrgError: a file's name without its suffix can't be the name of a test, or is there twice.
    """
    paths = [Path(file) for file in files]
    names = [path.name.partition(".")[0] for path in paths]
    for name in names:
        if not FILE_NAME.fullmatch(name) or names.count(name) > 1:
            raise HrgError(f"{name}: expected files whose names are letters and digits, each once")
    places = [Path(os.path.relpath(path, folder)).as_posix() for path in paths]
    sketches = map(_read_sketch, paths)
    return "\n".join([HEAD, *map(_draft_test, names, places, sketches)])


def _read_sketch(path: Path) -> Sketch:
    """Separator, decimal and header of a log, from its first lines."""
    lines = decode(path.name, read_unpacked(path)).splitlines()
    lines = [line for line in lines[:50] if line.strip() and not line.startswith("#")]
    if len(lines) < 2 or not re.search("[A-Za-z]", lines[0]):
        raise LogError(f"{path}: found no row of names above the values, expected one")
    counts = {name: len(_split(lines[0], name)) for name in SEPARATORS if name != "space"}
    separator = max(counts, key=lambda name: counts[name])
    if counts[separator] == 1:
        separator = "space"
    comma = separator != "comma" and bool(re.search(r"\d,\d", lines[-1]))
    return Sketch(separator, comma, tuple(_split(lines[0], separator)))


def _split(line: str, separator: str) -> list[str]:
    return [cell.strip().strip('"') for cell in line.split(SEPARATORS[separator])]


def _draft_test(name: str, path: str, sketch: Sketch) -> str:
    kind = next((kind for kind, word in KINDS.items() if word in name.lower()), "static")
    columns = _guess_columns(sketch.names)
    if not {"gyro_angle", "wave_angle"} & columns.keys():
        found = ", ".join(sketch.names)
        raise LogError(f"{path}: found the columns {found}, expected one that may be the gyro's")
    lines = ["[[tests]]", f'id = "{name}"', f'kind = "{kind}"   # guessed: see docs/records.md']
    lines += ['role = "fit"   # or "holdout": verifies, is never fitted', f"file = '{path}'"]
    if "time" not in columns:
        lines.append("interval_s = 1.0   # edit: no column of times was found")
    lines += ["[tests.layout]", f'separator = "{sketch.separator}"', 'comment = "#"']
    lines += [f'decimal = "{"comma" if sketch.comma else "point"}"', "[tests.columns]"]
    lines += columns.values()
    lines += [
        f"{c} = 1   # guessed: not logged" for c in ("axis_up", "drive_on") if c not in columns
    ]
    unused = [n for n in sketch.names if not any(f"'{n}'" in line for line in columns.values())]
    lines += [f"# not used: {unused_name}" for unused_name in unused]
    return "\n".join(lines) + "\n"


def _guess_columns(names: Sequence[str]) -> dict[str, str]:
    """Lines of a mapping by stem; a column takes the first stem that fits and is free."""
    lines: dict[str, str] = {}
    for name in names:
        guesses = {} if "'" in name else dict(_guess_column(name))
        stem = next((stem for stem in guesses if stem not in lines), "")
        if stem:
            lines[stem] = guesses[stem]
    return lines


def _guess_column(name: str) -> Iterator[tuple[str, str]]:
    """Stem and line of a mapping for each quantity that a column may be."""
    for stem, pattern in PATTERNS.items():
        column = BY_STEM[stem]
        units = BY_COLUMN_UNIT[column.unit] | (RATE if column.unit == "deg" else {})
        bare, unit = _find_unit(name, units)
        if re.search(pattern, bare):
            guess = "" if unit or not column.unit else "   # unit guessed"
            unit = unit or USUAL_UNITS[column.unit]
            parts = [f"column = '{name}'"] + ([f'unit = "{unit}"'] if column.unit else [])
            parts += ['integrate = "means"'] if column.unit == "deg" and unit in RATE else []
            yield stem, f"{stem} = {{ {', '.join(parts)} }}{guess}"


def _find_unit(name: str, units: Iterable[str]) -> tuple[str, str]:
    """A column's name in lower case without its unit, and the unit, in brackets or at the end."""
    parts = re.fullmatch(r"(.*?)\s*[\[(](.*)[\])]\s*", name)
    if parts and parts[2] in units:
        return parts[1].lower(), parts[2]
    for unit in sorted(units, key=len, reverse=True):
        for suffix in ("_" + unit.replace("/", "_per_"), "_" + unit.replace("/", "_")):
            if name.lower().endswith(suffix.lower()):
                return name.lower().removesuffix(suffix.lower()), unit
    return name.lower(), ""
