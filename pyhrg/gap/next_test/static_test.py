"""How long a gyro must rest before noises that are confounded in the records are separated.

By the divergence of their spectra (docs/methods/next_test.md, Eqs. (4), (6)).
"""

import math
from dataclasses import dataclass

from scipy.optimize import brentq, minimize_scalar

from pyhrg.common.units import HOUR
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_levels import LEVEL_RANGE, PARTS
from pyhrg.gap.findings.diagnosis import NextTest
from pyhrg.gap.next_test.next_test import SEPARATION_SIGMA
from pyhrg.gap.next_test.noise_divergence import compute_divergence
from pyhrg.gap.whitening.whitening import NoiseModel

MIN_HOURS, MAX_HOURS = 0.1, 100.0
"""Range of durations of a static test that may be suggested, h. Chosen."""


def suggest_static_test(hypothesis: NoiseHypothesis, stated: NoiseModel) -> NextTest | None:
    """The static test that separates added noises from their equivalents.

    None where there are no equivalents, or where `MAX_HOURS` are too few.

    Args:
        hypothesis: noise of the output angle with the equivalents of its parts.
        stated: noise that the nominal gyro states.
    """
    durations = [
        (_hours(_Pair(hypothesis.noise, stated, PARTS[added.effect.field], name)), added, name)
        for added in hypothesis.added
        for name in added.equivalents
    ]
    if not durations or any(math.isinf(hours) for hours, _, _ in durations):
        return None
    hours, added, name = max(durations, key=lambda duration: duration[0])
    pair = f"{added.effect.name} from {name}"
    why = f"{hours:g} h of rest separate {pair} by {SEPARATION_SIGMA:g} sigma"
    return NextTest("static", why, hours)


@dataclass(frozen=True)
class _Pair:
    """A noise, and the same with an equivalent in the place of one part.

    part: the part that is replaced.
    rival: name of the equivalent.
    """

    noise: NoiseModel
    stated: NoiseModel
    part: str
    rival: str

    def sigmas(self, hours: float) -> float:
        """Separation after this time, in sigma, whichever of the two is true."""
        effect = NOISE_EFFECTS[self.rival]
        reduced = self.noise.at(self.part, getattr(self.stated, self.part))
        part = PARTS[effect.field]
        level = max(getattr(self.noise, self.part), getattr(reduced, part))
        rival, forward = _fit_nearest(self.noise, reduced, part, effect.scale, hours)
        _, backward = _fit_nearest(rival, reduced, self.part, level, hours)
        return math.sqrt(2 * min(forward, backward))


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


def _hours(pair: _Pair) -> float:
    """Time after which the pair is separated, h; infinite where beyond `MAX_HOURS`."""

    def excess(hours: float) -> float:
        return pair.sigmas(hours) - SEPARATION_SIGMA

    if excess(MAX_HOURS) < 0:
        return math.inf
    is_soon = excess(MIN_HOURS) >= 0
    hours = MIN_HOURS if is_soon else float(brentq(excess, MIN_HOURS, MAX_HOURS, xtol=0.1))
    return math.ceil(10 * hours) / 10
