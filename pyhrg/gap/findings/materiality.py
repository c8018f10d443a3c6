"""What causes make in the records, and what they leave: significance is not importance.

A cause may be there beyond doubt and still be worth nothing (docs/methods/verdict.md, Eq. (10)).
"""

import math
from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Sizes
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.residuals import compute_residuals
from pyhrg.gap.findings.diagnosis import Gap, GapFigure, Worth
from pyhrg.gap.replay.observations import CHANNELS

MIN_RATE_TIME = 600.0
"""Shortest test over which a mean rate is taken, s. Chosen."""
MIN_EXCESS_RATIO = 1.2
"""Residual over the upper end of the noise floor above which it is an excess. Chosen: the
uncertainty of identified parameters is no part of the floor. That of the latitude adds 7 and 21 %
in two campaigns of the challenge."""

IMMATERIAL = Worth(angle_arcsec=0.1, rate_deg_h=1e-4, loop_share=1e-3)
"""Bound below which a cause does not matter, unless the user states another. Chosen: 1e-4 deg/h
is 0.01 nmi after an hour by the usual rule; 1e-3 is a tenth of a percent of what loops hold."""


def measure_leftover(attribution: Attribution, gap: Gap) -> Worth:
    """What candidate terms explain, an unnamed noise makes, and closing leaves beyond the noise
    floor."""
    best = attribution.posterior.best
    effects: Sizes = dict(best.effect_sizes.items())
    terms = _measure(attribution, effects, best.sizes)
    figures = [f for f in (gap.fit_angle_arcsec, gap.holdout_angle_arcsec) if f is not None]
    excess = [compute_excess(figure) for figure in figures]
    noise_angle, noise_rate = measure_unnamed_noise(attribution.noise)
    return Worth(
        max(terms.angle_arcsec, noise_angle / ARCSEC, *excess),
        max(terms.rate_deg_h, noise_rate / DEG_PER_H),
        terms.loop_share,
        terms.loop_channel,
    )


def compute_excess(figure: GapFigure) -> float:
    """Residual beyond the noise floor, in quadrature, arcsec; 0 where noise and the uncertainty of
    the identified device explain it."""
    floor = MIN_EXCESS_RATIO * figure.floor_95[1]
    return math.sqrt(max(figure.after**2 - floor**2, 0.0))


def measure_effect(attribution: Attribution, effect: Effect, size: Array) -> Worth:
    """What an effect of a (d,) size makes, the pattern seen as it was measured."""
    return _measure(attribution, {}, {effect: size})


def _measure(attribution: Attribution, before: Sizes, after: Sizes) -> Worth:
    """What the groups make that are removed in `after`, and not in `before`."""
    by_channel = _compute_responses(attribution, before, after)
    nominal = attribution.nominal
    scales = {
        "amplitude": nominal.amplitude,
        "amplitude_force": 1 / nominal.decay_time,
        "quadrature_force": nominal.amplitude / nominal.decay_time,
        "frequency_offset": 1e-4 * nominal.frequency,
    }
    angles = by_channel["gyro_angle"]
    rates = [
        abs(float(angle[-1] - angle[0]) / float(time[-1] - time[0]))
        for time, angle in angles
        if len(time) > 1 and time[-1] - time[0] >= MIN_RATE_TIME
    ]
    shares = {name: _find_largest_rms(by_channel[name]) / scale for name, scale in scales.items()}
    channel = max(shares, key=lambda name: shares[name])
    return Worth(
        _find_largest_rms(angles) / ARCSEC,
        max(rates, default=0.0) / DEG_PER_H,
        shares[channel],
        channel,
    )


def measure_unnamed_noise(noise: NoiseHypothesis) -> tuple[float, float]:
    """Standard deviation of a noise that the catalogue lacks, in the angle, rad, and in the mean
    rate over `MIN_RATE_TIME`, rad/s. The noise floor holds it, so nothing else shows it."""
    if not noise.unnamed:
        return 0.0, 0.0
    correlated = noise.unnamed.correlated
    if not correlated.of_rate:
        return correlated.level, 0.0
    return 0.0, correlated.level * min(math.sqrt(2 * correlated.lag / MIN_RATE_TIME), 1.0)


def _compute_responses(
    attribution: Attribution, before: Sizes, after: Sizes
) -> Mapping[str, list[tuple[Array, Array]]]:
    """Times and response of what is removed between two residuals, by channel, for each test."""
    noise = attribution.channel_noise
    ends = [compute_residuals(attribution.parts, removed, noise) for removed in (before, after)]
    responses: dict[str, list[tuple[Array, Array]]] = {name: [] for name in CHANNELS}
    for first, last in zip(*ends, strict=True):
        responses[first.channel].append((first.times, first.values - last.values))
    return responses


def _find_largest_rms(tests: list[tuple[Array, Array]]) -> float:
    """Rms in the test where it is largest: tests that do not excite a cause make it no smaller."""
    return max((float(np.sqrt(np.mean(v**2))) for _, v in tests if len(v)), default=0.0)
