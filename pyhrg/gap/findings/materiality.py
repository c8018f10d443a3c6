"""What an explanation leaves, and whether it matters: significance is not importance.

A cause that the catalogue lacks may be there beyond doubt and still be worth nothing
(docs/methods/verdict.md, Eq. (10)).
"""

import math
from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.effects.design import Sizes
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.residuals import compute_residuals
from pyhrg.gap.findings.diagnosis import Gap, Leftover
from pyhrg.gap.replay.observations import CHANNELS

MIN_RATE_TIME = 600.0
"""Shortest test over which the mean rate of what is left is taken, s. Chosen."""


IMMATERIAL = Leftover(angle_arcsec=0.1, rate_deg_h=1e-4, loop_share=1e-3)
"""Bound below which a leftover does not matter, unless the user states another. Chosen: 1e-4 deg/h
is 0.01 nmi after an hour by the usual rule; 1e-3 is a tenth of a percent of what loops hold."""


def measure_leftover(attribution: Attribution, gap: Gap) -> Leftover:
    """Size of what candidate terms explain in the test where it is largest, and of what closing
    leaves beyond the noise floor."""
    by_channel = _list_term_responses(attribution)
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
    excess = [
        math.sqrt(max(figure.after**2 - figure.floor_95[1] ** 2, 0.0)) * ARCSEC
        for figure in (gap.fit_angle_arcsec, gap.holdout_angle_arcsec)
        if figure is not None
    ]
    noise_angle, noise_rate = measure_unnamed_noise(attribution.noise)
    return Leftover(
        max(_find_largest_rms(angles), noise_angle, *excess) / ARCSEC,
        max([*rates, noise_rate]) / DEG_PER_H,
        max(_find_largest_rms(by_channel[name]) / scale for name, scale in scales.items()),
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


def _list_term_responses(attribution: Attribution) -> Mapping[str, list[tuple[Array, Array]]]:
    """Times and response of all candidate terms of the most probable set, by channel, for each
    test."""
    hypothesis = attribution.posterior.best
    noise, nominal = attribution.channel_noise, attribution.nominal
    without_terms: Sizes = dict(hypothesis.effect_sizes.items())
    ends = [
        compute_residuals(attribution.parts, removed, noise, nominal)
        for removed in (without_terms, hypothesis.sizes)
    ]
    responses: dict[str, list[tuple[Array, Array]]] = {name: [] for name in CHANNELS}
    for before, after in zip(*ends, strict=True):
        responses[before.channel].append((before.times, before.values - after.values))
    return responses


def _find_largest_rms(tests: list[tuple[Array, Array]]) -> float:
    """Rms in the test where it is largest: tests that do not excite a cause make it no smaller."""
    return max((float(np.sqrt(np.mean(v**2))) for _, v in tests if len(v)), default=0.0)
