"""Which noise of the output angle goes beyond the believed one, with its level integrated out."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from pyhrg.gap.effects.catalogue import NOISES, NoiseEffect
from pyhrg.gap.evidence.equivalents import ALIKE
from pyhrg.gap.evidence.noise.nameless_noise import Nameless, likeliest
from pyhrg.gap.evidence.noise.noise_levels import (
    PARTS,
    AngleRecord,
    alike,
    level_found,
    log_likelihood,
)
from pyhrg.gap.whitening.whitening import SlowNoise

Array = NDArray[np.float64]

PRIOR_ODDS = 0.05
"""That a noise of the catalogue takes part."""
SLACK = 3.0
"""Log odds that a noise without a name may gain when all levels are found anew."""
DOUBTED = 10.0
"""Log odds below which a noise may well not be there."""
LEVELS = ("walk", "white")
"""That are believed, and may be off."""
TOLERANCE = 0.03
"""By which a believed level may be off without being a gap, one sigma of its logarithm."""
PASSES = 2
"""Of levels that are found each beside the others."""
FARTHEST = 9.0
"""Of a believed level from itself, in its tolerance."""
FINELY = 0.02
"""To which it is found, in its tolerance."""
NORMAL_95 = 1.96


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
    nameless: beside what was added.
    """

    noise: SlowNoise
    added: tuple[AddedNoise, ...]
    log_prior: float = 0.0
    nameless: Nameless | None = None

    @property
    def kind(self) -> tuple[frozenset[str], tuple[float, bool] | None]:
        """What takes part, whatever its level."""
        lasting = self.nameless.correlated.kind if self.nameless else None
        return frozenset(a.effect.name for a in self.added), lasting


def noise_found(
    records: Sequence[AngleRecord],
    believed: SlowNoise,
    noises: Sequence[NoiseEffect] = NOISES,
) -> NoiseFound:
    """Noises of the catalogue; or one that it doesn't have, alone or with some of them.

    Args:
        records: of all tests.
        believed: noise of the angle.
        noises: of the catalogue.
    """
    plain = _at_levels(records, believed, _named(records, believed, noises), None)
    beside = [(plain.noise, plain.log_prior)] + ([(believed, 0.0)] if plain.added else [])
    nameless = likeliest(records, beside)
    base = _log_posterior(records, plain)
    if nameless.log_odds < base - SLACK:
        return plain
    named = _named(records, nameless.beside(believed), noises)
    rival = _at_levels(records, believed, named, nameless)
    log_odds = _log_posterior(records, rival) - base
    return replace(rival, nameless=replace(nameless, log_odds=log_odds)) if log_odds > 0 else plain


def _log_posterior(records: Sequence[AngleRecord], found: NoiseFound) -> float:
    return log_likelihood(records, found.noise) + found.log_prior


def _named(
    records: Sequence[AngleRecord], believed: SlowNoise, noises: Sequence[NoiseEffect]
) -> tuple[AddedNoise, ...]:
    """Noises of the catalogue, one by one while the odds are for them."""
    added: list[AddedNoise] = []
    for _ in PARTS:
        noise = _settled(records, believed, added)
        best = _best(records, noise, believed, added, noises)
        if best is None or best.log_odds < 0:
            break
        added = _anew(records, believed, [*added, best])
    return tuple(added)


def doubted(
    found: NoiseFound, records: Sequence[AngleRecord], believed: SlowNoise
) -> list[NoiseFound]:
    """The same without one of its noises, for each that may well not be there.

    Args:
        found: in the records.
        records: of all tests.
        believed: noise of the angle.
    """
    fewer = [
        (tuple(a for a in found.added if a is not one), found.nameless)
        for one in found.added
        if one.log_odds < DOUBTED
    ]
    if found.nameless and found.nameless.log_odds < DOUBTED:
        fewer.append((found.added, None))
    return [_at_levels(records, believed, added, nameless) for added, nameless in fewer]


def _at_levels(
    records: Sequence[AngleRecord],
    believed: SlowNoise,
    added: tuple[AddedNoise, ...],
    nameless: Nameless | None,
) -> NoiseFound:
    """Noises, with the believed ones as the records have them beside these."""
    beside = nameless.beside(believed) if nameless else believed
    noise = _settled(records, beside, added)
    log_prior = sum(a.log_prior for a in added) + _log_prior(noise, beside, added)
    return NoiseFound(noise, added, log_prior + (nameless.log_prior if nameless else 0.0), nameless)


def told_apart(
    found: NoiseFound,
    records: Sequence[AngleRecord],
    believed: SlowNoise,
    noises: Sequence[NoiseEffect] = NOISES,
) -> NoiseFound:
    """Noises with those that the records can't tell from them.

    Args:
        found: in the records.
        records: of all tests.
        believed: noise of the angle.
        noises: of the catalogue.
    """
    if found.nameless:
        believed = found.nameless.beside(believed)
    added = [
        replace(a, equivalents=_equivalents(records, believed, a, found.added, noises))
        for a in found.added
    ]
    return replace(found, added=tuple(added))


def _equivalents(
    records: Sequence[AngleRecord],
    believed: SlowNoise,
    one: AddedNoise,
    added: Sequence[AddedNoise],
    noises: Sequence[NoiseEffect],
) -> tuple[str, ...]:
    """Noises that the records can't tell from one of those that were added."""
    others = [a for a in added if a != one]
    noise = _settled(records, believed, others)
    base = _posterior(records, noise, believed, others)
    present = {a.effect for a in others}
    tried = [e for e in noises if e.field in PARTS and e not in present]
    odds = {e: _beside(records, noise, believed, base, e, others).log_odds for e in tried}
    return tuple(e.name for e in tried if e != one.effect and odds[e] > odds[one.effect] - ALIKE)


def _best(
    records: Sequence[AngleRecord],
    noise: SlowNoise,
    believed: SlowNoise,
    added: Sequence[AddedNoise],
    noises: Sequence[NoiseEffect],
) -> AddedNoise | None:
    """The noise that is most probably missing."""
    base = _posterior(records, noise, believed, added)
    present = {a.effect for a in added}
    found = [
        _beside(records, noise, believed, base, effect, added)
        for effect in noises
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


def _settled(
    records: Sequence[AngleRecord], believed: SlowNoise, added: Sequence[AddedNoise]
) -> SlowNoise:
    """Believed levels as the records have them, as far as belief lets them move, with noises that
    were added at theirs."""
    noise = _with(believed, added)
    taken = {PARTS[a.effect.field] for a in added}
    for part in [p for p in LEVELS if p not in taken and getattr(believed, p) > 0] * PASSES:

        def misfit(x: float, part: str = part, noise: SlowNoise = noise) -> float:
            level = getattr(believed, part) * math.exp(TOLERANCE * x)
            return x**2 / 2 - log_likelihood(records, noise.at(part, level))

        best = float(
            minimize_scalar(misfit, bounds=(-FARTHEST, FARTHEST), options={"xatol": FINELY}).x
        )
        level = getattr(believed, part) * math.exp(TOLERANCE * best)
        noise = noise.at(part, level)
    return noise


def _with(believed: SlowNoise, added: Sequence[AddedNoise]) -> SlowNoise:
    noise = believed
    for one in added:
        noise = noise.at(PARTS[one.effect.field], one.total)
    return noise


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

    def gain(logarithm: float) -> float:
        total = math.hypot(own, math.exp(logarithm))
        changed = noise.at(part, total)
        return _posterior(records, changed, believed, added, part) - base

    level = level_found(gain, effect.scale)
    low, total, high = (
        math.hypot(own, math.exp(level.logarithm + s * NORMAL_95 * level.deviation))
        for s in (-1, 0, 1)
    )
    log_prior = level.log_prior(PRIOR_ODDS)
    return AddedNoise(effect, total, (low, high), level.gain + log_prior, log_prior)
