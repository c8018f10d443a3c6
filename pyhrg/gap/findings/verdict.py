"""Verdict, causes with their 95 % intervals, and what takes part outside the catalogue.

Method: docs/methods/verdict.md.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.toml_table import Key
from pyhrg.gap.effects.catalogue import EFFECTS, Effect
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.equivalence.hidden_effects import find_hidden_effects
from pyhrg.gap.evidence.equivalence.known_equivalents import find_known_equivalents
from pyhrg.gap.evidence.evidence import find_equivalents
from pyhrg.gap.evidence.hypothesis import compute_sigma_along
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95, AddedNoise
from pyhrg.gap.evidence.residual_features import (
    ResidualFeature,
    compute_checked_residuals,
    find_residual_features,
)
from pyhrg.gap.findings.diagnosis import Cause, KnownValue, Verdict
from pyhrg.gap.findings.materiality import measure_effect

UNEXPLAINED_PROBABILITY = 0.5
"""The verdict is `unexplained` where something outside the catalogue takes part with at least this
probability, more probable than not, and is material (`materiality`)."""
BEYOND_PROBABILITY = 0.975
"""A known parameter, or a fault of bench or record, is a cause where it exceeds its tolerance with
more than this probability: its 95 % interval lies beyond."""
MENTIONED_PROBABILITY = 0.01
"""What may take part outside the catalogue is listed above this probability. Chosen."""


def check_residuals(attribution: Attribution) -> tuple[ResidualFeature, ...]:
    """Lines and stretches of other noise in the residuals of the most probable hypothesis."""
    best = attribution.posterior.best
    return find_residual_features(compute_checked_residuals(best, best.sizes, attribution.parts))


def reach_verdict(
    attribution: Attribution,
    effects: Sequence[Effect],
    faults: Sequence[Cause],
    features: Sequence[ResidualFeature],
    is_material: bool,
    is_contradicted: bool,
) -> tuple[Verdict, tuple[Cause, ...], float]:
    """Verdict, causes among the effects of the catalogue and the noises, then the faults of bench
    and record, and the probability that something outside the catalogue takes part (Eq. (1)), which
    counts for the verdict only if it is material. Features are what the residuals may show besides
    steady noise. Held-out tests may contradict the causes."""
    causes = [
        *_find_effect_causes(attribution, effects),
        *_find_known_causes(attribution, effects),
        *(_make_noise_cause(attribution, added) for added in attribution.noise.added),
        *faults,
    ]
    absent = [1 - attribution.posterior.unknown_probability, *(1 - f.probability for f in features)]
    unknown = 1 - math.prod(absent)
    if unknown >= UNEXPLAINED_PROBABILITY and is_material:
        verdict: Verdict = "unexplained"
    elif not causes:
        verdict = "no_gap"
    else:
        is_open = is_contradicted or any(map(_is_confounded, causes))
        verdict = "ambiguous" if is_open else "explained"
    return verdict, tuple(causes), unknown


def _is_confounded(cause: Cause) -> bool:
    """Whether another test could name the cause alone: its equivalents are more than the errors of
    the bench that do the same in every test."""
    return not set(cause.equivalents) <= set(_list_imitators(cause.effect))


def _list_imitators(*names: str) -> tuple[str, ...]:
    """Errors of the bench that do the same as one of these in every test."""
    return tuple(other for name in names if name in EFFECTS for other in EFFECTS[name].imitators)


def _find_effect_causes(attribution: Attribution, effects: Sequence[Effect]) -> list[Cause]:
    causes = []
    best, posterior, nominal = attribution.ranking.best, attribution.posterior, attribution.nominal
    known = posterior.best.exact
    hidden = find_hidden_effects(attribution.design, best, effects)
    for effect, size in best.named.items():
        if effect in known.effects:
            continue
        total = effect.vector(nominal) + size
        others = [e.name for e in find_equivalents(attribution.design, best, effect, effects)]
        others += posterior.list_equivalents(effect.name)
        others += find_known_equivalents(known, best, nominal, effect, known.effects)
        others += [h.effect.name for h in hidden if effect in h.shifted]
        others += attribution.ranking.list_replacements(effect)
        others = list(dict.fromkeys(others))
        imitators = _list_imitators(effect.name, *others)
        causes.append(
            Cause(
                effect.name,
                posterior.probability(effect.name, *others),
                effect.parameters(total),
                compute_intervals(effect, total, partial(posterior.compute_sigma, effect, size)),
                (*others, *(name for name in imitators if name not in others)),
                worth=measure_effect(attribution, effect, size),
            )
        )
    return causes


def _find_known_causes(attribution: Attribution, effects: Sequence[Effect]) -> list[Cause]:
    """Known parameters whose 95 % interval lies beyond their tolerance."""
    causes = []
    posterior, nominal = attribution.posterior, attribution.nominal
    best = posterior.best
    known, fitted = best.exact, best.ranking.best
    for effect, (size, covariance) in best.departures.items():
        total = effect.vector(nominal) + size
        probability = posterior.compute_beyond(effect, effect.tolerance_of(nominal))
        if probability > BEYOND_PROBABILITY:
            intervals = compute_intervals(
                effect, total, partial(compute_sigma_along, covariance=covariance)
            )
            values, candidates = effect.parameters(total), (*effects, *known.effects)
            others = find_known_equivalents(known, fitted, nominal, effect, candidates)
            others = (*others, *_list_imitators(effect.name, *others))
            others = tuple(dict.fromkeys(others))
            worth = measure_effect(attribution, effect, size)
            causes.append(
                Cause(effect.name, probability, values, intervals, others, effect.family, worth)
            )
    return causes


def list_tolerated_sizes(attribution: Attribution) -> dict[Effect, Array]:
    """Departures of the known parameters that are not shown to exceed their tolerance, SI."""
    posterior, nominal = attribution.posterior, attribution.nominal
    return {
        effect: size
        for effect, size in posterior.best.known_sizes.items()
        if posterior.compute_beyond(effect, effect.tolerance_of(nominal)) <= BEYOND_PROBABILITY
    }


def list_known_values(attribution: Attribution) -> tuple[KnownValue, ...]:
    """Known parameters that are significantly off, but not shown to exceed their tolerance."""
    values = []
    nominal, departures = attribution.nominal, attribution.posterior.best.departures
    for effect, size in list_tolerated_sizes(attribution).items():
        if effect not in departures:
            continue
        _, covariance = departures[effect]
        stated, key = effect.vector(nominal), effect.keys[0]
        total = stated + size
        parameters = effect.parameters(total)
        sigma = partial(compute_sigma_along, covariance=covariance)
        values.append(
            KnownValue(
                effect.name,
                effect.family,
                key.name,
                parameters[key.name],
                effect.parameters(stated)[key.name],
                compute_intervals(effect, total, sigma)[key.name],
                effect.tolerance_of(nominal) / key.factor,
                parameters,
            )
        )
    return tuple(values)


def compute_intervals(
    effect: Effect, vector: Array, sigma: Callable[[Array], float]
) -> dict[str, tuple[float, float]]:
    """95 % interval of each parameter alone (Eq. (3)), from the standard deviation along a unit
    vector: a magnitude has that along the vector, its angle the one across it."""
    if not effect.periods:
        (key,) = effect.keys
        half_width = NORMAL_95 * sigma(np.ones(1))
        return {key.name: _convert_interval(key, float(vector[0]), half_width)}
    magnitude, angle = effect.keys
    length = float(np.hypot(*vector))
    along = vector / length if length else np.array([1.0, 0.0])
    across = np.array([-along[1], along[0]])
    half_turn = math.pi / effect.periods
    half_widths = [NORMAL_95 * sigma(direction) for direction in (along, across)]
    turn = min(half_widths[1] / (length * effect.periods), half_turn) if length else half_turn
    axis = angle.to_si(effect.parameters(vector)[angle.name])
    low, high = _convert_interval(magnitude, length, half_widths[0])
    return {magnitude.name: (max(low, 0.0), high), angle.name: _convert_interval(angle, axis, turn)}


def _convert_interval(key: Key, value: float, half_width: float) -> tuple[float, float]:
    return key.from_si(value - half_width), key.from_si(value + half_width)


def _make_noise_cause(attribution: Attribution, added: AddedNoise) -> Cause:
    name, key = added.effect.name, added.effect.key
    low, high = (key.from_si(end) for end in added.interval)
    others = dict.fromkeys([*added.equivalents, *attribution.posterior.list_equivalents(name)])
    return Cause(
        name,
        attribution.posterior.probability(name, *others),
        {key.name: key.from_si(added.total)},
        {key.name: (low, high)},
        tuple(others),
    )


def list_unnamed(attribution: Attribution, features: Sequence[ResidualFeature]) -> dict[str, float]:
    """What may take part outside the catalogue, in words, with posterior probabilities, the most
    probable first."""
    probabilities = attribution.posterior.list_unnamed() | {
        f.words: f.probability for f in features
    }
    mentioned = [(w, p) for w, p in probabilities.items() if p > MENTIONED_PROBABILITY]
    return dict(sorted(mentioned, key=lambda pair: -pair[1]))
