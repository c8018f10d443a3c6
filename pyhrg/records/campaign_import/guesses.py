"""Guesses of what the columns of a log are, from its header and its values."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign_import.column_mapping import BY_STEM
from pyhrg.records.campaign_import.sketch import Sketch
from pyhrg.records.campaign_import.units import ANGLE, BY_COLUMN_UNIT, RATE, TURN

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
"""Unit that is taken where a header names none, by the column's own unit."""
UNIT_NAMES = {
    **{"C": "degC", "°C": "degC", "°": "deg", "Grad": "deg", "Grad/s": "deg/s", "°/s": "deg/s"},
    **{"°/h": "deg/h", "dps": "deg/s", "m/s^2": "m/s2", "m/s²": "m/s2"},
}
"""Units as a laboratory may write them, by their names in a mapping."""
TIME_FORMATS = tuple(
    f"{date}%H:%M:%S{fraction}" for date in ("", "%d.%m.%Y ") for fraction in ("", ".%f", ",%f")
)
"""Formats of a clock's text that are known beside those of ISO 8601."""
UNKNOWN_FORMAT = "edit"
"""What stands for a format that is not known, so that an import refuses it."""
LARGEST_OFFSET = 100.0
"""A loop frequency above this, in the log's unit, is no offset from the nominal one. Chosen."""
AMPLITUDE_TOLERANCE = 0.2
"""A first amplitude further than this from 1 is in another unit than the nominal amplitude."""
MIN_TABLE_TURN = 1 * DEG
"""Smallest range of a turntable's angle, rad, of a log that is not static. Chosen."""
EVEN_STEP_TOLERANCE = 0.01
"""Largest relative departure of a step from the mean in times that rise evenly. Chosen."""

Value = str | float | bool


@dataclass(frozen=True)
class Guess:
    """What a column may be.

    column: its name in the log.
    keys: further keys of the mapping with their values, in the order in which they are written.
    remark: what is to be checked.
    """

    column: str
    keys: tuple[tuple[str, Value], ...]
    remark: str = ""

    def get(self, key: str) -> Value | None:
        """The value of a key, None where the mapping has none."""
        return dict(self.keys).get(key)


def guess_columns(sketch: Sketch) -> dict[str, Guess]:
    """Guesses by stem; a column takes the first stem that fits and is free."""
    guesses: dict[str, Guess] = {}
    for place, name in enumerate(sketch.names):
        own = {} if "'" in name else dict(_guess_column(sketch, place))
        stem = next((stem for stem in own if stem not in guesses), "")
        if stem:
            guesses[stem] = own[stem]
    return _align_origins(guesses)


def guess_kind(name: str, sketch: Sketch, guesses: Mapping[str, Guess]) -> str:
    """Kind of a test by its name; where that says none, by what the table did."""
    kind = next(kind for kind, pattern in KINDS.items() if re.search(pattern, name.lower()))
    table = guesses.get("table_angle")
    if kind != "static" or not table or table.get("unit") in RATE:
        return kind
    values = sketch.read_numbers(sketch.names.index(table.column))
    angle = np.unwrap(values[np.isfinite(values)] * ANGLE[str(table.get("unit"))].factor)
    if len(angle) < 2 or np.ptp(angle) < MIN_TABLE_TURN:
        return kind
    steps = np.abs(np.diff(angle))
    return "rate" if np.mean(steps > 0.1 * np.max(steps)) > 0.5 else "positions"


def _align_origins(guesses: dict[str, Guess]) -> dict[str, Guess]:
    """Guesses whose output angle counts from zero where the table's does: one that is logged as an
    angle, since sums of rates begin at zero."""
    gyro, table = guesses.get("gyro_angle"), guesses.get("table_angle")
    if gyro and table and table.get("from_zero") and not gyro.get("integrate"):
        guesses["gyro_angle"] = replace(gyro, keys=(*gyro.keys, ("from_zero", True)))
    return guesses


def _guess_column(sketch: Sketch, place: int) -> Iterator[tuple[str, Guess]]:
    """Stem and guess for each quantity that a column may be."""
    name, stated = sketch.names[place], sketch.units[place]
    values, clock = sketch.read_numbers(place), _find_time_format(sketch.rows[0][place])
    if clock:
        remark = f"{sketch.rows[0][place]!r}: as %d.%m.%Y %H:%M:%S, see docs/import.md"
        remark = remark if clock == UNKNOWN_FORMAT else "guessed"
        yield "time", Guess(name, (("format", clock),), remark)
        return
    for stem, pattern in PATTERNS.items():
        column = BY_STEM[stem]
        units = BY_COLUMN_UNIT[column.unit] | (RATE if column.unit == "deg" else {})
        names = {unit: unit for unit in units}
        names |= {name: unit for name, unit in UNIT_NAMES.items() if unit in units}
        bare, unit = _find_unit(name, stated, names)
        is_clock = stem == "time" and bool(unit) and _rises_evenly(values)
        if not (re.search(pattern, bare) or is_clock):
            continue
        remark = "" if unit or not column.unit else "unit guessed"
        unit = unit or USUAL_UNITS[column.unit]
        keys: list[tuple[str, Value]] = [("unit", unit)] if column.unit else []
        if column.unit == "deg" and unit in RATE:
            keys.append(("integrate", "means"))
        turn = 0.0 if unit in RATE else TURN / units[unit].factor
        conversion, reason = _guess_conversion(stem, values, turn)
        yield stem, Guess(name, (*keys, *conversion.items()), reason or remark)


def _rises_evenly(values: Array) -> bool:
    steps = np.diff(values)
    mean = float(np.mean(steps)) if len(steps) else 0.0
    return mean > 0 and bool(np.all(np.abs(steps - mean) < EVEN_STEP_TOLERANCE * mean))


def _guess_conversion(stem: str, values: Array, turn: float) -> tuple[dict[str, Value], str]:
    """Keys that turn an absolute frequency, an amplitude in another unit, a clock that runs or an
    encoder that jumps by a turn into a campaign's, and a remark on them; empty where none are
    needed."""
    if len(values) < 2:
        return {}, ""
    first, steps = float(values[0]), np.abs(np.diff(values))
    if stem == "frequency_offset" and first > LARGEST_OFFSET:
        return {"offset": -round(first)}, "guessed: less nominal.frequency_Hz"
    is_amplitude = stem in ("amplitude", "amplitude_setpoint") and first > 0
    if is_amplitude and abs(first - 1) > AMPLITUDE_TOLERANCE:
        return {"scale": float(f"{1 / first:.6g}")}, "guessed: 1 at the nominal amplitude"
    if stem == "table_angle" and turn and np.max(steps) > turn / 2:
        return {"wraps_every": turn, "from_zero": True}, "guessed: it jumps by a turn"
    if stem in ("time", "table_angle") and abs(first) > 2 * steps[0]:
        return {"from_zero": True}, ""
    return {}, ""


def _find_time_format(text: str) -> str:
    """Format of a clock's text, as in a mapping; empty for what is no clock's."""
    if not re.search(r"\d:\d\d", text):
        return ""
    for form in TIME_FORMATS:
        try:
            datetime.strptime(text, form)
        except ValueError:
            continue
        return form
    try:
        datetime.fromisoformat(text)
    except ValueError:
        return UNKNOWN_FORMAT
    return "iso"


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
