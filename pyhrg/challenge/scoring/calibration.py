"""Calibration of the stated probabilities."""

import math
from collections.abc import Sequence

import numpy as np

from pyhrg.challenge.scoring.figure import CONFIDENCE, RESAMPLES, Figure, Sense
from pyhrg.common.arrays import Array

BINS = 10
"""Number of bins of claims by their probability, with equal counts."""
Claims = Sequence[tuple[float, bool]]
"""Stated probability of each claim, and whether the claim is true."""


def compute_squared_error(claims: Array) -> float:
    """Mean squared calibration error of (n, 2) probabilities and outcomes over bins of equal count,
    bias-corrected. It can be negative by chance.

    In each bin the variance of the mean outcome is taken out: A. Kumar, P. Liang, T. Ma, Verified
    Uncertainty Calibration (2019), Def. 3.1.
    """
    ordered = claims[np.lexsort(claims.T[::-1])]
    total = 0.0
    for part in np.array_split(ordered, min(BINS, len(ordered) // 2)):
        given, so = part[:, 0].mean(), part[:, 1].mean()
        total += len(part) * ((given - so) ** 2 - so * (1 - so) / (len(part) - 1))
    return float(total / len(ordered))


def score_calibration(
    name: str, campaigns: Sequence[Claims], seed: int, sense: Sense, target: float
) -> Figure:
    """The root of the squared calibration error, not below zero, and its interval by resampling
    campaigns.

    The interval is the basic one of the bootstrap (A. Davison, D. Hinkley, 1997, Eq. 5.6), for the
    square: resampling repeats outcomes, which looks like an error, and that is taken out. Claims of
    one campaign are correlated, so campaigns are drawn whole.
    """
    said = [np.array(campaign, dtype=np.float64).reshape(-1, 2) for campaign in campaigns]
    claims = np.concatenate([np.empty((0, 2)), *said])
    if len(claims) < 2:
        return Figure(name, 0, math.nan, 0.0, 1.0, sense, target)
    square = compute_squared_error(claims)
    generator = np.random.default_rng(seed)
    drawn = []
    for _ in range(RESAMPLES):
        chosen = generator.integers(len(campaigns), size=len(campaigns)).tolist()
        again = np.concatenate([said[i] for i in chosen])
        drawn.append(compute_squared_error(again) if len(again) > 1 else square)
    tail = (1 - CONFIDENCE) / 2
    below, above = np.quantile(drawn, (tail, 1 - tail)).tolist()
    ends = (_root(2 * square - above), _root(2 * square - below))
    return Figure(name, len(claims), _root(square), *ends, sense, target)


def _root(square: float) -> float:
    return math.sqrt(max(0.0, square))
