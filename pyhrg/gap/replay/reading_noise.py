"""White noise of the bench's angle readings: of the table encoder, and of the times of reading.

A reading at a wrong time t + e makes an error e times the rate. Noise of the encoder and of both
times of reading are found from all tests together (docs/methods/replay.md, Eqs. 4 and 9).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.optimize import nnls

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.common.units import ARCSEC
from pyhrg.gap.replay.inputs.table_steps import ERROR_PER_STEP, find_table_step
from pyhrg.records import Log

DIFFERENCE_ORDER = 4
"""Order of the differences: high enough that smooth motion and encoder errors that last for many
rows contribute almost nothing. Chosen."""
VARIANCE_GAIN = math.comb(2 * DIFFERENCE_ORDER, DIFFERENCE_ORDER)
"""Variance of such a difference of white noise over that of the noise."""
OUTLIER_SIGMA = 5.0
"""Differences above this many robust standard deviations are moves of the table. Chosen."""
MIN_DIFFERENCES = 30
"""Fewest differences from which a variance is estimated. Chosen."""
REST_RATE = 1e-4
"""Table rate below which the table counts as resting, rad/s. Chosen."""
LEAST_STEP = 0.5
"""Smallest over largest step of rows in which the table turns steadily. Chosen."""
SIGNIFICANCE_SIGMA = 4.0
"""A noise counts as present above this many standard errors of its variance. Chosen."""
MIN_NOISE = 1e-8
"""Noise of an angle below which it counts as none, rad. Chosen."""
MAX_ROUNDING_NOISE = 2.0
"""White noise of the encoder, over that of rounding to its steps, up to which it counts as
rounding. Chosen."""
MAX_STRIDE_RATIO = math.sqrt(2)
"""Variance of the differences of every second row over that of all rows, above which readings move
and do not jitter. Derived: white noise has 1, a random walk of the table 2."""


class Level(NamedTuple):
    """A noise's standard deviation, and the standard error of that; 0 where it is insignificant."""

    value: float
    sigma: float


NONE = Level(0.0, 0.0)
"""Level of a noise that is insignificant."""


@dataclass(frozen=True)
class ReadingNoise:
    """White noise of a bench's readings of angles.

    encoder: of the table encoder, rad.
    encoder_jitter, gyro_jitter: of the times at which encoder and gyro are read, each apart from
        the other, s.
    reading_jitter: of the time between the two, where the rest hides whose it is, s.
    row_jitter: of the time of the row, which both share, s.
    encoder_step: difference of neighbouring readings of the encoder, rad; 0 where none is seen. The
        error of rounding is no white noise while the table rests.
    """

    encoder: Level = NONE
    encoder_jitter: Level = NONE
    gyro_jitter: Level = NONE
    reading_jitter: Level = NONE
    row_jitter: Level = NONE
    encoder_step: float = 0.0

    @property
    def jitter(self) -> float:
        """Standard deviation of the time between the two readings of a row, s."""
        own = self.encoder_jitter, self.gyro_jitter, self.reading_jitter
        return math.hypot(*(level.value for level in own))


class Variance(NamedTuple):
    """Variance of a reading's noise in rows of about one table rate of one test.

    interval: of the rows, s; square_rate: mean square of the table's rate, rad^2/s^2, 0 at rest;
    value, error: variance, rad^2, and its standard error.
    """

    interval: float
    square_rate: float
    value: float
    error: float


class Variances(NamedTuple):
    """Variances in the same rows: of the encoder alone, of the gyro alone, of the two against each
    other, and of what both share. None where the encoder stands still, which says nothing of its
    noise, and where what both share is not white."""

    encoder: Variance | None
    gyro: Variance
    apart: Variance
    shared: Variance | None


def estimate_reading_noise(logs: Sequence[Log]) -> ReadingNoise:
    """Noise of encoder and times of reading, from all logs of a bench.

    Motion appears in encoder and gyro alike. The variance of either one's noise is therefore its
    covariance with the difference of the two. It is constant, or grows with the square of the
    table's rate: least squares without negative variances tell the two apart. What both have in
    common is jitter of the row where it is white and grows so.
    """
    variances = [own for log in logs for own in _measure_variances(log)]
    of_encoder = [own.encoder for own in variances if own.encoder]
    encoder, encoder_jitter = _fit_levels(of_encoder, by_interval=False)
    _, gyro_jitter = _fit_levels([own.gyro for own in variances], by_interval=True)
    _, row_jitter = _fit_levels([own.shared for own in variances if own.shared], by_interval=True)
    _, reading_jitter = _fit_levels([own.apart for own in variances], by_interval=True)
    if not row_jitter.value or encoder_jitter.value or gyro_jitter.value:
        reading_jitter = NONE
    step = find_table_step(logs)
    if encoder.value < MAX_ROUNDING_NOISE * ERROR_PER_STEP * step:
        encoder = NONE
    else:
        step = 0.0  # the noise makes rounding white, and has it
    return ReadingNoise(encoder, encoder_jitter, gyro_jitter, reading_jitter, row_jitter, step)


def _measure_variances(log: Log) -> Iterator[Variances]:
    """Variances in the rows of a log, by octaves of the table's rate; none of a log that has too
    few rows."""
    if len(log.time) < DIFFERENCE_ORDER + MIN_DIFFERENCES:
        return
    table, gyro = (np.diff(a, DIFFERENCE_ORDER) for a in (log.table_angle, log.gyro_angle))
    apart = table - gyro
    wide = _widen(log.table_angle) * _widen(log.gyro_angle)
    turn = log.table_angle[DIFFERENCE_ORDER:] - log.table_angle[:-DIFFERENCE_ORDER]
    rates = np.abs(turn) / (DIFFERENCE_ORDER * log.interval)
    octaves = np.floor(np.log2(np.maximum(rates, REST_RATE) / REST_RATE))
    known = np.isfinite(apart) & _is_steady(log)
    for octave in np.unique(octaves[known]):
        rows = known & (octaves == octave)
        rows[rows] = is_inlier(table[rows]) & is_inlier(apart[rows])
        if np.sum(rows) >= MIN_DIFFERENCES:
            place = log.interval, float(np.mean(rates[rows] ** 2)) if octave else 0.0
            of_gyro, both, of_encoder, shared = (
                Variance(*place, *_average((a * b)[rows]))
                for a, b in ((-gyro, apart), (apart, apart), (table, apart), (table, gyro))
            )
            if not turn[rows].any():
                yield Variances(None, of_gyro, both, None)
                continue
            is_white = _average_most(wide[rows]) < MAX_STRIDE_RATIO * shared.value
            yield Variances(of_encoder, of_gyro, both, shared if is_white else None)


def _is_steady(log: Log) -> Mask:
    """(n - 4,) whether the table rests, or turns in each row of a difference: where it starts or
    stops, a difference is the motion's own."""
    steps = np.abs(np.diff(log.table_angle))
    within = np.lib.stride_tricks.sliding_window_view(steps, DIFFERENCE_ORDER)
    least, most = within.min(axis=1), within.max(axis=1)
    noise = OUTLIER_SIGMA * math.sqrt(2) * estimate_scatter(log.table_angle)
    is_at_rest = most < max(REST_RATE * log.interval, noise)
    return np.asarray(is_at_rest | (least >= LEAST_STEP * most))


def _average_most(products: Array) -> float:
    """Variance of the noise, rad^2, from products of differences, a few large ones and NaN left
    out; infinite of too few."""
    known = products[np.isfinite(products)]
    known = known[np.abs(known) <= OUTLIER_SIGMA**2 * np.median(np.abs(known))]
    return float(np.mean(known)) / VARIANCE_GAIN if len(known) >= MIN_DIFFERENCES else math.inf


def _widen(angle: Array) -> Array:
    """(n - 4,) fourth differences of every second row, about the same rows as those of all rows;
    NaN at the ends."""
    wide = np.full(max(len(angle) - DIFFERENCE_ORDER, 0), np.nan)
    for first in range(2):
        own = np.diff(angle[first::2], DIFFERENCE_ORDER)
        wide[first + DIFFERENCE_ORDER // 2 :: 2][: len(own)] = own
    return wide


def _average(products: Array) -> tuple[float, float]:
    """Variance of the noise, from products of differences, and its standard error."""
    independent = len(products) / DIFFERENCE_ORDER
    error = math.hypot(float(np.std(products)), MIN_NOISE**2) / math.sqrt(independent)
    return float(np.mean(products)) / VARIANCE_GAIN, error / VARIANCE_GAIN


def is_inlier(series: Array) -> Mask:
    """(n,) whether differences are noise, and not a jump of what is read."""
    return np.asarray(np.abs(series) <= OUTLIER_SIGMA * estimate_robust_deviation(series))


def estimate_scatter(angle: Array) -> float:
    """Standard deviation of the white noise of most of (n,) readings, rad, jitter included."""
    differences = np.diff(angle, DIFFERENCE_ORDER)
    return (
        estimate_robust_deviation(differences) / math.sqrt(VARIANCE_GAIN)
        if len(differences)
        else 0.0
    )


def _fit_levels(variances: Sequence[Variance], *, by_interval: bool) -> tuple[Level, Level]:
    """Noise that is the same at any rate, rad, and jitter of the time of reading, s.

    With `by_interval`, the first is another for each length of a row (that of the shortest is
    given): a random walk grows with it. If only one of the two is significant beside the other, the
    one that explains more stays alone.
    """
    if not variances:
        return NONE, NONE
    intervals = np.array([v.interval for v in variances])
    same = [intervals == each for each in np.unique(intervals)]
    whites = [rows.astype(float) for rows in same] if by_interval else [np.ones(len(variances))]
    squares = np.array([v.square_rate for v in variances])
    (*white, jitter), _ = _solve(variances, [*whites, squares])
    if jitter.value and any(level.value for level in white):
        return white[0], jitter
    (white, misfit), ((jitter,), other) = (_solve(variances, c) for c in (whites, [squares]))
    return (white[0], NONE) if misfit < other else (NONE, jitter)


def _solve(variances: Sequence[Variance], columns: Sequence[Array]) -> tuple[list[Level], float]:
    """Levels whose squares, times their columns, fit the variances best, and their chi-square."""
    values, errors = np.array([(v.value, v.error) for v in variances]).T
    weighted = np.column_stack(columns) / errors[:, None]
    scale = np.sqrt((weighted**2).sum(axis=0))
    scale[scale == 0] = 1.0
    unit = weighted / scale
    solution, misfit = nnls(unit, values / errors)
    deviations = np.sqrt(np.diag(np.linalg.pinv(unit.T @ unit)))
    levels = []
    for column, square, deviation in zip(
        columns, solution / scale, deviations / scale, strict=True
    ):
        is_large = square * float(np.max(column)) > MIN_NOISE**2
        is_there = is_large and square > SIGNIFICANCE_SIGMA * deviation
        level = math.sqrt(square)
        levels.append(Level(level, float(deviation) / (2 * level)) if is_there else NONE)
    return levels, float(misfit) ** 2


def describe_reading_noise(noise: ReadingNoise) -> list[str]:
    """A sentence for each noise that is there."""
    sentences = []
    if noise.encoder_step:
        sentences.append(
            f"table_angle_deg: in steps of {noise.encoder_step / ARCSEC:.3g} arcsec: the error of "
            "rounding counts as noise, and as an offset of each rest"
        )
    if noise.encoder.value:
        size = noise.encoder.value / ARCSEC
        sentences.append(
            f"table_angle_deg: scatters by {size:.2g} arcsec where the gyro does not: counts as "
            "noise of the encoder"
        )
    for column, jitter in (
        ("table_angle_deg", noise.encoder_jitter),
        ("gyro_angle_deg", noise.gyro_jitter),
    ):
        if jitter.value:
            sentences.append(
                f"{column}: scatters by {jitter.value:.2g} s times the table's rate: counts as "
                "noise of the time of reading"
            )
    for level, words in (
        (noise.reading_jitter, "against each other"),
        (noise.row_jitter, "together"),
    ):
        if level.value:
            sentences.append(
                f"time_s: table_angle_deg and gyro_angle_deg scatter {words} by "
                f"{level.value:.2g} s times the table's rate: counts as noise of the rows' time"
            )
    return sentences
