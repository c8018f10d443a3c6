"""Angle random walk from the residual of a fit to angles, with its 95 % interval."""

from collections.abc import Sequence

import numpy as np
from scipy import stats

from pyhrg.bench.estimation.angle_fit import AngleFit, Record, compute_eigenvalues
from pyhrg.bench.outcome import Finding

Walk = tuple[float, float]
"""Power spectral density N^2 of the rate noise, rad^2/s, and its degrees of freedom."""


def estimate_walk(fit: AngleFit, records: Sequence[Record]) -> Walk:
    """Rate noise of a fit with its degrees of freedom.

    The variance of the estimated density is an element of the inverse Fisher information of both
    noises, to which each sine of the increments contributes. A chi-square estimate with f degrees
    of freedom has the variance 2 N^4 / f: that gives f.
    """
    steps, differences = [], []
    for record in records:
        count = len(record.angle) - 1
        steps.append(np.full(count, record.interval))
        differences.append(compute_eigenvalues(count))
    parts = np.array([np.concatenate(steps), np.concatenate(differences)])
    weighted = parts / (np.array([fit.rate_noise, fit.angle_noise]) @ parts)
    information = weighted @ weighted.T / 2
    share = fit.freedom / parts.shape[1]
    variance = float(np.linalg.inv(information)[0, 0]) / share
    return fit.rate_noise, 2 * fit.rate_noise**2 / variance


def make_walk_finding(name: str, walk: Walk) -> Finding:
    """Angle random walk N with its chi-square interval."""
    density, freedom = walk
    high, low = np.sqrt(freedom / stats.chi2.ppf([0.025, 0.975], freedom))
    value = float(np.sqrt(density))
    n = round(freedom)
    return Finding(name, value, "deg/sqrt(h)", value * float(low), value * float(high), n)


def estimate_walk_ratio(name: str, first: Walk, second: Walk) -> Finding:
    """Ratio of two independent angle random walks N, with the interval of the F distribution."""
    value = float(np.sqrt(first[0] / second[0]))
    quantiles = stats.f.ppf([0.975, 0.025], first[1], second[1])
    low, high = value / np.sqrt(quantiles)
    return Finding(name, value, "1", float(low), float(high), round(min(first[1], second[1])))
