"""Guesses of what the columns of a log are, from its header and its values."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign_import.column_mapping import BY_STEM
from pyhrg.records.campaign_import.drafting.header_words import (
    KINDS,
    KNOWN_UNITS,
    PATTERNS,
    STATES,
    UNIT_NAMES,
    UNSURE_PATTERNS,
    USUAL_UNITS,
)
from pyhrg.records.campaign_import.drafting.sketch import Sketch
from pyhrg.records.campaign_import.units import ANGLE, BY_COLUMN_UNIT, RATE, TURN

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
MAX_START_ANGLE = 1 * DEG
"""Largest difference of the first output angle and the table's, rad, of those that count from the
same zero. Chosen: Earth's rate makes it in 4 minutes."""
FREQUENCY_REMARK = "guessed: less nominal.frequency_Hz"
AMPLITUDE_REMARK = "guessed: 1 at the nominal amplitude"
VOLTS = re.compile(r"[_ \[(]m?v(/|_per_|_)s[\])]?$", re.IGNORECASE)
"""End of the name, or the unit, of a force in volts per second."""
VOLTS_REMARK = "V/s: state its scale"
WRAP_PERIODS = (90.0, 180.0, 360.0)
"""Periods by which a pattern angle may be wrapped, deg."""
MIN_TABLE_TURN = 1 * DEG
"""Smallest range of a turntable's angle, rad, of a log that is not static. Chosen."""
EVEN_STEP_TOLERANCE = 0.01
"""Largest relative departure of a step from the mean in times that rise evenly. Chosen."""

BRACKETED = re.compile(r"(.*?)\s*[\[(](.*)[\])]\s*")
"""A name with its unit in brackets."""

Value = str | float | bool | tuple[tuple[str, int], ...]
"""Value of a key; pairs are a table."""


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

    def read_values(self, sketch: Sketch) -> Array:
        """(n,) numbers of the column; n is 0 where one is no number."""
        return sketch.read_numbers(sketch.names.index(self.column))

    def get(self, key: str) -> Value | None:
        """The value of a key, None where the mapping has none."""
        return dict(self.keys).get(key)


def guess_columns(sketch: Sketch) -> dict[str, Guess]:
    """Guesses by stem; a column takes the first stem that fits and is free, a sure one if any."""
    guesses: dict[str, Guess] = {}
    for patterns, remark in ((PATTERNS, ""), (UNSURE_PATTERNS, "guessed")):
        used = {guess.column for guess in guesses.values()}
        for place, name in enumerate(sketch.names):
            if "'" in name or name in used:
                continue
            own = dict(_guess_column(sketch, place, patterns))
            stem = next((stem for stem in own if stem not in guesses), "")
            if stem:
                guesses[stem] = replace(own[stem], remark=own[stem].remark or remark)
    return _align_origins(sketch, guesses)


def guess_kind(name: str, sketch: Sketch, guesses: Mapping[str, Guess]) -> str:
    """Kind of a test by its name; where that says none, by what the table did."""
    kind = next(kind for kind, pattern in KINDS.items() if re.search(pattern, name.lower()))
    table = guesses.get("table_angle")
    if kind != "static" or not table or table.get("unit") in RATE:
        return kind
    values = table.read_values(sketch)
    angle = np.unwrap(values[np.isfinite(values)] * ANGLE[str(table.get("unit"))].factor)
    if len(angle) < 2 or np.ptp(angle) < MIN_TABLE_TURN:
        return kind
    steps = np.abs(np.diff(angle))
    return "rate" if np.mean(steps > 0.1 * np.max(steps)) > 0.5 else "positions"


def _align_origins(sketch: Sketch, guesses: dict[str, Guess]) -> dict[str, Guess]:
    """Guesses whose output angle counts from zero where the table's does, or where it begins
    elsewhere: one that is logged as an angle, since sums of rates begin at zero."""
    gyro, table = guesses.get("gyro_angle"), guesses.get("table_angle")
    if not gyro or gyro.get("integrate"):
        return guesses
    counts = bool(table and table.get("from_zero"))
    first = _read_first_angle(sketch, gyro) - (_read_first_angle(sketch, table) if table else 0.0)
    if counts or abs(first) > MAX_START_ANGLE:
        remark = gyro.remark if counts else "guessed: it begins far from zero"
        guesses["gyro_angle"] = Guess(gyro.column, (*gyro.keys, ("from_zero", True)), remark)
    return guesses


def _read_first_angle(sketch: Sketch, guess: Guess) -> float:
    """First value of a column of angles, rad; 0 where it is none."""
    values = guess.read_values(sketch)[:1]
    unit = ANGLE.get(str(guess.get("unit")))
    return float(values[0]) * unit.factor if unit and np.isfinite(values).any() else 0.0


def _guess_column(
    sketch: Sketch, place: int, patterns: Mapping[str, str]
) -> Iterator[tuple[str, Guess]]:
    """Stem and guess for each quantity that a column may be."""
    name, stated = sketch.names[place], sketch.units[place]
    values, clock = sketch.read_numbers(place), _find_time_format(sketch.rows[0][place])
    if clock:
        remark = f"{sketch.rows[0][place]!r}: as %d.%m.%Y %H:%M:%S, see docs/import.md"
        remark = remark if clock == UNKNOWN_FORMAT else "guessed"
        yield "time", Guess(name, (("format", clock),), remark)
        return
    for stem, pattern in patterns.items():
        column = BY_STEM[stem]
        units = BY_COLUMN_UNIT[column.unit] | (RATE if column.unit == "deg" else {})
        names = {unit: unit for unit in units}
        names |= {name: unit for name, unit in UNIT_NAMES.items() if unit in units}
        bare, unit = _find_unit(name, stated, names)
        is_clock = stem == "time" and bool(unit) and _rises_evenly(values)
        is_other = not unit and _state_unit(name, stated) in KNOWN_UNITS
        if is_other or not (re.search(pattern, bare) or is_clock):
            continue
        remark = "" if unit or not column.unit else "unit guessed"
        if stem == "quadrature_force" and VOLTS.search(f"{name} {stated}".strip()):
            remark = VOLTS_REMARK
        unit = unit or USUAL_UNITS[column.unit]
        keys: list[tuple[str, Value]] = [("unit", unit)] if column.unit else []
        if column.unit == "deg" and unit in RATE:
            keys.append(("integrate", "means"))
        turn = 0.0 if unit in RATE else TURN / units[unit].factor
        conversion, reason = _guess_conversion(stem, values, turn)
        if not column.unit and len(values) == 0:
            conversion = _guess_states(sketch, place)
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
        return {"offset": -first}, FREQUENCY_REMARK
    is_amplitude = stem in ("amplitude", "amplitude_setpoint") and first > 0
    if is_amplitude and abs(first - 1) > AMPLITUDE_TOLERANCE:
        return {"scale": float(f"{1 / first:.6g}")}, AMPLITUDE_REMARK
    if stem == "table_angle" and turn and np.max(steps) > turn / 2:
        return {"wraps_every": turn, "from_zero": True}, "guessed: it jumps by a turn"
    if stem == "wave_angle" and turn and (wraps := _find_wrap(values * 360 / turn)):
        return {"wraps_every": wraps * turn / 360}, "guessed: it jumps"
    if stem in ("time", "table_angle") and abs(first) > 2 * steps[0]:
        return {"from_zero": True}, ""
    return {}, ""


def _find_wrap(angle: Array) -> float:
    """Period by which a pattern angle, deg, jumps while it stays within it; 0 where it doesn't."""
    known = angle[np.isfinite(angle)]
    steps = np.abs(np.diff(known))
    fits = (p for p in WRAP_PERIODS if np.ptp(known) <= p and np.max(steps, initial=0.0) > p / 2)
    return next(fits, 0.0)


def _guess_states(sketch: Sketch, place: int) -> dict[str, Value]:
    """Numbers of the words in a column, where all are known."""
    words = sorted({row[place] for row in sketch.rows if place < len(row) and row[place]})
    if not words or not all(word.lower() in STATES for word in words):
        return {}
    return {"states": tuple((word, STATES[word.lower()]) for word in words)}


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
    parts = BRACKETED.fullmatch(name)
    if parts and parts[2] in units:
        return parts[1].lower(), units[parts[2]]
    for unit in sorted(units, key=len, reverse=True):
        for suffix in ("_" + unit.replace("/", "_per_"), "_" + unit.replace("/", "_"), "_" + unit):
            if name.lower().endswith(suffix.lower()):
                return name.lower().removesuffix(suffix.lower()), units[unit]
    return name.lower(), units.get(_state_unit("", stated), "")


def _state_unit(name: str, stated: str) -> str:
    """The unit as a laboratory writes it in brackets after a name, or elsewhere."""
    parts = BRACKETED.fullmatch(name)
    return parts[2] if parts else stated.strip("[]()")
