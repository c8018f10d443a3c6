"""Which test would best tell apart what a campaign has left alike.

Each hypothesis is a set of effects and elements with its sizes. A test that is yet to be made parts
two of them by so many deviations of the noise, after the rival has had its own sizes fitted anew,
to old and new tests together: what it could imitate does not count. Half the square is the expected
divergence (W. J. Hunter, A. M. Reiner, Technometrics 7 (1965)). Kinds are compared by an hour.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.gap.attribution import Attribution
from pyhrg.gap.candidate_tests import candidates
from pyhrg.gap.catalogue import Effect
from pyhrg.gap.design import Design, Evidence, Group, design, response_power, tempered
from pyhrg.gap.diagnosis import NextTest
from pyhrg.gap.equivalents import ALIKE, equivalents
from pyhrg.gap.evidence import Fit
from pyhrg.gap.hypothesis import FIDELITY
from pyhrg.gap.observations import CHANNELS, COARSE_STEP, Observed, observed
from pyhrg.gap.secants import secants
from pyhrg.gap.simulation import Simulation
from pyhrg.gap.unknown import coordinates
from pyhrg.units import HOUR

Array = NDArray[np.float64]
Hypothesis = Mapping[Group, Array]
"""Sizes by group, per unit of its columns."""

MOST = 4
"""Rivals that are looked at."""
TOLD = 2
"""Pairs that are spoken of."""
SEEN = 1.0
"""Deviations in an hour below which a kind of test does not separate."""
SURE = 6.0
"""Deviations by which two are told apart, whichever the tests so far are for."""


@dataclass(frozen=True)
class Separation:
    """What a kind of test does.

    sigmas: deviations by which it parts each pair of hypotheses.
    """

    kind: str
    sigmas: Mapping[tuple[int, int], float]


def suggested(
    simulation: Simulation, found: Attribution, hypotheses: Sequence[Fit]
) -> NextTest | None:
    """The kind that would best separate hypotheses; None where there are no two, or none would.

    Args:
        simulation: both fidelities.
        found: what the tests made so far say.
        hypotheses: that survive, the most probable first.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    if len(hypotheses) < 2:
        return None
    kinds = separations(simulation, found, hypotheses)
    pairs = [pair for pair in kinds[0].sigmas if max(k.sigmas[pair] for k in kinds) > SEEN]
    if not pairs:
        return None
    order = sorted(kinds, key=lambda kind: _confusion(kind, pairs))
    return NextTest(order[0].kind, _why(order, pairs, hypotheses), _hours(order[0], pairs))


def _hours(kind: Separation, pairs: Sequence[tuple[int, int]]) -> float:
    """Hours in which a kind of test parts the pairs that it sees by `SURE`."""
    least = min(max(kind.sigmas[pair], SEEN) for pair in pairs)
    return math.ceil(10 * (SURE / least) ** 2) / 10


def rivals(found: Attribution, effects: Sequence[Effect]) -> list[Fit]:
    """Hypotheses that survive: the most probable set, and those as likely in which something else
    stands in the place of a group; a group more or less is no rival.

    Args:
        found: what the tests say.
        effects: of the catalogue.
    """
    best, ranked = found.ranked.best, found.ranked
    least = ranked.probabilities[0] * math.exp(-ALIKE)
    near = [f for f, p in zip(ranked.fits, ranked.probabilities, strict=True) if p > least]
    for group in best.groups:
        if isinstance(group, Effect):
            near += equivalents(found.design, best, group, effects).values()
    own = set(best.groups)
    others = {
        frozenset(fit.groups): fit
        for fit in near
        if not own <= set(fit.groups) and not set(fit.groups) <= own
    }
    return [best, *list(others.values())[:MOST]]


def separations(
    simulation: Simulation,
    found: Attribution,
    hypotheses: Sequence[Fit],
    duration: float = HOUR,
) -> list[Separation]:
    """What this much time, s, of each kind of test would do, in the order of `candidates`; other
    arguments as `suggested`."""
    foretold = [_foretold(fit) for fit in hypotheses]
    groups = list(dict.fromkeys(group for sizes in foretold for group in sizes))
    bench = Bench(simulation.quasi_steady, found.device.without_noise())
    begun = found.parts[0].test.inputs.start_angle
    old = _information(found.design, groups, found.design)
    kinds = []
    for kind, power_ons in candidates(bench, begun).items():
        share = duration / sum(power_on.programme.time for power_on in power_ons)
        tests = [_recorded(bench, power_on) for power_on in power_ons]
        parts = [_expected(simulation, found, test, foretold[0], groups) for test in tests]
        noise = replace(found.channel_noise, angle=found.noise.noise)
        whole = tempered(design(parts, noise), FIDELITY * response_power(parts, noise))
        new = _information(whole, groups, found.design) * share
        kinds.append(Separation(kind, _parted(foretold, groups, found.design, old, new)))
    return kinds


def _foretold(fit: Fit) -> dict[Group, Array]:
    sizes = fit.sizes.items()
    return {group: v for group, v in sizes if isinstance(group, Effect) or group.foretells}


def _recorded(bench: Bench, power_on: PowerOn) -> Observed:
    own = replace(bench, step=min(COARSE_STEP, power_on.programme.interval))
    return observed(own.log(power_on), bench.device)


def _expected(
    simulation: Simulation,
    found: Attribution,
    test: Observed,
    truth: Hypothesis,
    groups: Sequence[Group],
) -> Evidence:
    """What would be put together for a test, were it made and this hypothesis the truth."""
    device = found.device
    columns = secants(simulation, device, test, [g for g in groups if isinstance(g, Effect)])
    response = {name: np.zeros(len(test.log.time)) for name in CHANNELS}
    for effect, own in columns.items():
        for name in CHANNELS if effect in truth else ():
            response[name] += own[name] @ truth[effect]
    where = coordinates(test, test.log.wave_angle, device)
    slopes = simulation.over_angle(device, test).slopes
    answers = {name: getattr(test.log, name) for name in CHANNELS}
    return Evidence(test, device, answers, response, columns, where, slopes, device.bryan_factor)


def _information(tests: Design, groups: Sequence[Group], unit: Design) -> Array:
    """(p, p) products of the groups' columns in some tests, in units of another design's."""
    where = np.concatenate([tests.places[group] for group in groups])
    lengths = tests.lengths[where] / np.concatenate([unit.lengths[unit.places[g]] for g in groups])
    return np.asarray(tests.gram[np.ix_(where, where)] * np.outer(lengths, lengths))


def _parted(
    hypotheses: Sequence[Hypothesis],
    groups: Sequence[Group],
    unit: Design,
    old: Array,
    new: Array,
) -> dict[tuple[int, int], float]:
    """Deviations by which new tests part each pair beyond what old ones do, the worse way round."""

    def sizes(hypothesis: Hypothesis) -> Array:
        return np.concatenate(
            [
                hypothesis.get(g, np.zeros(len(unit.places[g]))) * unit.lengths[unit.places[g]]
                for g in groups
            ]
        )

    def free(hypothesis: Hypothesis) -> NDArray[np.bool_]:
        return np.repeat([g in hypothesis for g in groups], [len(unit.places[g]) for g in groups])

    def power(truth: Hypothesis, rival: Hypothesis) -> float:
        away, fitted = sizes(truth) - sizes(rival), free(rival)
        return _left(old + new, away, fitted) - _left(old, away, fitted)

    return {
        (i, j): math.sqrt(max(min(power(a, b), power(b, a)), 0.0))
        for (i, a), (j, b) in combinations(enumerate(hypotheses), 2)
    }


def _left(information: Array, away: Array, free: NDArray[np.bool_]) -> float:
    """Power of a difference that no other sizes of the free columns make up for."""
    pull = information @ away
    own = information[np.ix_(free, free)]
    return float(away @ pull - pull[free] @ np.linalg.pinv(own, hermitian=True) @ pull[free])


def _confusion(kind: Separation, pairs: Sequence[tuple[int, int]]) -> float:
    """Logarithm of a bound on the share of wrong choices after an hour (A. Bhattacharyya, Bull.
    Calcutta Math. Soc. 35 (1943)), hypotheses alike before."""
    return float(logsumexp([-(kind.sigmas[pair] ** 2) / 8 for pair in pairs]))


def _why(
    order: Sequence[Separation], pairs: Sequence[tuple[int, int]], hypotheses: Sequence[Fit]
) -> str:
    """Of the pairs that the test parts least, and what the next best kind does to them."""
    best, second = order[:2]
    hardest = sorted(pairs, key=lambda pair: best.sigmas[pair])[:TOLD]
    told = [
        f"{_words(hypotheses[i], hypotheses[j])} by {best.sigmas[i, j]:.2g} sigma "
        f"({second.kind} by {second.sigmas[i, j]:.2g})"
        for i, j in hardest
    ]
    return f"an hour of it tells {'; '.join(told)}"


def _words(one: Fit, other: Fit) -> str:
    def without(mine: Fit, yours: Fit) -> str:
        names = [
            group.name if isinstance(group, Effect) else group.words
            for group in mine.groups
            if group not in yours.groups
        ]
        return " with ".join(names)

    return f"{without(one, other)} from {without(other, one)}"
