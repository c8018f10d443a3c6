"""Free decays of a log, and the shell that explains them: a joint fit of angle and amplitude."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import least_squares

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.row_fit import Part, fit_rows
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.output_rows import SHORTEST_ROWS
from pyhrg.bench.readings.segments import AT_REST, split_rows
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.fmu import CONTROL_PERIOD
from pyhrg.records import Log
from pyhrg.theory.free_orbit import FreeShell

TERMS = ("decay", "damping cos", "damping sin", "split cos", "split sin")
CHANNELS = ("angle", "amplitude")
SCALES = np.array([1e-7, 1e-8, 1e-8, 1e-6, 1e-6])
"""Steps of the terms for central differences, 1/s and rad/s: errors 1e-8 of the columns."""
ROUNDS = 30
CONVERGENCE_SHARE = 1e-3
"""The fit is done when no combination of terms moves by more than this share of its standard
error, or than rounding."""


@dataclass(frozen=True)
class Decay:
    """One ring-down: rows after the drive was switched off at time 0, in a known rotation.

    Attributes:
        time: (n,) s.
        turned: (n,) of the pattern, rad.
        amplitude: (n,).
        angle_at_start: pattern angle at the start, rad.
        rotation: rotation rate of the case, rad/s.
        left_out: duration of its later rows that `cut` took away, s.
    """

    source: str
    interval: float
    time: Array
    turned: Array
    amplitude: Array
    angle_at_start: float
    rotation: float
    left_out: float = 0.0

    @property
    def angle(self) -> Array:
        """(n,) of the pattern, rad."""
        return self.angle_at_start + self.turned

    def cut(self, duration: float) -> "Decay":
        """Its rows up to a time after the drive was switched off, s."""
        rows = slice(int(np.searchsorted(self.time, duration, side="right")))
        parts = (self.time, self.turned, self.amplitude)
        time, turned, amplitude = (values[rows] for values in parts)
        left_out = (len(self.time) - len(time)) * self.interval
        return replace(self, time=time, turned=turned, amplitude=amplitude, left_out=left_out)


def find_decays(log: Log, site: Site, k: float) -> list[Decay]:
    """Ring-downs of a log that begin within a stretch without gap, the table at rest.

    The gyro's output shows how the pattern turns, with more digits than its angle is logged with.
    """
    log.require("gyro_angle", "wave_angle", "amplitude", "drive_on", "table_angle", "axis_up")
    free = log.is_free
    switched = np.diff(free, prepend=free[:1])
    return [
        _decay(log, first - 1, last, site, k)
        for stretch in log.stretches("gyro_angle", "wave_angle", "amplitude", "table_angle")
        for first, last in split_rows(stretch, switched[stretch])
        if first > stretch.start and free[first] and last - first >= SHORTEST_ROWS
    ]


def _decay(log: Log, before: int, last: int, site: Site, k: float) -> Decay:
    """Ring-down in the rows after `before`, the last row with the drive on. The amplitude is led to
    the rows' ends, a control period after it was detected."""
    free = slice(before + 1, last)
    if np.ptp(log.table_angle[before:last]) > AT_REST:
        raise BenchError(
            f"{log.source}: the table turns by {np.ptp(log.table_angle[free]) / DEG:.3g} deg in "
            f"the ring-down that begins at {log.time[before]:g} s; it must rest"
        )
    if np.min(log.amplitude[free]) <= 0:
        raise BenchError(f"{log.source}: amplitude 0 or less after {log.time[before]:g} s")
    turned = -k * (log.gyro_angle[before:last] - log.gyro_angle[before])
    since = np.diff(log.amplitude[before:last]) * CONTROL_PERIOD / log.interval
    return Decay(
        source=log.source,
        interval=log.interval,
        time=log.time[free] - log.time[before],
        turned=turned[1:],
        amplitude=log.amplitude[free] + since,
        # averaged over the digits of all rows
        angle_at_start=float(np.mean(log.wave_angle[before:last] - turned)),
        rotation=site.vertical_rate * float(np.mean(log.axis_up[free])),
    )


@dataclass(frozen=True)
class Gyro:
    """Known parameters of the gyro that a ring-down depends on.

    Attributes:
        k: Bryan factor.
        pickoff: g + i d.
    """

    k: float
    pickoff: complex = 0j

    def orbit(self, decay: Decay, terms: Array) -> tuple[Array, Array]:
        """Angle and logarithm of the amplitude as the log shows them."""
        g, d = self.pickoff.real, self.pickoff.imag
        seen = 4 * decay.angle_at_start
        start = decay.angle_at_start + (g * np.sin(seen) - d * (1 + np.cos(seen))) / 4
        return describe_shell(terms).orbit(
            decay.time, start, -self.k * decay.rotation, self.pickoff
        )


def fit_decays(decays: Sequence[Decay], gyro: Gyro, start: Array) -> Fit:
    """Terms `TERMS` that all ring-downs have in common, by Gauss and Newton.

    `start` has (5,) terms to begin with.
    """
    terms = _nearby(decays, gyro, start)
    for _ in range(ROUNDS):
        try:
            step = fit_rows(
                [part for decay in decays for part in _parts(decay, gyro, terms)], TERMS
            )
        except ValueError as error:
            raise BenchError(f"{decays[0].source}: ring-down: {error}") from error
        terms = terms + step.values
        if _is_settled(step):
            return replace(step, values=terms)
    raise BenchError(
        f"{decays[0].source}: the fit of the ring-down did not settle in {ROUNDS} steps"
    )


def _is_settled(step: Fit) -> bool:
    size = np.sqrt(np.diag(step.covariance))
    if np.all(np.abs(step.values) < 1e-13):
        return True
    values, correlation = step.values / size, step.covariance / np.outer(size, size)
    return float(values @ np.linalg.pinv(correlation) @ values) < CONVERGENCE_SHARE**2


def _nearby(decays: Sequence[Decay], gyro: Gyro, start: Array) -> Array:
    """Terms near the solution, all readings alike. The quadrature force before the ring-down shows
    but one part of the split; the other part is tried both ways."""

    def left(terms: Array) -> Array:
        orbits = [gyro.orbit(decay, terms) for decay in decays]
        pairs = zip(orbits, decays, strict=True)
        parts = ((o[0] - d.angle, o[1] - np.log(d.amplitude)) for o, d in pairs)
        return np.concatenate([part for both in parts for part in both])

    across = np.array([0.0, 0.0, 0.0, -start[4], start[3]])
    # gradients are as small as the readings' noise, and say nothing of the end
    tried = [
        least_squares(left, start + share * across, x_scale=SCALES, gtol=None)
        for share in (0.0, 1.0, -1.0)
    ]
    return np.asarray(min(tried, key=lambda result: float(result.cost)).x)


def _parts(decay: Decay, gyro: Gyro, terms: Array) -> list[Part]:
    """Increments of angle and of the amplitude's logarithm, less what the terms explain."""
    seen = (decay.angle, np.log(decay.amplitude))
    weight = decay.amplitude[1:]  # noises of drives and pick-offs count over the amplitude
    up, down = (
        [gyro.orbit(decay, terms + sign * step) for step in np.diag(SCALES)] for sign in (1.0, -1.0)
    )
    parts = []
    for i, expected in enumerate(gyro.orbit(decay, terms)):
        columns = {
            name: weight * np.diff(up[j][i] - down[j][i]) / (2 * SCALES[j])
            for j, name in enumerate(TERMS)
        }
        left = weight * np.diff(seen[i] - expected)
        parts.append(Part(columns, left, decay.interval, CHANNELS[i]))
    return parts


def describe_shell(terms: Array) -> FreeShell:
    """The shell that the terms, in their order, describe."""
    decay, *rest = (float(value) for value in terms)
    return FreeShell(decay, complex(rest[0], rest[1]), complex(rest[2], rest[3]))
