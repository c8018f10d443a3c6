"""Beliefs: the noise that a sensor should have, as stated before its record is read."""

import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.toml_table import TomlTable, read_table
from pyhrg.gap.static_record.terms import KINDS, Kind

DEFAULT_TOLERANCE = 0.1
"""Relative standard deviation of a believed level where the file states none (chosen)."""
TABLES = "[gyros], [accelerometers] or a channel such as [gyro_x]"
PERIODS, TOLERANCE_PERCENT = "sinusoid_periods_s", "tolerance_percent"


@dataclass(frozen=True)
class Belief:
    """The believed noise of one sensor, SI.

    levels: (4,) of white noise, random walk, flicker and random walk of the rate (`Kind.terms`).
    ramp: of the rate, rate/s.
    periods: of sinusoids that may be in the record with any amplitude, s.
    tolerance: relative standard deviation of each level.
    source: of the belief, for messages.
    """

    levels: Array
    ramp: float = 0.0
    periods: tuple[float, ...] = ()
    tolerance: float = DEFAULT_TOLERANCE
    source: str = ""
    stated: Mapping[str, float] = field(default_factory=dict)
    """Values as in the file, by keys that end with their units."""


def read_beliefs(path: Path) -> dict[str, Belief]:
    """Read a file of beliefs.

    Args:
        path: TOML with tables `[gyros]`, `[accelerometers]` or of single channels (`[gyro_x]`).
            Each has levels under the keys of `terms`, `sinusoid_periods_s` and
            `tolerance_percent` (default 10). A quantization step q adds white noise of q/sqrt(12).

    Returns:
        Beliefs by the names of the tables.

    Raises:
        HrgError: the file can't be read; a table or key is unknown; a value is no number or
            negative; a table states no noise.
    """
    top = read_table(path)
    if not top.values:
        raise HrgError(f"{path}: found nothing, expected {TABLES}")
    beliefs = {}
    for name in top.values:
        kind = next((kind for kind in KINDS if name.startswith(kind.name)), None)
        if kind is None:
            raise HrgError(f"{path}: found {name!r}, expected {TABLES}")
        beliefs[name] = parse_belief(top.table(name).values, kind, f"{path.name}: {name}")
    return beliefs


def parse_belief(values: Mapping[str, object], kind: Kind, source: str) -> Belief:
    """The belief that a table of values states; it raises as `read_beliefs` does."""
    table = TomlTable(source, "", values)
    table.check_known([*kind.by_parameter, PERIODS, TOLERANCE_PERCENT])
    lowest = {kind.ramp.parameter: -sys.float_info.max}
    stated = {
        key: table.number(key, None, lowest.get(key, 0.0), math.inf)
        for key in kind.by_parameter
        if key in values
    }
    levels = np.array([t.factor * stated.get(t.parameter, 0.0) for t in kind.terms])
    step = kind.quantization.factor * stated.get(kind.quantization.parameter, 0.0)
    levels[0] = math.hypot(levels[0], step / math.sqrt(12))
    if not levels.any():
        names = ", ".join(t.parameter for t in kind.terms)
        raise HrgError(f"{source}: found no noise, expected one of {names} above 0")
    periods = table.numbers(PERIODS, None, 0.0, math.inf)
    if 0 in periods:
        raise table.error(PERIODS, list(periods), "periods above 0")
    return Belief(
        levels,
        kind.ramp.factor * stated.get(kind.ramp.parameter, 0.0),
        periods,
        table.number(TOLERANCE_PERCENT, 100 * DEFAULT_TOLERANCE, 0.1, 100.0) / 100,
        source,
        stated,
    )
