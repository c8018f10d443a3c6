"""Stretches of logs that hold nothing but noise and what is known to repeat with the pattern."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import AT_REST, WARM_UP
from pyhrg.noise.likelihood import Spectrum, spectrum
from pyhrg.noise.model import LEAST_SAMPLES, NoiseError, check_record
from pyhrg.records import Log

Array = NDArray[np.float64]

TURNING = (2, 4, 8)
"""Harmonics of the pattern angle that bias map and pick-offs put into the angle while it turns."""
CREEPING = (4,)
"""Of the bias map, while Earth or the bias itself moves the pattern over a part of it."""


@dataclass(frozen=True)
class NoiseRecord:
    """One stretch with constant commands, the table at rest.

    rotation: commanded virtual rotation, an input rate, rad/s.
    swept: pattern angle that it covers, rad.
    spectrum: of the angles, with rate, ramp and harmonics of the pattern estimated along.
    """

    source: str
    interval: float
    rotation: float
    swept: float
    spectrum: Spectrum

    @property
    def n(self) -> int:
        """Number of angles."""
        return len(self.spectrum.rest)


def noise_records(log: Log) -> list[NoiseRecord]:
    """Of a log, without its first 30 s and the 10 s after a command has changed.

    Raises:
        BenchError: no stretch is long enough, or one has no noise.
        LogError: a column that is needed is missing.
    """
    rows = list(_steady(log))
    long = [part for part in rows if part.stop - part.start >= LEAST_SAMPLES]
    if not long:
        longest = max((part.stop - part.start for part in rows), default=0)
        raise BenchError(
            f"{log.source}: no stretch at rest with constant commands has {LEAST_SAMPLES} rows; "
            f"the longest has {longest}"
        )
    return [_record(log, part) for part in long]


SETTLE = 10.0
"""Left out after a command has changed, s: the loops' transient lasts about one."""


def _steady(log: Log) -> Iterator[slice]:
    """Rows with drive on, constant commands, the table at rest, no gap."""
    log.require("table_angle", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
    held = [log.virtual_rotation, log.drive_on, log.amplitude_setpoint, log.phase_offset]
    changed = np.any(np.diff(np.nan_to_num(held), axis=1, prepend=0.0) != 0, axis=0)
    turned = np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1])) >= AT_REST
    broken = changed | turned | (log.drive_on < 0.5)
    warm = int(np.searchsorted(log.time, WARM_UP))
    settle = round(SETTLE / log.interval)
    for part in log.stretches("gyro_angle", "wave_angle", "virtual_rotation", "table_angle"):
        inside = part.start + np.flatnonzero(broken[part])
        for before, after in pairwise([part.start, *inside.tolist(), part.stop]):
            first = max(before + (settle if broken[before] else 0), warm)
            if after > first:
                yield slice(first, after)


def _record(log: Log, rows: slice) -> NoiseRecord:
    time, angle = log.time[rows], log.gyro_angle[rows]
    rotation = float(log.virtual_rotation[rows.start])
    try:
        check_record(angle, log.interval)
    except NoiseError as error:
        raise BenchError(f"{log.source}: {error}") from error
    # a line: the reading itself holds the very noise that is looked for
    pattern = np.polynomial.Polynomial.fit(time, log.wave_angle[rows], 1)(time)
    orders = TURNING if rotation else CREEPING
    trends = [trig(order * pattern) for order in orders for trig in (np.cos, np.sin)]
    swept = abs(float(pattern[-1] - pattern[0]))
    return NoiseRecord(log.source, log.interval, rotation, swept, spectrum(angle, trends))


def alike(records: Sequence[NoiseRecord]) -> tuple[list[NoiseRecord], tuple[str, ...]]:
    """Those of the fastest virtual rotation and of the most usual interval; of the rest, why not.

    Args:
        records: at least one.
    """
    fastest = max(abs(record.rotation) for record in records)
    fast = [r for r in records if np.isclose(abs(r.rotation), fastest, rtol=1e-6)]
    rows = {r.interval: sum(x.n for x in fast if x.interval == r.interval) for r in fast}
    usual = max(rows, key=lambda interval: rows[interval])
    taken = [record for record in fast if record.interval == usual]
    return taken, tuple(
        f"{r.source}: {r.n} rows left out, for they are at {r.interval:g} s and a virtual rotation "
        f"of {np.rad2deg(r.rotation):g} deg/s, others at {usual:g} s and {np.rad2deg(fastest):g}"
        for r in records
        if r not in taken
    )
