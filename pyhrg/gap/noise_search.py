"""Which noise of the output angle goes beyond the believed one, with its level integrated out."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from pyhrg.gap.catalogue import NOISES, NoiseEffect
from pyhrg.gap.equivalents import ALIKE
from pyhrg.gap.whitening import SlowNoise, whitened

Array = NDArray[np.float64]

PARTS = {
    "angle_random_walk": "walk",
    "rate_random_walk": "rate_walk",
    "bias_instability": "flicker",
    "pickoff_noise": "white",
}
"""Part of `SlowNoise` by field of a device."""
RANGE = (1e-3, 1e3)
"""Levels of an added noise over its usual size; flat in the logarithm between them."""
PRIOR_ODDS = 0.05
"""That a noise takes part."""
LEVELS = ("walk", "white")
TOLERANCE = 0.03
"""By which a believed level may be off without being a gap, one sigma of its logarithm."""
SAME_LEVEL = 0.02
PASSES = 2
"""Of levels that are found each beside the others."""
NORMAL_95 = 1.96
CURVATURE = 0.1
"""Step of the logarithm by which the likelihood's curvature is taken."""


@dataclass(frozen=True)
class AngleRecord:
    """What is left of an output angle when all that is explained is taken out.

    angle: (n,) rad.
    steps: (n,) time from the reading before, s.
    """

    angle: Array
    steps: Array


@dataclass(frozen=True)
class AddedNoise:
    """A noise beyond the believed ones.

    total: its level, believed part included, SI.
    interval: 95 %, SI.
    log_odds: that it takes part.
    log_prior: of that, what doesn't come from the records.
    equivalents: noises that in its place would be next to as probable.
    """

    effect: NoiseEffect
    total: float
    interval: tuple[float, float]
    log_odds: float
    log_prior: float
    equivalents: tuple[str, ...] = ()


@dataclass(frozen=True)
class NoiseFound:
    """The noise of the angle, and what of it is beyond belief.

    log_prior: of all that is not as believed.
    """

    noise: SlowNoise
    added: tuple[AddedNoise, ...]
    log_prior: float = 0.0


def noise_found(records: Sequence[AngleRecord], believed: SlowNoise) -> NoiseFound:
    """Add noises one by one while the odds are for them.

    Args:
        records: of all tests.
        believed: noise of the angle.
    """
    added: list[AddedNoise] = []
    for _ in PARTS:
        noise = _settled(records, believed, added)
        best = _best(records, noise, believed, added)
        if best is None or best.log_odds < 0:
            break
        added = _anew(records, believed, [*added, best])
    noise = _settled(records, believed, added)
    log_prior = sum(a.log_prior for a in added) + _log_prior(noise, believed, added)
    return NoiseFound(noise, tuple(added), log_prior)


def told_apart(
    found: NoiseFound, records: Sequence[AngleRecord], believed: SlowNoise
) -> NoiseFound:
    """Noises with those that the records can't tell from them.

    Args:
        found: in the records.
        records: of all tests.
        believed: noise of the angle.
    """
    added = [
        replace(a, equivalents=_equivalents(records, believed, a, found.added)) for a in found.added
    ]
    return replace(found, added=tuple(added))


def _equivalents(
    records: Sequence[AngleRecord],
    believed: SlowNoise,
    one: AddedNoise,
    added: Sequence[AddedNoise],
) -> tuple[str, ...]:
    """Noises that the records can't tell from one of those that were added."""
    others = [a for a in added if a != one]
    noise = _settled(records, believed, others)
    base = _posterior(records, noise, believed, others)
    present = {a.effect for a in others}
    tried = [e for e in NOISES if e.field in PARTS and e not in present]
    odds = {e: _beside(records, noise, believed, base, e, others).log_odds for e in tried}
    return tuple(e.name for e in tried if e != one.effect and odds[e] > odds[one.effect] - ALIKE)


def _best(
    records: Sequence[AngleRecord],
    noise: SlowNoise,
    believed: SlowNoise,
    added: Sequence[AddedNoise],
) -> AddedNoise | None:
    """The noise that is most probably missing."""
    base = _posterior(records, noise, believed, added)
    present = {a.effect for a in added}
    found = [
        _beside(records, noise, believed, base, effect, added)
        for effect in NOISES
        if effect.field in PARTS and effect not in present
    ]
    return max(found, key=lambda a: a.log_odds, default=None)


def _beside(
    records: Sequence[AngleRecord],
    noise: SlowNoise,
    believed: SlowNoise,
    base: float,
    effect: NoiseEffect,
    added: Sequence[AddedNoise],
) -> AddedNoise:
    """One more noise. Where believed levels moved, they may have moved in its stead: it is tried
    beside unmoved ones as well."""
    unmoved = _with(believed, added)
    levels = [noise] if alike(noise, unmoved) else [noise, unmoved]
    found = [_added(records, beside, believed, base, effect, added) for beside in levels]
    return max(found, key=lambda a: a.log_odds)


def _anew(
    records: Sequence[AngleRecord], believed: SlowNoise, added: Sequence[AddedNoise]
) -> list[AddedNoise]:
    """Levels of added noises, each beside the others; without those that these make needless."""
    kept = list(added)
    for effect in [a.effect for a in added] * PASSES:
        others = [a for a in kept if a.effect != effect]
        if len(others) == len(kept):
            continue
        base = _posterior(records, _settled(records, believed, others), believed, others)
        beside = _settled(records, believed, kept)
        again = _added(records, beside, believed, base, effect, others)
        kept = [*others, again] if again.log_odds >= 0 else others
    return kept


def alike(one: SlowNoise, other: SlowNoise) -> bool:
    """Whether levels differ by less than what can be told."""
    pairs = [(getattr(one, part), getattr(other, part)) for part in PARTS.values()]
    return all(abs(a - b) <= SAME_LEVEL * max(a, b) for a, b in pairs)


def log_likelihood(records: Sequence[AngleRecord], noise: SlowNoise) -> float:
    """Of records under a noise, but for a constant."""
    total = 0.0
    for record in records:
        white = whitened(record.angle[:, None], record.steps, noise)
        total -= (float((white.series**2).sum()) + white.log_determinant) / 2
    return total


def _settled(
    records: Sequence[AngleRecord], believed: SlowNoise, added: Sequence[AddedNoise]
) -> SlowNoise:
    """Believed levels as the records have them, as far as belief lets them move, with noises that
    were added at theirs."""
    noise = _with(believed, added)
    taken = {PARTS[a.effect.field] for a in added}
    for part in [p for p in LEVELS if p not in taken and getattr(believed, p) > 0] * 2:

        def misfit(x: float, part: str = part, noise: SlowNoise = noise) -> float:
            level = getattr(believed, part) * math.exp(TOLERANCE * x)
            return x**2 / 2 - log_likelihood(records, replace(noise, **{part: level}))

        best = float(minimize_scalar(misfit, bounds=(-9.0, 9.0), options={"xatol": 0.02}).x)
        level = getattr(believed, part) * math.exp(TOLERANCE * best)
        noise = replace(noise, **{part: level})
    return noise


def _with(believed: SlowNoise, added: Sequence[AddedNoise]) -> SlowNoise:
    return replace(believed, **{PARTS[a.effect.field]: a.total for a in added})


def _posterior(
    records: Sequence[AngleRecord],
    noise: SlowNoise,
    believed: SlowNoise,
    added: Sequence[AddedNoise],
    without: str = "",
) -> float:
    """Log likelihood and log prior of believed levels that no added noise has taken over."""
    return log_likelihood(records, noise) + _log_prior(noise, believed, added, without)


def _log_prior(
    noise: SlowNoise, believed: SlowNoise, added: Sequence[AddedNoise], without: str = ""
) -> float:
    """Of believed levels that moved, and that no added noise has taken over."""
    total = 0.0
    taken = {PARTS[a.effect.field] for a in added} | {without}
    for part in LEVELS:
        own = getattr(believed, part)
        if part not in taken and own > 0:
            total -= (math.log(getattr(noise, part) / own) / TOLERANCE) ** 2 / 2
    return total


def _added(
    records: Sequence[AngleRecord],
    noise: SlowNoise,
    believed: SlowNoise,
    base: float,
    effect: NoiseEffect,
    added: Sequence[AddedNoise],
) -> AddedNoise:
    part = PARTS[effect.field]
    own = getattr(believed, part)
    low, high = (math.log(effect.scale * end) for end in RANGE)

    def gain(logarithm: float) -> float:
        total = math.hypot(own, math.exp(logarithm))
        changed = replace(noise, **{part: total})
        return _posterior(records, changed, believed, added, part) - base

    grid = np.linspace(low, high, 13)
    values = [gain(x) for x in grid]
    top = int(np.argmax(values))
    bounds = (grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)])
    best = float(minimize_scalar(lambda x: -gain(x), bounds=bounds, options={"xatol": 0.01}).x)
    peak = gain(best)
    curvature = -(gain(best + CURVATURE) - 2 * peak + gain(best - CURVATURE)) / CURVATURE**2
    spread = 1 / math.sqrt(max(curvature, 1 / (high - low) ** 2))
    ends = [math.hypot(own, math.exp(best + s * NORMAL_95 * spread)) for s in (-1, 1)]
    log_prior = math.log(PRIOR_ODDS * spread * math.sqrt(2 * math.pi) / (high - low))
    total = math.hypot(own, math.exp(best))
    return AddedNoise(effect, total, (ends[0], ends[1]), peak + log_prior, log_prior)
