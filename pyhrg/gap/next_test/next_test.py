"""Which test would best tell apart what a campaign has left alike.

A test that is yet to be made parts two hypotheses by so many deviations of the rival's noise, after
the rival has had its own sizes fitted anew, to old and new tests together: what it could imitate
does not count. Half the square is the expected divergence (W. J. Hunter, A. M. Reiner,
Technometrics 7 (1965)); where their noises are others, the divergence of these is added, at the
levels that each hypothesis has. The kind that parts the most probable hypothesis from the most of
its rivals is suggested; of several, the one that parts the most pairs at all, and then the one that
does so in the fewest hours.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import HOUR
from pyhrg.gap.effects.candidate_terms import coordinates
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group, LinearTest, design, response_power, tempered
from pyhrg.gap.effects.sensitivities import secants
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import allowed
from pyhrg.gap.findings.diagnosis import NextTest
from pyhrg.gap.next_test.candidate_tests import candidates
from pyhrg.gap.next_test.noise_divergence import divergence
from pyhrg.gap.next_test.rivals import Rival
from pyhrg.gap.replay.observations import CHANNELS, COARSE_STEP, Observed, observed
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import ChannelNoise
from pyhrg.gap.whitening.whitening import SlowNoise

Array = NDArray[np.float64]
Sizes = Mapping[Group, Array]
"""By group, per unit of its columns."""
Pair = tuple[int, int]
"""Places of two hypotheses."""

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
    sigmas: Mapping[Pair, float]

    def seen(self, pairs: Iterable[Pair]) -> list[Pair]:
        """Those of some pairs that it separates at all."""
        return [pair for pair in pairs if self.sigmas[pair] > SEEN]


def suggested(
    simulation: Simulation, found: Attribution, hypotheses: Sequence[Rival]
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
    pairs = [pair for pair in kinds[0].sigmas if any(kind.seen([pair]) for kind in kinds)]
    if not pairs:
        return None
    order = soonest(kinds, pairs)
    return NextTest(order[0].kind, _why(order, pairs, hypotheses), _hours(order[0], pairs))


def soonest(kinds: Sequence[Separation], pairs: Sequence[Pair]) -> list[Separation]:
    """Kinds that see the most pairs first, above all of those with the most probable hypothesis;
    then in order of the hours that they part these in, then of how well they do in one."""

    def rank(kind: Separation) -> tuple[int, int, float, float]:
        seen = kind.seen(pairs)
        of_best = sum(0 in pair for pair in seen)
        return -of_best, -len(seen), _hours(kind, pairs), _confusion(kind, pairs)

    return sorted(kinds, key=rank)


def _hours(kind: Separation, pairs: Sequence[Pair]) -> float:
    """Hours in which a kind of test parts the pairs that it sees by `SURE`; infinite where it sees
    none."""
    seen = [kind.sigmas[pair] for pair in kind.seen(pairs)]
    return math.ceil(10 * (SURE / min(seen)) ** 2) / 10 if seen else math.inf


def separations(
    simulation: Simulation,
    found: Attribution,
    hypotheses: Sequence[Rival],
    duration: float = HOUR,
) -> list[Separation]:
    """What this much time, s, of each kind of test would do, in the order of `candidates`; other
    arguments as `suggested`."""
    foretold = [_foretold(each.fit) for each in hypotheses]
    groups = list(dict.fromkeys(group for sizes in foretold for group in sizes))
    bench = Bench(simulation.quasi_steady, found.device.without_noise())
    begun = found.parts[0].test.inputs.start_angle
    kinds = []
    for kind, power_ons in candidates(bench, begun).items():
        courses = [power_on.programme for power_on in power_ons]
        share = duration / sum(course.time for course in courses)
        tests = [_recorded(bench, power_on) for power_on in power_ons]
        parts = [_expected(simulation, found, test, foretold[0], groups) for test in tests]
        rows = {each.noise.angle: _summed(parts, each.noise) for each in hypotheses}
        sides = [
            _Side(
                sizes,
                each.noise.angle,
                _information(each.design, groups, found.design),
                _information(rows[each.noise.angle], groups, found.design) * share,
            )
            for sizes, each in zip(foretold, hypotheses, strict=True)
        ]
        sigmas = {
            (i, j): _parted(a, b, groups, found.design, share * _divergent(a, b, courses))
            for (i, a), (j, b) in combinations(enumerate(sides), 2)
        }
        kinds.append(Separation(kind, sigmas))
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
    truth: Sizes,
    groups: Sequence[Group],
) -> LinearTest:
    """What would be put together for a test, were it made and this hypothesis the truth."""
    device = found.device
    columns = secants(simulation, device, test, [g for g in groups if isinstance(g, Effect)])
    response = {name: np.zeros(len(test.log.time)) for name in CHANNELS}
    for effect, own in columns.items():
        for name in CHANNELS if effect in truth else ():
            response[name] += own[name] @ truth[effect]
    where = coordinates(test, test.log.wave_angle, test.log.amplitude, device)
    slopes = simulation.over_angle(device, test).slopes
    answers = {name: getattr(test.log, name) for name in CHANNELS}
    return LinearTest(test, device, answers, response, columns, where, slopes, device.bryan_factor)


def _summed(parts: Sequence[LinearTest], noise: ChannelNoise) -> Design:
    return tempered(design(parts, noise), allowed(response_power(parts, noise)))


def _information(tests: Design, groups: Sequence[Group], unit: Design) -> Array:
    """(p, p) products of the groups' columns in some tests, in units of another design's."""
    where = _places(tests, groups)
    lengths = tests.lengths[where] / unit.lengths[_places(unit, groups)]
    return np.asarray(tests.gram[np.ix_(where, where)] * np.outer(lengths, lengths))


def _places(tests: Design, groups: Sequence[Group]) -> NDArray[np.int64]:
    return np.concatenate([np.empty(0, np.int64), *(tests.places[group] for group in groups)])


@dataclass(frozen=True)
class _Side:
    """A hypothesis where a kind of test would part it from others.

    noise: of the output angle.
    old: (p, p) products of all groups' columns in the tests made so far, in deviations of noise.
    new: the same of the test.
    """

    sizes: Sizes
    noise: SlowNoise
    old: Array
    new: Array


def _parted(
    one: _Side,
    other: _Side,
    groups: Sequence[Group],
    unit: Design,
    divergences: Array,
) -> float:
    """Deviations by which new tests part two beyond what old ones do, the worse way round.

    Args:
        one, other: the two.
        groups: that have columns.
        unit: the design that these count in.
        divergences: (2,) of their noises in the new tests, whichever is the truth.
    """

    def power(truth: _Side, rival: _Side, divergence: float) -> float:
        away = _sizes(truth.sizes, groups, unit) - _sizes(rival.sizes, groups, unit)
        fitted = np.array([g in rival.sizes for g in groups for _ in unit.places[g]], np.bool_)
        left = _left(rival.old + rival.new, away, fitted) - _left(rival.old, away, fitted)
        return left + 2 * divergence

    there, back = divergences
    return math.sqrt(max(min(power(one, other, there), power(other, one, back)), 0.0))


def _divergent(one: _Side, other: _Side, courses: Sequence[Programme]) -> Array:
    """(2,) of their noises in some power-ons, whichever is the truth."""
    both = [(one.noise, other.noise), (other.noise, one.noise)]
    return np.array([sum(divergence(*pair, c.time, c.interval) for c in courses) for pair in both])


def _sizes(known: Sizes, groups: Sequence[Group], unit: Design) -> Array:
    """(p,) in lengths of the columns."""
    each = [known.get(g, np.zeros(len(unit.places[g]))) for g in groups]
    return np.concatenate([np.empty(0), *each]) * unit.lengths[_places(unit, groups)]


def _left(information: Array, away: Array, free: NDArray[np.bool_]) -> float:
    """Power of a difference that no other sizes of the free columns make up for."""
    pull = information @ away
    own = information[np.ix_(free, free)]
    return float(away @ pull - pull[free] @ np.linalg.pinv(own, hermitian=True) @ pull[free])


def _confusion(kind: Separation, pairs: Sequence[Pair]) -> float:
    """Logarithm of a bound on the share of wrong choices after an hour (A. Bhattacharyya, Bull.
    Calcutta Math. Soc. 35 (1943)), hypotheses alike before."""
    return float(logsumexp([-(kind.sigmas[pair] ** 2) / 8 for pair in pairs]))


def _why(order: Sequence[Separation], pairs: Sequence[Pair], hypotheses: Sequence[Rival]) -> str:
    """Of the pairs that the test parts least, and what the next best kind does to them."""
    best, second = order[:2]
    hardest = sorted(best.seen(pairs), key=lambda pair: best.sigmas[pair])[:TOLD]
    told = [
        f"{_words(hypotheses[i], hypotheses[j])} by {best.sigmas[i, j]:.2g} sigma "
        f"({second.kind} by {second.sigmas[i, j]:.2g})"
        for i, j in hardest
    ]
    return f"an hour of it tells {'; '.join(told)}"


def _words(one: Rival, other: Rival) -> str:
    def without(mine: Rival, yours: Rival) -> str:
        return " with ".join(words for words in mine.words if words not in yours.words)

    return f"{without(one, other)} from {without(other, one)}"
