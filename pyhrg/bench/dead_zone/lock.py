"""Behaviour of a free pattern at a constant rate: it locks in, or turns in whole periods. The bias
map that locks it comes from logs in which the table turns the pattern slowly, in both
directions.

The mean output rate of a segment less the mean input rate is the bias map averaged over the pattern
angles of the segment. Errors of adjacent segments are correlated: the angle noise where one ends
and the next begins enters both (`row_fit`). A pick-off error goes with the rate, the bias does not:
both directions separate them.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, MEAN, Fit, name_terms
from pyhrg.bench.estimation.row_fit import Part, compute_inflations, fit_rows
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.plateaus import find_plateaus
from pyhrg.bench.readings.segments import COLUMNS, SEGMENT
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log

PERIOD = math.pi / 2
"""Period of the dead zone in the pattern angle, rad."""
STILL = 1 * DEG
"""A pattern that moves less than this in the last quarter of the log is locked, rad."""


@dataclass(frozen=True)
class Run:
    """One power-on at a constant rate.

    Attributes:
        name: name of the test.
        rate: inertial rate on the input axis, rad/s.
        rotation: virtual rotation as an input rate, rad/s.
        pattern_rate: mean over whole periods as an input rate, -(d th/dt)/k, rad/s; 0 while locked.
        locked: whether the pattern is locked in the last quarter of the log.
        angle: mean pattern angle of the last quarter, rad.
        output: mean output rate of the last half, rad/s.
    """

    name: str
    rate: float
    rotation: float
    pattern_rate: float
    locked: bool
    angle: float
    output: float

    @property
    def net(self) -> float:
        """Input rate less virtual rotation, rad/s: what turns the pattern."""
        return self.rate - self.rotation


def read_run(log: Log, site: Site, bryan_factor: float) -> Run:
    """State of the pattern in a log."""
    log.require("table_angle", "gyro_angle", "wave_angle", "virtual_rotation", "axis_up")
    time, wave, n = log.time, log.wave_angle, len(log.time)
    if n < 100 or np.ptp(log.virtual_rotation) > 0:
        raise BenchError(
            f"{log.source}: expected 100 rows or more of one virtual rotation, got {n}"
        )
    earth = site.vertical_rate * float(np.mean(log.axis_up))
    table = (log.table_angle[-1] - log.table_angle[0]) / (time[-1] - time[0])
    late, half = slice(n - n // 4, n), n // 2
    locked = bool(np.ptp(wave[late]) < STILL)
    elapsed = time[-1] - time[half]
    return Run(
        name=log.source,
        rate=float(table) + earth,
        rotation=float(log.virtual_rotation[0]),
        pattern_rate=0.0 if locked else -_turning_rate(log) / bryan_factor,
        locked=locked,
        angle=float(np.mean(wave[late])),
        output=float((log.gyro_angle[-1] - log.gyro_angle[half]) / elapsed),
    )


def _turning_rate(log: Log) -> float:
    """Mean rate of the pattern over as many whole periods as there are, rad/s."""
    turned = log.wave_angle - log.wave_angle[0]
    periods = math.floor(abs(turned[-1]) / PERIOD)
    if periods < 1:
        raise BenchError(
            f"{log.source}: the pattern is not locked and turned by {abs(turned[-1]) / DEG:.3g} "
            "deg; a mean rate takes a whole period of 90 deg"
        )
    way = math.copysign(1.0, turned[-1]) * turned
    row = int(np.argmax(way >= periods * PERIOD))
    share = (periods * PERIOD - way[row - 1]) / (way[row] - way[row - 1])
    end = log.time[row - 1] + share * (log.time[row] - log.time[row - 1])
    return math.copysign(periods * PERIOD / float(end - log.time[0]), turned[-1])


FOURTH = name_terms(4)
ARC = 15 * DEG
"""A segment ends when the pattern has turned by this, or after 100 s, but not within a row."""
FASTEST = 10 * DEG
"""Rate of the table, rad/s, beyond which a log says more of the read-out than of the bias."""
SWEPT = 90 * DEG
"""A log turns the pattern by this at least, a period of the fourth harmonic."""
WITH_RATE = ("scale", "rate cos4", "rate sin4")
GROUPS = {
    "harmonic 4": FOURTH,
    "errors of scale factor and pick-offs": WITH_RATE,
    "harmonic 2": name_terms(2),
    "harmonic 8": name_terms(8),
}
"""Terms beside the mean in the order in which they are asked of the logs."""


def is_turning(log: Log) -> bool:
    """Whether a log is fit for the map: table slow, pattern turned by it, drive and rotation
    constant."""
    log.require(*COLUMNS)
    rate = np.max(np.abs(np.diff(log.table_angle))) / log.interval
    still = np.all(log.virtual_rotation == 0.0) and log.is_driven.all()
    return bool(still and 0.0 < rate < FASTEST and np.ptp(log.wave_angle) >= SWEPT)


def fit_turning(logs: Sequence[Log], site: Site) -> tuple[Fit, list[str]]:
    """Bias map of turning logs, rad/s: mean, harmonics 4 and where they can be seen 2 and 8, and
    what goes with the rate; and a sentence on each term that can't be identified."""
    rows = [stretch for log in logs for stretch in _stretches(log, site)]
    count = sum(map(len, rows))
    if count < 10:
        raise BenchError(f"{logs[0].source}: {count} segments of the turning pattern; 10 needed")
    fastest = max(float(np.max(np.abs(stretch[:, 1]))) for stretch in rows)
    parts = [_part(stretch, fastest) for stretch in rows]
    names, refused = [MEAN], []
    for name, group in GROUPS.items():
        trial, enough = [*names, *group], len(names) + len(group) + 2 < count
        if enough and max(compute_inflations(parts, trial).values()) <= LARGEST_INFLATION:
            names = trial
        elif name == "harmonic 4":
            raise BenchError(f"{logs[0].source}: the pattern turned too little to see {name}")
        else:
            refused.append(f"the turning logs can't tell {name} from the fourth harmonic's terms")
    return fit_rows(parts, names), refused


def _part(stretch: Array, fastest: float) -> Part:
    """Angles that the terms and the error turn the output by in each segment of a stretch."""
    error, rate, span, *phasors = stretch.T
    share = rate / fastest
    columns = {
        MEAN: np.ones_like(error),
        **dict(zip((*name_terms(2), *FOURTH, *name_terms(8)), phasors, strict=True)),
        **dict(zip(WITH_RATE, (share, share * phasors[2], share * phasors[3]), strict=True)),
    }
    scaled = {name: span * column for name, column in columns.items()}
    return Part(scaled, span * error, float(span[0]))


def _stretches(log: Log, site: Site) -> list[Array]:
    """One array (n, 9) a plateau, a row for each of its equally long segments: output less input
    rate, table's rate, length, mean cos 2, sin 2, ... sin 8."""
    stretches = []
    for plateau in find_plateaus(log, 3 * log.interval):
        turned = max(abs(plateau.mean_rate(log, log.wave_angle)), 1e-12)
        segments = []
        rows = max(1, round(min(SEGMENT, ARC / turned) / log.interval))
        for begin in range(plateau.first, plateau.last - rows + 1, rows):
            span = float(log.time[begin + rows] - log.time[begin])
            rate = (log.table_angle[begin + rows] - log.table_angle[begin]) / span
            output = (log.gyro_angle[begin + rows] - log.gyro_angle[begin]) / span
            axis_up = np.mean(log.axis_up[begin + 1 : begin + rows + 1])
            earth = site.vertical_rate * axis_up
            angle = log.wave_angle[begin : begin + rows + 1]
            means = (_mean(trig, order * angle) for order in (2, 4, 8) for trig in (np.cos, np.sin))
            segments.append((float(output - rate - earth), float(rate), span, *means))
        if segments:
            stretches.append(np.array(segments))
    return stretches


def _mean(trig: np.ufunc, phase: Array) -> float:
    """Mean of cosine or sine over a phase (n,) that is linear between its values."""
    middle, half = (phase[1:] + phase[:-1]) / 2, np.diff(phase) / 2
    return float(np.mean(trig(middle) * np.sinc(half / np.pi)))
