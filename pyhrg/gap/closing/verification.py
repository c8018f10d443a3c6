"""How far closing shrinks the gap: residuals of the output angle beside their noise floor."""

import math
from collections.abc import Sequence

import numpy as np
from scipy.stats import chi2

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.findings.diagnosis import Gap, GapFigure
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.campaign_noise import adapt_to_rows, whiten_finite
from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise

SEED = 1
"""Seed of the noise draws that make the floor."""
RATE_WINDOW = 100.0
"""Time over which the rate residual is taken, s: the campaign format's."""
NOISE_DRAWS = 200
"""Number of noise draws that make the floor and its 95 % interval. Chosen."""
AREA_QUANTILES = 500
"""Quantiles between which the area of two distributions is summed. Chosen."""
MAX_LAG = 10
"""Number of lags of the portmanteau test for whiteness, rows. Chosen."""


def compute_gap_figures(
    tests: Sequence[ObservedTest],
    before: Sequence[Array],
    after: Sequence[Array],
    noise: NoiseModel,
) -> Gap:
    """Residuals before and after closing with the noise floor, on fitted and on held-out tests.

    Residuals are (n,) of the output angle in each test, rad; NaN is left out. The floor is that of
    the identified noise of the output angle.
    """

    def figures(is_holdout: bool) -> tuple[GapFigure, GapFigure | None]:
        own = [i for i, t in enumerate(tests) if t.test.is_holdout == is_holdout]
        chosen = [tests[i] for i in own]
        ends = [measure_distance(chosen, [r[i] for i in own]) for r in (before, after)]
        floor = estimate_noise_floor(chosen, noise, SEED)
        angle, rate = _make_figures([*ends, *floor], [ARCSEC, DEG_PER_H])
        return angle, rate if math.isfinite(rate.before) else None

    held_out = [i for i, t in enumerate(tests) if t.test.is_holdout]
    if not held_out:
        return Gap(*figures(False), None, None, None, None)
    angle, rate = figures(True)
    chosen, residuals = [tests[i] for i in held_out], [after[i] for i in held_out]
    whiteness = compute_whiteness(chosen, residuals, noise)
    ends = [np.concatenate([stage[i] for i in held_out]) for stage in (before, after)]
    (area,) = _make_figures(list(measure_areas(chosen, ends, noise, SEED)), [ARCSEC])
    shrink = None  # docs/methods/verdict.md, Eq. (5); None where there is no excess over the floor
    if angle.before > angle.floor_95[1]:
        shrink = 100 * (angle.before - angle.after) / (angle.before - angle.floor)
    return Gap(*figures(False), angle, rate, shrink, whiteness, area)


def _make_figures(rows: Sequence[Array], units: Sequence[float]) -> list[GapFigure]:
    """Figures by column of (5, m) values before and after, and of three quantiles of the floor."""
    columns = (np.array(rows) / units).T.tolist()
    return [GapFigure(b, a, median, (low, high)) for b, a, low, median, high in columns]


def measure_distance(tests: Sequence[ObservedTest], residuals: Sequence[Array]) -> Array:
    """(2,) root mean square of residuals of the output angle, (n,) rad in each test, and of the
    rate residual over 100 s, rad/s (docs/methods/verdict.md, Eq. (4)); NaN is left out."""
    rates = [_compute_rates(t, r) for t, r in zip(tests, residuals, strict=True)]
    return np.array([_compute_rms(np.concatenate(residuals)), _compute_rms(np.concatenate(rates))])


def estimate_noise_floor(tests: Sequence[ObservedTest], noise: NoiseModel, seed: int) -> Array:
    """(3, 2) distances that noise of the output angle alone would leave of a perfect simulation:
    quantiles of 2.5, 50 and 97.5 % over draws of the noise."""
    generator = np.random.default_rng(seed)
    draws = [
        measure_distance(tests, [_draw_angle(t, noise, generator) for t in tests])
        for _ in range(NOISE_DRAWS)
    ]
    return np.asarray(np.quantile(draws, (0.025, 0.5, 0.975), axis=0))


def measure_areas(
    tests: Sequence[ObservedTest], residuals: Sequence[Array], noise: NoiseModel, seed: int
) -> Array:
    """(m + 3, 1) area validation metric of m residuals of the output angle in all tests together,
    rad, and quantiles of 2.5, 50 and 97.5 % of what noise alone would leave.

    The metric is the area between the distribution of a residual's rows and that of the noise, all
    draws together (S. Ferson, W. L. Oberkampf, L. Ginzburg, 2008; docs/methods/verdict.md,
    Eq. 11). NaN is left out.
    """
    generator = np.random.default_rng(seed)
    draws = [
        np.concatenate([_draw_angle(test, noise, generator) for test in tests])
        for _ in range(NOISE_DRAWS)
    ]
    shares = (np.arange(AREA_QUANTILES) + 0.5) / AREA_QUANTILES
    expected = np.nanquantile(np.concatenate(draws), shares)
    areas = [
        float(np.mean(np.abs(np.nanquantile(own, shares) - expected)))
        for own in (*residuals, *draws)
    ]
    count = len(residuals)
    floor = np.quantile(areas[count:], (0.025, 0.5, 0.975))
    return np.array([*areas[:count], *floor])[:, None]


def compute_whiteness(
    tests: Sequence[ObservedTest], residuals: Sequence[Array], noise: NoiseModel
) -> float:
    """p-value of the Ljung-Box test that whitened residuals of the output angle, (n,) rad in each
    test, are uncorrelated (docs/methods/verdict.md, Eq. (6); G. M. Ljung, G. E. P. Box, Biometrika
    65 (1978)); NaN is left out."""
    statistic, degrees = 0.0, 0
    for test, residual in zip(tests, residuals, strict=True):
        white = whiten_finite(noise, "gyro_angle", test, residual[:, None])[:, 0]
        n, power = len(white), float(white @ white)
        for lag in range(1, min(MAX_LAG, n - 1) + 1):
            correlation = float(white[lag:] @ white[:-lag]) / power
            statistic += n * (n + 2) * correlation**2 / (n - lag)
            degrees += 1
    return float(chi2.sf(statistic, degrees))


def _compute_rates(test: ObservedTest, residual: Array) -> Array:
    rows = max(1, round(RATE_WINDOW / test.log.interval))
    return np.asarray(np.diff(residual[::rows]) / (rows * test.log.interval))


def _compute_rms(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else float("nan")


def _draw_angle(test: ObservedTest, noise: NoiseModel, generator: np.random.Generator) -> Array:
    """(n,) output angle of noise alone, rad; NaN in rows that are not compared."""
    own = adapt_to_rows(noise, "gyro_angle", test)
    angle = draw_noise(own, len(test.log.time), test.log.interval, generator)
    return np.where(test.rows["gyro_angle"], angle, np.nan)
