"""What one channel's record says of what was believed of its noise."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.evidence import RAMP, Posterior, Problem, problem
from pyhrg.gap.static_record.fit.hypotheses import FALSE_ALARMS, Judgement, judged
from pyhrg.gap.static_record.fit.likelihood import Data, column_estimates, data_of, whitened
from pyhrg.gap.static_record.fit.unknowns import octaves
from pyhrg.gap.static_record.fit.whiteness import Whiteness, whiteness
from pyhrg.gap.static_record.record import Channel
from pyhrg.gap.static_record.terms import Kind, Term

Array = NDArray[np.float64]

TEMPERATURE = "temperature"
RIVAL = 3.0
"""Log evidence within which another term says the same."""
SURE = 0.9
"""Probability from which a term is named alone."""
LIKELY = 0.5
"""Probability beyond which something without a name takes part."""
TAIL = 0.025


@dataclass(frozen=True)
class Cause:
    """A noise term that exceeds belief: its total level and 95 % interval, in the file's unit."""

    term: Term
    probability: float
    value: float
    low: float
    high: float
    equivalents: tuple[str, ...]


@dataclass(frozen=True)
class Closing:
    """Whiteness of one half under the belief and under the closed model; the same if none is."""

    before: Whiteness
    after: Whiteness


@dataclass(frozen=True)
class ChannelDiagnosis:
    """Of one channel; ceilings: level (file's unit) that each noise can't exceed whatever else is
    in the record, 97.5 %; closed: levels (4,) SI of the closed model."""

    channel: Channel
    belief: Belief
    verdict: str
    judgement: Judgement
    causes: tuple[Cause, ...]
    ceilings: dict[str, float]
    closed: Array
    units: Array
    """(4,) SI levels of unit strengths."""
    fit: Closing
    holdout: Closing


def data_of_channel(channel: Channel, belief: Belief) -> Data:
    """Transformed: believed sinusoids in any size, ramp and temperature as random effects."""
    n = len(channel.angle)
    time = channel.interval * (np.arange(n) - (n - 1) / 2)
    free = [f(2 * np.pi * time / p) for p in belief.periods for f in (np.cos, np.sin)]
    random = {RAMP: time**2 / 2}
    if channel.drifts:
        free.append(random.pop(RAMP))
    if channel.temperature is not None and np.ptp(channel.temperature) > 0:
        warmth = channel.temperature - np.mean(channel.temperature)
        random[TEMPERATURE] = channel.interval * np.cumsum(warmth)
    return data_of(channel.angle - belief.ramp * time**2 / 2, free, random)


def diagnosed(
    channel: Channel, belief: Belief, false_alarms: float = FALSE_ALARMS, seed: int = 0
) -> ChannelDiagnosis:
    """Judge the first half, verify on the second.

    Args:
        channel: the record.
        belief: of its sensor.
        false_alarms: share of records as believed that may be called a gap, at most.
        seed: of the samples.
    """
    fit = channel.part(0, channel.half)
    of = problem(data_of_channel(fit, belief), belief, channel.interval)
    judgement = judged(of, seed, false_alarms)
    alarm = judgement.log_ratio > -np.log(false_alarms)
    chosen = judgement.best if alarm and judgement.unknown_probability <= LIKELY else judgement.null
    causes = tuple(_causes(channel, judgement, chosen)) if alarm else ()
    held_out = channel.part(channel.half, len(channel.angle))
    rest = problem(data_of_channel(held_out, belief), belief, channel.interval)
    return ChannelDiagnosis(
        channel=channel,
        belief=belief,
        verdict=_verdict(alarm, judgement, causes),
        judgement=judgement,
        causes=causes,
        ceilings=_ceilings(channel.kind, of),
        closed=np.sqrt(chosen.best[0]) * of.units if causes else belief.levels,
        units=of.units,
        fit=_closing(of, chosen if causes else None),
        holdout=_closing(rest, chosen if causes else None),
    )


def _verdict(alarm: bool, judgement: Judgement, causes: tuple[Cause, ...]) -> str:
    if not alarm:
        return "no_gap"
    if judgement.unknown_probability > LIKELY or not causes:
        return "unexplained"
    sure = all(c.probability > SURE and not c.equivalents for c in causes)
    return "explained" if sure else "ambiguous"


def _causes(channel: Channel, judgement: Judgement, chosen: Posterior) -> list[Cause]:
    causes = [_cause(channel.kind, judgement, chosen, effect) for effect in chosen.extra]
    return [_by_grid(c, channel) if c.term is channel.kind.terms[0] else c for c in causes]


def _cause(kind: Kind, judgement: Judgement, chosen: Posterior, effect: int) -> Cause:
    term = term_of(kind, chosen.problem, effect)
    levels = _levels(chosen, effect) / term.factor
    low, value, high = _quantiles(levels, chosen.weights, (TAIL, 0.5, 1 - TAIL))
    rivals = _rivals(kind, judgement, chosen, effect)
    return Cause(term, judgement.probability_of(effect), value, low, high, tuple(rivals))


def _by_grid(cause: Cause, channel: Channel) -> Cause:
    """White noise of the angle is quantisation where readings lie on a grid whose step has it."""
    term, step = channel.kind.quantum, channel.quantum
    ends = np.array([cause.value, cause.low, cause.high]) * cause.term.factor * np.sqrt(12)
    if step is None or not ends[1] <= step <= ends[2]:
        return cause
    value, low, high = (ends / term.factor).tolist()
    return Cause(term, cause.probability, value, low, high, cause.equivalents)


def term_of(kind: Kind, of: Problem, effect: int) -> Term:
    """The term that an effect's index is."""
    if effect < len(kind.terms):
        return kind.terms[effect]
    return kind.ramp if of.data.names[effect - len(kind.terms)] == RAMP else kind.warmth


def _levels(of: Posterior, effect: int) -> Array:
    """(s,) SI; of a column its coefficient, drawn about its estimate."""
    noises = len(of.problem.belief)
    if effect < noises:
        return np.asarray(of.levels[:, effect] * of.problem.units[effect])
    column = effect - noises
    squares = of.levels**2
    mean, covariance = column_estimates(of.problem.data, squares[:, :noises], squares[:, noises:])
    spread = np.sqrt(covariance[:, column, column])
    drawn = np.random.default_rng(effect).standard_normal(len(spread))
    drawn = mean[:, column] + spread * drawn
    return np.asarray(drawn / of.problem.data.lengths[column])


def _quantiles(values: Array, weights: Array, shares: tuple[float, ...]) -> tuple[float, ...]:
    order = np.argsort(values)
    reached = np.cumsum(weights[order]) - weights[order] / 2
    return tuple(float(x) for x in np.interp(shares, reached, values[order]))


def _rivals(kind: Kind, judgement: Judgement, chosen: Posterior, effect: int) -> list[str]:
    """Terms that explain nearly as much in this one's place."""
    others = {frozenset(h.terms.extra): h.terms for h in judgement.hypotheses if not h.unknown}
    found = []
    for rival in range(chosen.problem.effects):
        swapped = others.get(frozenset({*chosen.extra, rival} - {effect}))
        if (
            rival not in chosen.extra
            and swapped
            and swapped.log_evidence > chosen.log_evidence - RIVAL
        ):
            found.append(term_of(kind, chosen.problem, rival).effect)
    return found


def _ceilings(kind: Kind, of: Problem) -> dict[str, float]:
    """No octave shows less power than a noise in it has, but by chance."""
    data = of.data
    bands = octaves(data.n - 1)[:-1]
    power = np.array([np.sum(data.coefficients[band] ** 2) for band in bands])
    count = np.array([band.stop - band.start for band in bands])
    most = power / chi2.ppf(TAIL / len(bands), count)
    middle = [(band.start + band.stop) / 2 for band in bands]
    shapes = np.exp(
        [np.interp(np.log(middle), np.log(data.harmonics), s) for s in np.log(data.shapes)]
    )
    levels = np.sqrt(np.min(most / shapes, axis=1)) * of.units
    return {t.parameter: float(x / t.factor) for t, x in zip(kind.terms, levels, strict=True)}


def _closing(of: Problem, after: Posterior | None) -> Closing:
    """Exactly as believed, and with what was missing if anything was named."""
    strengths, variances = of.unpack((), np.zeros((1, len(of.believed))))
    before = whiteness(whitened(of.data, strengths[0], variances[0]))
    if after is None:
        return Closing(before, before)
    strengths, variances = after.best
    fitting = np.resize(variances, len(of.data.names))
    return Closing(before, whiteness(whitened(of.data, strengths, fitting)))
