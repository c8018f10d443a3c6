"""The diagnosis of one channel: verdict, noise terms that exceed the belief, held-out check."""

from dataclasses import dataclass

import numpy as np
from scipy.special import polygamma
from scipy.stats import chi2
from scipy.stats import f as f_distribution

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.evidence import RAMP, Posterior, Problem, build_problem
from pyhrg.gap.static_record.fit.hypotheses import FALSE_ALARMS, Ranking, rank_explanations
from pyhrg.gap.static_record.fit.likelihood import (
    Transform,
    estimate_columns,
    transform_record,
    whiten_coefficients,
)
from pyhrg.gap.static_record.fit.unknowns import split_octaves, sum_octaves
from pyhrg.gap.static_record.record import Channel
from pyhrg.gap.static_record.terms import Kind, Term

TEMPERATURE = "temperature"
EQUIVALENT_LOG_RATIO = 3.0
"""A term is confounded with another if the swap lowers the log evidence by less than this
(chosen)."""
NAMED_PROBABILITY = 0.9
"""Posterior probability above which a term is named without reservation (chosen)."""
UNKNOWN_PROBABILITY = 0.5
"""Posterior probability of an unknown above which the verdict is `unexplained` (chosen)."""
TAIL = 0.025
"""Probability beyond each end of an interval."""


@dataclass(frozen=True)
class Cause:
    """A noise term that exceeds the belief.

    term: of the sensor.
    probability: that it exceeds the belief and no unknown takes part.
    value, low, high: median and 95 % interval of its total level, in the file's unit.
    equivalents: names of the terms that are confounded with it.
    """

    term: Term
    probability: float
    value: float
    low: float
    high: float
    equivalents: tuple[str, ...]


@dataclass(frozen=True)
class Whiteness:
    """Statistics of whitened coefficients.

    rms: root mean square; 1 where the model is right.
    octaves: (k,) mean square in each octave, from the highest frequencies down.
    log_rms: root mean square of the octaves' logarithms.
    log_floor: expectation of `log_rms` for white noise.
    p_value: probability that white noise deviates as far in its most deviating octave (two-sided
        chi-square test with the Bonferroni correction).
    """

    rms: float
    octaves: Array
    log_rms: float
    log_floor: float
    p_value: float


@dataclass(frozen=True)
class HalfComparison:
    """Whiteness of one half of the record under the belief and under the closed noise model. The
    two are equal where no term was found."""

    before: Whiteness
    after: Whiteness


@dataclass(frozen=True)
class ChannelDiagnosis:
    """The diagnosis of one channel.

    verdict: `no_gap`, `explained`, `ambiguous` or `unexplained`.
    ranking: all explanations with their probabilities.
    causes: noise terms that exceed the belief.
    ceilings: upper 97.5 % bound of each noise's level, in the file's unit, whatever else is in the
        record.
    closed: (4,) levels of the closed noise model, SI.
    units: (4,) levels of unit strengths, SI.
    fit, holdout: whiteness of the fitted first half and of the held-out second half.
    holdout_p_value: probability that the second half deviates as far from the noise that was fitted
        to the first (F-test of the octaves, as `Whiteness.p_value`); a small one is a gap.
    """

    channel: Channel
    belief: Belief
    verdict: str
    ranking: Ranking
    causes: tuple[Cause, ...]
    ceilings: dict[str, float]
    closed: Array
    units: Array
    fit: HalfComparison
    holdout: HalfComparison
    holdout_p_value: float


def transform_channel(channel: Channel, belief: Belief) -> Transform:
    """The transformed channel: believed sinusoids are free columns, ramp and temperature random
    columns."""
    n = len(channel.angle)
    time = channel.interval * (np.arange(n) - (n - 1) / 2)
    free = [f(2 * np.pi * time / p) for p in belief.periods for f in (np.cos, np.sin)]
    random = {RAMP: time**2 / 2}
    if channel.may_drift:
        free.append(random.pop(RAMP))
    if channel.temperature is not None and np.ptp(channel.temperature) > 0:
        deviation = channel.temperature - np.mean(channel.temperature)
        random[TEMPERATURE] = channel.interval * np.cumsum(deviation)
    return transform_record(channel.angle - belief.ramp * time**2 / 2, free, random)


def diagnose_channel(
    channel: Channel, belief: Belief, false_alarms: float = FALSE_ALARMS, seed: int = 0
) -> ChannelDiagnosis:
    """Diagnose a channel on its first half and verify the noise model on its second half.

    Of records that are as believed, at most the share `false_alarms` is called a gap: half by the
    fit of the first half, half by the check on the second. seed: of the samples."""
    false_alarms /= 2
    fit = channel.part(0, channel.half)
    problem = build_problem(transform_channel(fit, belief), belief, channel.interval)
    ranking = rank_explanations(problem, seed, false_alarms)
    is_alarm = ranking.log_ratio > -np.log(false_alarms)
    has_terms = is_alarm and ranking.unknown_probability <= UNKNOWN_PROBABILITY
    chosen = ranking.hypotheses[0].terms if has_terms else ranking.null
    causes = tuple(_make_cause(channel, belief, ranking, chosen, effect) for effect in chosen.extra)
    held_out = channel.part(channel.half, len(channel.angle))
    second_half = build_problem(transform_channel(held_out, belief), belief, channel.interval)
    p_value = _compare_halves(problem, second_half, chosen)
    return ChannelDiagnosis(
        channel=channel,
        belief=belief,
        verdict=_reach_verdict(is_alarm, ranking, causes, p_value > false_alarms),
        ranking=ranking,
        causes=causes,
        ceilings=_compute_ceilings(channel.kind, problem),
        closed=np.sqrt(chosen.best[0]) * problem.units if causes else belief.levels,
        units=problem.units,
        fit=_compare_whiteness(problem, chosen),
        holdout=_compare_whiteness(second_half, chosen),
        holdout_p_value=p_value,
    )


def _reach_verdict(
    is_alarm: bool, ranking: Ranking, causes: tuple[Cause, ...], is_verified: bool
) -> str:
    if not is_verified:
        return "unexplained"
    if not is_alarm:
        return "no_gap"
    if ranking.unknown_probability > UNKNOWN_PROBABILITY or not causes:
        return "unexplained"
    is_certain = all(c.probability > NAMED_PROBABILITY and not c.equivalents for c in causes)
    return "explained" if is_certain else "ambiguous"


def _make_cause(
    channel: Channel, belief: Belief, ranking: Ranking, chosen: Posterior, effect: int
) -> Cause:
    """A term with its total level. White noise of the angle is called quantization if the readings
    lie on a grid whose step agrees with it."""
    kind, step = channel.kind, channel.quantization_step
    term = _get_term(kind, chosen.problem, effect)
    believed = belief.ramp if term is kind.ramp else 0.0  # `transform_channel` took it out
    levels = (believed + _draw_levels(chosen, effect)) / term.factor
    low, value, high = _compute_quantiles(levels, chosen.weights, (TAIL, 0.5, 1 - TAIL))
    if term is kind.terms[0] and step is not None:
        steps = np.array([low, value, high]) * term.factor * np.sqrt(12)
        if steps[0] <= step <= steps[2]:
            term = kind.quantization
            low, value, high = (steps / term.factor).tolist()
    equivalents = _find_equivalents(kind, ranking, chosen, effect)
    return Cause(term, ranking.get_probability(effect), value, low, high, tuple(equivalents))


def _get_term(kind: Kind, problem: Problem, effect: int) -> Term:
    """The term with an index: four noises, then the random columns."""
    columns = [kind.ramp if name == RAMP else kind.temperature_term for name in problem.data.names]
    return (*kind.terms, *columns)[effect]


def _draw_levels(posterior: Posterior, effect: int) -> Array:
    """(s,) samples of a term's level in SI. The coefficient of a column is drawn from its normal
    distribution, given the noise of the sample."""
    problem, noises = posterior.problem, len(posterior.problem.belief)
    if effect < noises:
        return np.asarray(posterior.levels[:, effect] * problem.units[effect])
    column = effect - noises
    squares = posterior.levels**2
    mean, covariance = estimate_columns(problem.data, squares[:, :noises], squares[:, noises:])
    spread = np.sqrt(covariance[:, column, column])
    drawn = np.random.default_rng(effect).standard_normal(len(spread))
    drawn = mean[:, column] + spread * drawn
    return np.asarray(drawn / problem.data.lengths[column])


def _compute_quantiles(
    values: Array, weights: Array, shares: tuple[float, ...]
) -> tuple[float, ...]:
    order = np.argsort(values)
    reached = np.cumsum(weights[order]) - weights[order] / 2
    return tuple(float(x) for x in np.interp(shares, reached, values[order]))


def _find_equivalents(kind: Kind, ranking: Ranking, chosen: Posterior, effect: int) -> list[str]:
    """Terms that explain the record nearly as well in this one's place."""
    others = {frozenset(h.terms.extra): h.terms for h in ranking.hypotheses if not h.unknown}
    equivalents = []
    for rival in range(chosen.problem.effects):
        swapped = others.get(frozenset({*chosen.extra, rival} - {effect}))
        if (
            rival not in chosen.extra
            and swapped
            and swapped.log_evidence > chosen.log_evidence - EQUIVALENT_LOG_RATIO
        ):
            equivalents.append(_get_term(kind, chosen.problem, rival).effect)
    return equivalents


def _compute_ceilings(kind: Kind, problem: Problem) -> dict[str, float]:
    """Upper bounds of the levels: in no octave is a noise stronger than the record, but by chance
    (docs/methods/noise.md, Eq. 14)."""
    data = problem.data
    power, count = (x[:-1] for x in sum_octaves(data.coefficients))
    highest = power / chi2.ppf(TAIL / len(count), count)
    middle = [(band.start + band.stop) / 2 for band in split_octaves(data.n - 1)[:-1]]
    shapes = np.exp(
        [
            np.interp(np.log(middle), np.log(data.bands.harmonics), s)
            for s in np.log(data.bands.shapes)
        ]
    )
    levels = np.sqrt(np.min(highest / shapes, axis=1)) * problem.units
    return {t.parameter: float(x / t.factor) for t, x in zip(kind.terms, levels, strict=True)}


def _compare_whiteness(problem: Problem, chosen: Posterior) -> HalfComparison:
    """Whiteness under the belief, and under the closed noise model if a term was found."""
    strengths, variances = problem.unpack((), np.zeros((1, len(problem.believed))))
    before = _measure_whiteness(whiten_coefficients(problem.data, strengths[0], variances[0]))
    if not chosen.extra:
        return HalfComparison(before, before)
    strengths, variances = chosen.best
    column_variances = np.resize(variances, len(problem.data.names))
    return HalfComparison(
        before, _measure_whiteness(whiten_coefficients(problem.data, strengths, column_variances))
    )


def _compare_halves(first: Problem, second: Problem, chosen: Posterior) -> float:
    """Probability that two halves of one noise differ as much in their most different octave, both
    whitened with the noise fitted to the first (two-sided F-test, Bonferroni correction)."""
    strengths, variances = chosen.best
    powers, counts = zip(
        *(
            sum_octaves(
                whiten_coefficients(
                    each.data, strengths, np.resize(variances, len(each.data.names))
                )
            )
            for each in (first, second)
        ),
        strict=True,
    )
    ratio = (powers[1] / counts[1]) / (powers[0] / counts[0])
    spread = f_distribution(counts[1], counts[0])
    tail = 2 * np.minimum(spread.cdf(ratio), spread.sf(ratio))
    return min(1.0, float(len(ratio) * np.min(tail)))


def _measure_whiteness(white: Array) -> Whiteness:
    """Statistics of (m,) whitened coefficients."""
    power, count = sum_octaves(white)
    tail = 2 * np.minimum(chi2.cdf(power, count), chi2.sf(power, count))
    mean = power / count
    return Whiteness(
        rms=float(np.sqrt(np.mean(white**2))),
        octaves=mean,
        log_rms=float(np.sqrt(np.mean(np.log(mean) ** 2))),
        log_floor=float(np.sqrt(np.mean(polygamma(1, count / 2)))),
        p_value=min(1.0, float(len(power) * np.min(tail))),
    )
