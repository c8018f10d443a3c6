"""Angle random walk of records whose deterministic part was fitted, with its interval."""

from collections.abc import Sequence

import numpy as np
from scipy import stats

from pyhrg.bench.estimation.angle_fit import AngleFit, Record
from pyhrg.bench.outcome import Finding

Walk = tuple[float, float]
"""Density N^2, rad^2/s, and its degrees of freedom."""


def walk(fit: AngleFit, records: Sequence[Record]) -> Walk:
    """White rate noise of a fit, and how well it is known beside the white angle noise.

    The variance of an estimated density is the inverse of the likelihood's information, in which
    each sine of the increments counts once; one of f degrees of freedom has 2 N^4/f.
    """
    steps, differences = [], []
    for record in records:
        count = len(record.angle) - 1
        steps.append(np.full(count, record.interval))
        differences.append(2 - 2 * np.cos(np.pi * np.arange(1, count + 1) / (count + 1)))
    parts = np.array([np.concatenate(steps), np.concatenate(differences)])
    weighted = parts / (np.array([fit.rate_noise, fit.angle_noise]) @ parts)
    information = weighted @ weighted.T / 2
    share = fit.freedom / parts.shape[1]
    variance = float(np.linalg.inv(information)[0, 0]) / share
    return fit.rate_noise, 2 * fit.rate_noise**2 / variance


def walk_finding(name: str, found: Walk) -> Finding:
    """Coefficient N with its chi-square interval."""
    density, freedom = found
    high, low = np.sqrt(freedom / stats.chi2.ppf([0.025, 0.975], freedom))
    value = float(np.sqrt(density))
    n = round(freedom)
    return Finding(name, value, "deg/sqrt(h)", value * float(low), value * float(high), n)


def ratio_finding(name: str, one: Walk, other: Walk) -> Finding:
    """Ratio of two independent coefficients N, with the interval of F."""
    value = float(np.sqrt(one[0] / other[0]))
    quantiles = stats.f.ppf([0.975, 0.025], one[1], other[1])
    low, high = value / np.sqrt(quantiles)
    return Finding(name, value, "1", float(low), float(high), round(min(one[1], other[1])))
