"""Changes between two groups of power-ons, with 95 % intervals."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike
from scipy import stats

from pyhrg.bench.bias.circumference import Circumference
from pyhrg.bench.outcome import Finding


def estimate_change(
    name: str, before: ArrayLike, after: ArrayLike, unit: str, note: str = ""
) -> Finding:
    """Mean of `after` less mean of `before`, with Welch's interval."""
    x, y = np.asarray(before, dtype=float), np.asarray(after, dtype=float)
    value, n = float(np.mean(y) - np.mean(x)), len(x) + len(y)
    if min(len(x), len(y)) < 2:
        reason = f"{len(x)} and {len(y)} power-ons: at least 2 each for an interval"
        return Finding(name, value, unit, n=n, note=reason)
    parts = np.array([np.var(x, ddof=1) / len(x), np.var(y, ddof=1) / len(y)])
    total = float(np.sum(parts))
    if total == 0.0:
        return Finding(name, value, unit, value, value, n, note)
    freedom = total**2 / float(np.sum(parts**2 / [len(x) - 1, len(y) - 1]))
    reach = float(stats.t.ppf(0.975, freedom)) * np.sqrt(total)
    return Finding(name, value, unit, value - reach, value + reach, n, note)


def estimate_noise_ratio(
    name: str, before: Sequence[Circumference], during: Sequence[Circumference]
) -> Finding:
    """Ratio of the fits' residual standard deviations, during over before, with an F interval."""
    m, n = (sum(run.fitted.freedom for run in runs) for runs in (before, during))
    x, y = (sum(run.noise for run in runs) / free for runs, free in ((before, m), (during, n)))
    if x <= 0:
        return Finding(name, np.nan, "1", note="no noise before")
    low, high = (np.sqrt(y / x / stats.f.ppf(p, n, m)) for p in (0.975, 0.025))
    value, size = float(np.sqrt(y / x)), sum(len(r.points) for r in (*before, *during))
    return Finding(name, value, "1", float(low), float(high), size, "of 100 s means")
