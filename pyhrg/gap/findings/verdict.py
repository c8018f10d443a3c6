"""What a search comes to: verdict, causes with their intervals, what has no name."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.keys import Key
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.equivalents import equivalents
from pyhrg.gap.evidence.noise.noise_search import NORMAL_95, AddedNoise
from pyhrg.gap.evidence.unsteady import Unsteady
from pyhrg.gap.findings.diagnosis import Cause, Verdict

Array = NDArray[np.float64]

LIKELY = 0.5
"""Probability from which something without a name takes part."""
MENTIONED = 0.01
"""The same from which it is said what that may be."""


def judged(
    found: Attribution, effects: Sequence[Effect], rest: Sequence[Unsteady]
) -> tuple[Verdict, tuple[Cause, ...], float]:
    """Verdict, causes, and the probability that something outside the catalogue takes part.

    Args:
        found: by the search.
        effects: the catalogue.
        rest: what is left may be.
    """
    causes = [*_named(found, effects), *(_noise(found, added) for added in found.noise.added)]
    known = [1 - found.weighed.unknown_probability, *(1 - one.probability for one in rest)]
    unknown = 1 - math.prod(known)
    if unknown >= LIKELY:
        verdict: Verdict = "unexplained"
    elif not causes:
        verdict = "no_gap"
    else:
        verdict = "ambiguous" if any(c.equivalents for c in causes) else "explained"
    return verdict, tuple(causes), unknown


def _named(found: Attribution, effects: Sequence[Effect]) -> list[Cause]:
    causes = []
    best = found.ranked.best
    covariances = best.covariances
    for effect, size in best.named.items():
        total = effect.vector(found.believed) + size
        others = [e.name for e in equivalents(found.design, best, effect, effects)]
        others += found.weighed.stand_ins(effect.name)
        causes.append(
            Cause(
                effect.name,
                found.weighed.probability(effect.name, *others),
                effect.parameters(total),
                _intervals(effect, total, covariances[effect]),
                tuple(others),
            )
        )
    return causes


def _intervals(effect: Effect, vector: Array, covariance: Array) -> dict[str, tuple[float, float]]:
    """95 %, each parameter alone: a magnitude along the vector, its angle across it."""
    if not effect.periods:
        (key,) = effect.keys
        spread = NORMAL_95 * math.sqrt(float(covariance[0, 0]))
        return {key.name: _in_units(key, float(vector[0]), spread)}
    magnitude, angle = effect.keys
    length = float(np.hypot(*vector))
    along = vector / length if length else np.array([1.0, 0.0])
    across = np.array([-along[1], along[0]])
    half = math.pi / effect.periods
    spreads = [NORMAL_95 * math.sqrt(float(d @ covariance @ d)) for d in (along, across)]
    turn = min(spreads[1] / (length * effect.periods), half) if length else half
    direction = angle.to_si(effect.parameters(vector)[angle.name])
    low, high = _in_units(magnitude, length, spreads[0])
    return {magnitude.name: (max(low, 0.0), high), angle.name: _in_units(angle, direction, turn)}


def _in_units(key: Key, value: float, spread: float) -> tuple[float, float]:
    return key.from_si(value - spread), key.from_si(value + spread)


def _noise(found: Attribution, added: AddedNoise) -> Cause:
    name, key = added.effect.name, added.effect.key
    low, high = (key.from_si(end) for end in added.interval)
    others = dict.fromkeys([*added.equivalents, *found.weighed.stand_ins(name)])
    return Cause(
        name,
        found.weighed.probability(name, *others),
        {key.name: key.from_si(added.total)},
        {key.name: (low, high)},
        tuple(others),
    )


def unnamed(found: Attribution, rest: Sequence[Unsteady]) -> dict[str, float]:
    """What takes part outside the catalogue, in words, with probabilities."""
    probabilities = found.weighed.unnamed() | {one.words: one.probability for one in rest}
    return dict(
        sorted(((w, p) for w, p in probabilities.items() if p > MENTIONED), key=lambda x: -x[1])
    )
