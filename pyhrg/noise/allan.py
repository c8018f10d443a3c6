"""Allan deviation of a rate or angle record, with intervals."""

import sys
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike
from scipy.stats import chi2

from pyhrg.common.arguments import check_number, check_whole_number
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.noise.coefficients import CONFIDENCE
from pyhrg.noise.fitting import check_record, maximize_likelihood
from pyhrg.noise.likelihood import compute_spectrum

CORRELATION_CLUSTERS = 16
"""Lag, in cluster times, beyond which second differences of flicker noise count as independent.
Chosen."""


@dataclass(frozen=True)
class AllanDeviation:
    """Overlapping Allan deviation at m cluster times, with a 95 % interval at each.

    Attributes:
        tau: (m,) cluster times, s.
        deviation: (m,) rad/s.
        low: (m,) lower end of the interval, rad/s.
        high: (m,) upper end of the interval, rad/s.
        freedom: (m,) equivalent degrees of freedom.
        n: number of angles.
    """

    tau: Array
    deviation: Array
    low: Array
    high: Array
    freedom: Array
    n: int

    def up_to(self, tau: float) -> "AllanDeviation":
        """The part with cluster times up to `tau`, s."""
        is_kept = self.tau <= tau
        names = ("tau", "deviation", "low", "high", "freedom")
        return replace(self, **{name: getattr(self, name)[is_kept] for name in names})


def estimate_allan_deviation(angle: Array, interval: float, per_octave: int = 4) -> AllanDeviation:
    """Overlapping Allan deviation of the rate, from the angle itself (IEEE Std 952, annex C).

    An interval is that of a chi-squared variance, with the degrees of freedom that the second
    differences have under the noises estimated from the record (C. Greenhall, W. Riley, Uncertainty
    of stability variances based on finite differences, PTTI 2003; there for one power law at a
    time). It holds for the noises; a rate ramp adds to the deviation and is not random. Angles are
    (n,) rad, evenly spaced without gaps, `interval` seconds apart; there are `per_octave` cluster
    times in a factor of two, where whole multiples of the interval allow.
    """
    check_record(angle, interval)
    strengths = maximize_likelihood([compute_spectrum(angle)])
    clusters = _choose_clusters(len(angle) // 3, per_octave)
    deviation = np.array([_estimate_deviation(angle, m) for m in clusters]) / (clusters * interval)
    freedom = np.array([_compute_freedom(strengths, len(angle) - 2 * m, m) for m in clusters])
    tail = (1 - CONFIDENCE) / 2
    return AllanDeviation(
        tau=clusters * interval,
        deviation=deviation,
        low=deviation * np.sqrt(freedom / chi2.isf(tail, freedom)),
        high=deviation * np.sqrt(freedom / chi2.ppf(tail, freedom)),
        freedom=freedom,
        n=len(angle),
    )


def allan_deviation(
    values: ArrayLike,
    interval_s: float,
    *,
    kind: Literal["rate", "angle"] = "rate",
    per_octave: int = 4,
) -> pd.DataFrame:
    """Overlapping Allan deviation of the rate (IEEE Std 952, annex C), with 95 % intervals.

    Args:
        values: (n,) evenly spaced values without gaps, in any unit: means of the rate over each
            interval, or angles.
        interval_s: sampling interval, s.
        kind: whether the values are rates or angles.
        per_octave: number of cluster times per factor of two; fewer where whole multiples of the
            interval are fewer.

    Returns:
        Columns `cluster_time_s`, `deviation`, `low_95`, `high_95` and `degrees_of_freedom`.
        `attrs["units"]` says each one's unit; that of the deviations is the unit of the rates, or
        that of the angles over s: as `values.attrs["units"]` has it, or else in words.

    Raises:
        HrgError: an argument is out of range, or the values are no record of at least 256 finite
            numbers with noise in it (the message says which).
    """
    if kind not in ("rate", "angle"):
        raise HrgError(f"kind: found {kind!r}, expected 'rate' or 'angle'")
    check_number("interval_s", interval_s, sys.float_info.min, sys.float_info.max)
    check_whole_number("per_octave", per_octave, 1, 100)
    series = np.asarray(values, dtype=np.float64)
    if series.ndim != 1 or not np.isfinite(series).all():
        found = f"shape {series.shape}" if series.ndim != 1 else "a value that is not finite"
        raise HrgError(f"values: found {found}, expected finite numbers in one row, without gaps")
    if kind == "rate":
        series = interval_s * np.append(0.0, np.cumsum(series))
    estimate = estimate_allan_deviation(series, interval_s, per_octave)
    names = ("cluster_time_s", "deviation", "low_95", "high_95", "degrees_of_freedom")
    columns = (estimate.tau, estimate.deviation, estimate.low, estimate.high, estimate.freedom)
    frame = pd.DataFrame(dict(zip(names, columns, strict=True)))
    unit = getattr(values, "attrs", {}).get("units", f"unit of the {kind}s")
    rate = f"{unit}/s" if kind == "angle" else unit
    frame.attrs["units"] = dict(zip(names, ("s", rate, rate, rate, "1"), strict=True))
    return frame


def _choose_clusters(largest: int, per_octave: int) -> Array:
    steps = np.arange(np.floor(per_octave * np.log2(largest)) + 1)
    return np.unique(np.round(2 ** (steps / per_octave)).astype(int))


def _estimate_deviation(angle: Array, m: int) -> float:
    """Allan deviation times the cluster time, rad."""
    second = angle[2 * m :] - 2 * angle[m:-m] + angle[: -2 * m]
    return float(np.sqrt(np.mean(second**2) / 2))


def _compute_freedom(strengths: Array, count: int, m: int) -> float:
    """Equivalent degrees of freedom of the mean square of `count` overlapping second differences.

    Strengths of the noises are (4,) rad^2; a cluster has m angles.
    """
    lag = np.arange(min(count, CORRELATION_CLUSTERS * m), dtype=np.float64)
    covariance = sum(
        weight * _compute_covariance(strengths, lag + shift * m)
        for shift, weight in zip((-2, -1, 0, 1, 2), (1, -4, 6, -4, 1), strict=True)
    )
    square = (covariance / np.max(np.abs(covariance))) ** 2
    return float(count**2 * square[0] / (2 * (count - lag) @ square - count * square[0]))


def _compute_covariance(strengths: Array, lag: Array) -> Array:
    """Generalized covariance of the angle, rad^2: transforms of the densities omega^-p."""
    t = np.abs(lag)
    kernels = [t == 0, -t / 2, t**2 * np.log(np.maximum(t, 1)) / (2 * np.pi), t**3 / 12]
    return np.asarray(strengths @ np.array(kernels))
