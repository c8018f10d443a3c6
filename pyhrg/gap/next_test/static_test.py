"""How long a gyro must rest before noises that are confounded in the records are separated.

By the divergence of their spectra (docs/methods/next_test.md, Eqs. (4), (6)).
"""

import math

from scipy.optimize import brentq, minimize_scalar

from pyhrg.common.units import HOUR
from pyhrg.device.declarations import format_effect
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_levels import LEVEL_RANGE
from pyhrg.gap.findings.diagnosis import NextTest
from pyhrg.gap.next_test.next_test import SEPARATION_SIGMA
from pyhrg.gap.next_test.noise_divergence import compute_divergence
from pyhrg.gap.whitening.whitening import NoiseModel

MIN_HOURS, MAX_HOURS = 0.1, 100.0
"""Range of durations of a static test that may be suggested, h. Chosen."""


def suggest_static_test(hypothesis: NoiseHypothesis, stated: NoiseModel) -> NextTest | None:
    """The static test that separates added noises from their equivalents, beyond the stated noise;
    None where there are no equivalents, or where `MAX_HOURS` are too few."""
    durations = [
        (_find_hours(hypothesis.noise, stated, added.effect.field, name), added, name)
        for added in hypothesis.added
        for name in added.equivalents
    ]
    if not durations or any(math.isinf(hours) for hours, _, _ in durations):
        return None
    hours, added, name = max(durations, key=lambda duration: duration[0])
    pair = f"{format_effect(added.effect.name)} from {format_effect(name)}"
    why = f"{hours:g} h of rest separate {pair} by {SEPARATION_SIGMA:g} sigma"
    return NextTest("static", why, hours)


def _fit_nearest(
    truth: NoiseModel, reduced: NoiseModel, part: str, scale: float, hours: float
) -> tuple[NoiseModel, float]:
    """The noise nearest to the truth that has a level of this part added, and its divergence."""

    def rival(logarithm: float) -> NoiseModel:
        level = math.hypot(getattr(reduced, part), scale * math.exp(logarithm))
        return reduced.at(part, level)

    bounds = (math.log(LEVEL_RANGE[0]), math.log(LEVEL_RANGE[1]))
    best = minimize_scalar(
        lambda x: compute_divergence(truth, rival(x), hours * HOUR), bounds=bounds
    )
    return rival(float(best.x)), float(best.fun)


def _find_hours(noise: NoiseModel, stated: NoiseModel, part: str, rival: str) -> float:
    """Time after which a noise is separated from the same with an equivalent of this name in the
    place of one part, whichever of the two is true, h; infinite where beyond `MAX_HOURS`."""
    effect = NOISE_EFFECTS[rival]
    rival_part = effect.field
    reduced = noise.at(part, getattr(stated, part))
    level = max(getattr(noise, part), getattr(reduced, rival_part))

    def excess(hours: float) -> float:
        nearest, forward = _fit_nearest(noise, reduced, rival_part, effect.scale, hours)
        _, backward = _fit_nearest(nearest, reduced, part, level, hours)
        return math.sqrt(2 * min(forward, backward)) - SEPARATION_SIGMA

    if excess(MAX_HOURS) < 0:
        return math.inf
    is_soon = excess(MIN_HOURS) >= 0
    hours = MIN_HOURS if is_soon else float(brentq(excess, MIN_HOURS, MAX_HOURS, xtol=0.1))
    return math.ceil(10 * hours) / 10
