"""How long a gyro must stand still before noises that its records leave alike are told apart.

By the divergence of their spectra: half the square of the deviations by which they part, after the
rival has had its own level fitted anew.
"""

import math
from dataclasses import dataclass

from scipy.optimize import brentq, minimize_scalar

from pyhrg.common.units import HOUR
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS
from pyhrg.gap.evidence.noise.noise_levels import PARTS, RANGE
from pyhrg.gap.evidence.noise.noise_search import NoiseFound
from pyhrg.gap.findings.diagnosis import NextTest
from pyhrg.gap.next_test.next_test import SURE
from pyhrg.gap.next_test.noise_divergence import divergence
from pyhrg.gap.whitening.whitening import SlowNoise

SHORTEST, LONGEST = 0.1, 100.0
"""Of a test, hours."""


def standing_still(found: NoiseFound, believed: SlowNoise) -> NextTest | None:
    """The static test that tells noises from those that stand for them; None where there are none,
    or where none of bearable length would.

    Args:
        found: with the noises that records can't tell from each.
        believed: noise of the angle.
    """
    told = [
        (_hours(_Pair(found.noise, believed, PARTS[added.effect.field], name)), added, name)
        for added in found.added
        for name in added.equivalents
    ]
    if not told or any(math.isinf(hours) for hours, _, _ in told):
        return None
    hours, added, name = max(told, key=lambda one: one[0])
    why = f"{hours:g} h of rest tell {added.effect.name} from {name} by {SURE:g} sigma"
    return NextTest("static", why, hours)


@dataclass(frozen=True)
class _Pair:
    """A noise and one that stands for a part of it.

    part: that is stood for.
    rival: name of what stands for it.
    """

    noise: SlowNoise
    believed: SlowNoise
    part: str
    rival: str

    def sigmas(self, hours: float) -> float:
        """By which they part, whichever is the truth."""
        effect = NOISE_EFFECTS[self.rival]
        without = self.noise.at(self.part, getattr(self.believed, self.part))
        part = PARTS[effect.field]
        own = max(getattr(self.noise, self.part), getattr(without, part))
        rival, one = _nearest(self.noise, without, part, effect.scale, hours)
        _, other = _nearest(rival, without, self.part, own, hours)
        return math.sqrt(2 * min(one, other))


def _nearest(
    truth: SlowNoise, without: SlowNoise, part: str, scale: float, hours: float
) -> tuple[SlowNoise, float]:
    """With a part of the level that comes closest to the truth, and how far that is from it."""

    def rival(logarithm: float) -> SlowNoise:
        level = math.hypot(getattr(without, part), scale * math.exp(logarithm))
        return without.at(part, level)

    bounds = (math.log(RANGE[0]), math.log(RANGE[1]))
    best = minimize_scalar(lambda x: divergence(truth, rival(x), hours * HOUR), bounds=bounds)
    return rival(float(best.x)), float(best.fun)


def _hours(pair: _Pair) -> float:
    """In which the two part by `SURE`; infinite where beyond `LONGEST`."""

    def beyond(hours: float) -> float:
        return pair.sigmas(hours) - SURE

    if beyond(LONGEST) < 0:
        return math.inf
    least = (
        SHORTEST if beyond(SHORTEST) >= 0 else float(brentq(beyond, SHORTEST, LONGEST, xtol=0.1))
    )
    return math.ceil(10 * least) / 10
