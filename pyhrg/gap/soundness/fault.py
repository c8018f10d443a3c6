"""Faults of bench and record: no parameters of a simulated gyro. Screening finds and mends those of
one log, `replay/reading_noise.py` finds noise and jitter of readings, the search a ripple of the
table.

A fault beyond its tolerance is a cause of its family. The tolerances are listed in
docs/methods/effects.md.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from scipy.stats import norm

from pyhrg.common.units import ARCSEC
from pyhrg.device.declarations import Family
from pyhrg.gap.replay.reading_noise import ReadingNoise


@dataclass(frozen=True)
class FaultKind:
    """What may be wrong with bench or record, measured by one quantity.

    name: of the cause, in the record format; one cause may have several quantities.
    family: `bench` or `record`.
    parameter: name of the quantity, with its unit.
    tolerance: departure from `sound` that a good laboratory has, in the same unit.
    sound: value of the quantity where nothing is wrong.
    """

    name: str
    family: Family
    parameter: str
    tolerance: float
    sound: float = 0.0


TABLE_SIGN = FaultKind("mounting_sign", "bench", "table_angle_sign", 1.0, 1.0)
"""Slope of the gyro's angle over the table's; beyond the tolerance it is negative."""
AXIS_SIGN = FaultKind("mounting_sign", "bench", "axis_up_sign", 1.0, 1.0)
"""Slope of the gyro's rate at rest over Earth's rate along the stated axis."""
DRIVE_INTERRUPTION = FaultKind("drive_interruption", "bench", "drive_interruption_s", 10.0)
"""Time for which the drive was lost, in all tests."""
ENCODER_NOISE = FaultKind("encoder_noise", "bench", "encoder_noise_arcsec", 1.0)
"""Standard deviation of the white noise of one reading of the table encoder."""
ENCODER_JITTER = FaultKind("time_jitter", "record", "encoder_jitter_s", 2e-5)
"""Standard deviation of the time at which the table encoder is read, about the rows' ends."""
GYRO_JITTER = FaultKind("time_jitter", "record", "gyro_jitter_s", 2e-5)
"""Standard deviation of the time at which the gyro's angle is read, about the rows' ends."""
READING_JITTER = FaultKind("time_jitter", "record", "reading_jitter_s", 2e-5)
"""Standard deviation of the time between the two, where it is hidden whose it is."""
ROW_JITTER = FaultKind("time_jitter", "record", "row_jitter_s", 2e-5)
"""Standard deviation of the time at which all of a row is read, about the rows' ends."""
LOST_ROWS = FaultKind("lost_rows", "record", "lost_rows_percent", 1.0)
"""Share of rows that are missing between the first and the last one."""
OUTLIERS = FaultKind("outliers", "record", "outliers_percent", 0.3)
"""Share of rows with a wrong reading."""
TABLE_RIPPLES = {
    m: FaultKind("table_ripple", "bench", f"table_ripple_{m}_arcsec", 0.3) for m in range(2, 10)
}
"""Amplitude by which encoder and gyro differ, by the harmonic of the table angle. The first is an
eccentric encoder, a known parameter."""
FAULT_KINDS = (
    *TABLE_RIPPLES.values(),
    *(TABLE_SIGN, AXIS_SIGN, DRIVE_INTERRUPTION, ENCODER_NOISE),
    *(ENCODER_JITTER, GYRO_JITTER, READING_JITTER, ROW_JITTER),
    *(LOST_ROWS, OUTLIERS),
)
"""All kinds of faults."""
TOLERANCE_MARGIN = 0.05
"""Share of its tolerance by which a quantity may exceed it and still counts as within. Chosen: a
lag of 20.07 s is no gap where 20 s are tolerated, however well it is known."""
FAULT_NAMES = tuple(dict.fromkeys(kind.name for kind in FAULT_KINDS))
"""Names of the causes that they make."""
SOUND_VALUES = {kind.parameter: kind.sound for kind in FAULT_KINDS}
"""Value of each quantity where nothing is wrong, by its name."""


@dataclass(frozen=True)
class Fault:
    """A fault as the records show it.

    value, sigma: the quantity and its standard deviation, in the unit of the kind.
    """

    kind: FaultKind
    value: float
    sigma: float

    @property
    def beyond_probability(self) -> float:
        """Probability that it exceeds its tolerance."""
        departure = abs(self.value - self.kind.sound)
        return compute_beyond_probability(departure, self.kind.tolerance, self.sigma)


def compute_beyond_probability(departure: float, tolerance: float, sigma: float) -> float:
    """Probability that a normal quantity exceeds its tolerance and the margin
    (docs/methods/verdict.md, Eq. 9), from its departure and its standard deviation; an exact one
    does or does not."""
    excess = departure - (1 + TOLERANCE_MARGIN) * tolerance
    return float(norm.cdf(excess / sigma)) if sigma else float(excess > 0)


@dataclass(frozen=True)
class LogFaults:
    """What screening counted in one log.

    rows: of the log, missing ones too; lost_rows: missing ones; wrong_rows: rows with a wrong
    reading; interruptions: of the drive; interrupted_s: time without it, s; interval_s: of a row.
    """

    rows: int
    lost_rows: int
    wrong_rows: int
    interruptions: int
    interrupted_s: float
    interval_s: float


def sum_log_faults(counts: Sequence[LogFaults]) -> list[Fault]:
    """Faults of all logs together: lost drive, lost rows and wrong readings. Shares are counts, and
    exact; either end of an interruption is known to a row."""
    rows = max(sum(own.rows for own in counts), 1)
    ends = sum(own.interruptions * own.interval_s**2 / 6 for own in counts)
    drive = Fault(DRIVE_INTERRUPTION, sum(own.interrupted_s for own in counts), math.sqrt(ends))
    lost, wrong = sum(own.lost_rows for own in counts), sum(own.wrong_rows for own in counts)
    shares = [Fault(LOST_ROWS, 100 * lost / rows, 0.0), Fault(OUTLIERS, 100 * wrong / rows, 0.0)]
    return [fault for fault in (drive, *shares) if fault.value]


def list_reading_faults(noise: ReadingNoise) -> list[Fault]:
    """Faults of the readings of angles: noise of the encoder, and of both times of reading."""
    levels = [
        (ENCODER_NOISE, noise.encoder, ARCSEC),
        (ENCODER_JITTER, noise.encoder_jitter, 1.0),
        (GYRO_JITTER, noise.gyro_jitter, 1.0),
        (READING_JITTER, noise.reading_jitter, 1.0),
        (ROW_JITTER, noise.row_jitter, 1.0),
    ]
    return [Fault(kind, v / unit, s / unit) for kind, (v, s), unit in levels if v]
