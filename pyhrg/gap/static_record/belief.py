"""What is believed of a sensor's noise before its record is looked at."""

import difflib
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.errors import HrgError
from pyhrg.common.files import toml_of
from pyhrg.gap.static_record.terms import KINDS, Kind

Array = NDArray[np.float64]

TOLERANCE = 0.1
"""Relative standard deviation with which a level is believed where nothing is said."""
TABLES = "[gyros], [accelerometers] or a channel such as [gyro_x]"
PERIODS, TOLERANCE_PERCENT = "sinusoid_periods_s", "tolerance_percent"


class BeliefError(HrgError):
    """The belief can't be used; the message names file, key, what was found and expected."""


@dataclass(frozen=True)
class Belief:
    """Levels of the noises of one sensor, SI.

    levels: (4,) of white angle, random walk of angle, flicker, random walk of rate (`Kind.terms`);
    ramp: of the rate, 1/s of it; periods: of sinusoids that are there in any size, s; tolerance:
    relative standard deviation of each level.
    """

    levels: Array
    ramp: float = 0.0
    periods: tuple[float, ...] = ()
    tolerance: float = TOLERANCE
    source: str = ""
    stated: Mapping[str, float] = field(default_factory=dict)
    """As in the file, with units in the keys."""


def read(path: Path) -> dict[str, Belief]:
    """Beliefs by table.

    Args:
        path: TOML with `[gyros]`, `[accelerometers]` or of single channels (`[gyro_x]`), each with
            levels under the keys of `terms` (a quantum is white noise of quantum/sqrt(12)),
            `sinusoid_periods_s`, `tolerance_percent` (10).

    Raises:
        BeliefError: unreadable, a table or key that is not known, a value that is no number or
            negative, no noise at all.
    """
    content = toml_of(path, BeliefError)
    if not content:
        raise BeliefError(f"{path}: found nothing, expected {TABLES}")
    found = {}
    for name, values in content.items():
        kind = next((kind for kind in KINDS if name.startswith(kind.name)), None)
        if kind is None:
            raise BeliefError(f"{path}: found {name!r}, expected {TABLES}")
        if not isinstance(values, dict):
            raise BeliefError(f"{path}: {name}: found {values!r}, expected a table")
        found[name] = belief_of(values, kind, f"{path.name}: {name}")
    return found


def belief_of(values: Mapping[str, object], kind: Kind, source: str) -> Belief:
    """The belief of a table of values.

    Raises:
        BeliefError: see `read`.
    """
    known = [*kind.of_file, PERIODS, TOLERANCE_PERCENT]
    for key in values:
        if key not in known:
            close = difflib.get_close_matches(key, known, n=1) or known
            raise BeliefError(f"{source}.{key}: found an unknown key, expected {', '.join(close)}")
    stated = {
        key: _number(values[key], f"{source}.{key}", signed=key == kind.ramp.parameter)
        for key in kind.of_file
        if key in values
    }
    levels = np.array([t.factor * stated.get(t.parameter, 0.0) for t in kind.terms])
    quantum = kind.quantum.factor * stated.get(kind.quantum.parameter, 0.0) / math.sqrt(12)
    levels[0] = math.hypot(levels[0], quantum)
    if not levels.any():
        names = ", ".join(t.parameter for t in kind.terms)
        raise BeliefError(f"{source}: found no noise, expected one of {names} above 0")
    return Belief(
        levels,
        kind.ramp.factor * stated.get(kind.ramp.parameter, 0.0),
        _periods(values.get(PERIODS, []), f"{source}.{PERIODS}"),
        _tolerance(values.get(TOLERANCE_PERCENT, 100 * TOLERANCE), source),
        source,
        stated,
    )


def _tolerance(value: object, source: str) -> float:
    percent = _number(value, f"{source}.{TOLERANCE_PERCENT}")
    if not 0.1 <= percent <= 100:
        raise BeliefError(f"{source}.{TOLERANCE_PERCENT}: found {percent:g}, expected 0.1 to 100")
    return percent / 100


def _periods(value: object, where: str) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise BeliefError(f"{where}: found {value!r}, expected a list of periods")
    periods = tuple(_number(item, f"{where}[{i}]") for i, item in enumerate(value))
    if any(period == 0 for period in periods):
        raise BeliefError(f"{where}: found 0, expected more")
    return periods


def _number(value: object, where: str, signed: bool = False) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BeliefError(f"{where}: found {value!r}, expected a number")
    if not math.isfinite(value) or (value < 0 and not signed):
        raise BeliefError(f"{where}: found {value!r}, expected a finite number of at least 0")
    return float(value)
