"""How far closing shrinks the gap: residuals of the output angle beside their noise floor."""

import math
from collections.abc import Iterable, Iterator, Sequence

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

    fitted, held_out = (
        [
            (test, first, last)
            for test, first, last in zip(tests, before, after, strict=True)
            if test.test.is_holdout == is_holdout and np.isfinite(first).any()
        ]
        for is_holdout in (False, True)
    )
    chosen, *ends = zip(*fitted, strict=True)
    of_fit = _compare(chosen, ends, draw_angles(chosen, noise))
    if not held_out:
        return Gap(*of_fit, None, None, None, None)
    chosen, *ends = zip(*held_out, strict=True)
    draws = list(draw_angles(chosen, noise))
    angle, rate = _compare(chosen, ends, draws)
    whiteness = compute_whiteness(chosen, ends[1], noise)
    (area,) = _make_figures(list(measure_areas(ends, draws)), [ARCSEC])
    shrink = None  # docs/methods/verdict.md, Eq. (5); None where there is no excess over the floor
    if angle.before > angle.floor_95[1]:
        shrink = 100 * (angle.before - angle.after) / (angle.before - angle.floor)
    return Gap(*of_fit, angle, rate, shrink, whiteness, area)


def _compare(
    tests: Sequence[ObservedTest], ends: Sequence[Sequence[Array]], draws: Iterable[Sequence[Array]]
) -> tuple[GapFigure, GapFigure | None]:
    """Figures of angle and rate, from residuals before and after, and from draws of the noise."""
    distances = [measure_distance(tests, residuals) for residuals in ends]
    floor = estimate_noise_floor(tests, draws)
    angle, rate = _make_figures([*distances, *floor], [ARCSEC, DEG_PER_H])
    return angle, rate if math.isfinite(rate.before) else None


def _make_figures(rows: Sequence[Array], units: Sequence[float]) -> list[GapFigure]:
    """Figures by column of (5, m) values before and after, and of three quantiles of the floor."""
    columns = (np.array(rows) / units).T.tolist()
    return [GapFigure(b, a, median, (low, high)) for b, a, low, median, high in columns]


def measure_distance(tests: Sequence[ObservedTest], residuals: Sequence[Array]) -> Array:
    """(2,) root mean square of residuals of the output angle, (n,) rad in each test, and of the
    rate residual over 100 s, rad/s (docs/methods/verdict.md, Eq. (4)); NaN is left out."""
    rates = [_compute_rates(t, r) for t, r in zip(tests, residuals, strict=True)]
    return np.array([_compute_rms(np.concatenate(residuals)), _compute_rms(np.concatenate(rates))])


def draw_angles(
    tests: Sequence[ObservedTest], noise: NoiseModel, seed: int = SEED
) -> Iterator[list[Array]]:
    """Draws of the output angle of noise alone, (n,) rad in each test; NaN in rows that are not
    compared."""
    generator = np.random.default_rng(seed)
    for _ in range(NOISE_DRAWS):
        yield [_draw_angle(test, noise, generator) for test in tests]


def estimate_noise_floor(tests: Sequence[ObservedTest], draws: Iterable[Sequence[Array]]) -> Array:
    """(3, 2) distances that noise of the output angle alone would leave of a perfect simulation:
    quantiles of 2.5, 50 and 97.5 % over draws of the noise."""
    distances = [measure_distance(tests, draw) for draw in draws]
    return np.asarray(np.quantile(distances, (0.025, 0.5, 0.975), axis=0))


def measure_areas(ends: Sequence[Sequence[Array]], draws: Iterable[Sequence[Array]]) -> Array:
    """(m + 3, 1) area validation metric of m residuals of the output angle in all tests together,
    rad, and quantiles of 2.5, 50 and 97.5 % over draws of what noise alone would leave. A residual
    and a draw are (n,) in each test.

    The metric is the area between the distribution of a residual's rows and that of the noise, all
    draws together (S. Ferson, W. L. Oberkampf, L. Ginzburg, 2008; docs/methods/verdict.md,
    Eq. 11). NaN is left out.
    """
    residuals, of_noise = ([np.concatenate(own) for own in series] for series in (ends, draws))
    shares = (np.arange(AREA_QUANTILES) + 0.5) / AREA_QUANTILES
    expected = np.nanquantile(np.concatenate(of_noise), shares)
    areas = [
        float(np.mean(np.abs(np.nanquantile(own, shares) - expected)))
        for own in (*residuals, *of_noise)
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
