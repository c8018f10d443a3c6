"""Which test would best separate the hypotheses that a campaign leaves confounded.

Design of experiment by discrimination between models (docs/methods/next_test.md; W. J. Hunter,
A. M. Reiner, Technometrics 7 (1965)). A future test separates two hypotheses by the part of their
difference that the rival can't imitate when it is fitted again to old and new tests together. Where
their noises differ too, the divergence of the noises is added.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from scipy.special import logsumexp

from pyhrg.bench.bench import Bench
from pyhrg.bench.programme import Programme
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.units import HOUR
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.design import (
    Design,
    Sizes,
    build_design,
    compute_model_error,
)
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.effects.sensitivities import compute_sensitivities
from pyhrg.gap.effects.term_columns import compute_response
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import NextTest
from pyhrg.gap.next_test.candidate_tests import list_candidates
from pyhrg.gap.next_test.noise_divergence import compute_divergence
from pyhrg.gap.next_test.rivals import Rival
from pyhrg.gap.replay.observations import CHANNELS, COARSE_STEP, ObservedTest, observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.whitening import NoiseModel

Pair = tuple[int, int]
"""Indices of two hypotheses."""

MENTIONED_PAIRS = 2
"""Number of pairs that the reason for a test mentions."""
VISIBLE_SIGMA = 1.0
"""Smallest separation of a pair in an hour of a test, sigma, that counts. Chosen."""
SEPARATION_SIGMA = 6.0
"""Separation after which a pair counts as separated, even if the tests so far favour the wrong
hypothesis. Chosen."""


@dataclass(frozen=True)
class Separation:
    """What a kind of test separates.

    sigmas: separation of each pair of hypotheses in the time that is given, in sigma.
    """

    kind: str
    sigmas: Mapping[Pair, float]

    def list_separated(self, pairs: Iterable[Pair]) -> list[Pair]:
        """The pairs, of these, that it separates at all."""
        return [pair for pair in pairs if self.sigmas[pair] > VISIBLE_SIGMA]


def suggest_next_test(
    simulation: Simulation, attribution: Attribution, hypotheses: Sequence[Rival]
) -> NextTest | None:
    """The kind of test that would best separate surviving hypotheses, the most probable first, and
    for how long; None where there are fewer than two, or where no kind separates any of them.
    `diagnose` then asks `suggest_static_test`, for confounded noises."""
    if len(hypotheses) < 2:
        return None
    kinds = compute_separations(simulation, attribution, hypotheses)
    pairs = [pair for pair in kinds[0].sigmas if any(kind.list_separated([pair]) for kind in kinds)]
    if not pairs:
        return None
    order = order_kinds(kinds, pairs)
    return NextTest(
        order[0].kind, _explain_choice(order, pairs, hypotheses), _compute_hours(order[0], pairs)
    )


def order_kinds(kinds: Sequence[Separation], pairs: Sequence[Pair]) -> list[Separation]:
    """Kinds of test, the best first.

    The best kind separates the most rivals from the most probable hypothesis; then the most pairs;
    then in the fewest hours; then with the smallest bound on the error probability.
    """

    def rank(kind: Separation) -> tuple[int, int, float, float]:
        separated = kind.list_separated(pairs)
        from_best = sum(0 in pair for pair in separated)
        return (
            -from_best,
            -len(separated),
            _compute_hours(kind, pairs),
            _compute_log_error_bound(kind, pairs),
        )

    return sorted(kinds, key=rank)


def _compute_hours(kind: Separation, pairs: Sequence[Pair]) -> float:
    """Hours after which a kind of test has separated all pairs that it separates at all (Eq. (3));
    infinite where it separates none."""
    sigmas = [kind.sigmas[pair] for pair in kind.list_separated(pairs)]
    return math.ceil(10 * (SEPARATION_SIGMA / min(sigmas)) ** 2) / 10 if sigmas else math.inf


def _compute_log_error_bound(kind: Separation, pairs: Sequence[Pair]) -> float:
    """Logarithm of Bhattacharyya's bound on the probability of a wrong choice after an hour,
    hypotheses equally probable before (A. Bhattacharyya, Bull. Calcutta Math. Soc. 35 (1943))."""
    return float(logsumexp([-(kind.sigmas[pair] ** 2) / 8 for pair in pairs]))


def compute_separations(
    simulation: Simulation,
    attribution: Attribution,
    hypotheses: Sequence[Rival],
    duration: float = HOUR,
) -> list[Separation]:
    """What each kind of test would separate in this much time, s, in the order of
    `list_candidates`."""
    unit = attribution.posterior.best.known.whole
    sizes = [{g: v for g, v in h.fit.sizes.items() if _is_predictive(g)} for h in hypotheses]
    groups = list(dict.fromkeys(group for own in sizes for group in own))
    bench = Bench(simulation.quasi_steady, attribution.device.without_noise())
    start_angle = attribution.parts[0].test.inputs.start_angle
    separations = []
    for kind, power_ons in list_candidates(bench, start_angle).items():
        programmes = [power_on.programme for power_on in power_ons]
        share = duration / sum(programme.time for programme in programmes)
        parts = []
        for power_on in power_ons:
            coarse = replace(bench, step=min(COARSE_STEP, power_on.programme.interval))
            test = observe_test(coarse.log(power_on), bench.device)
            test = replace(test, line_period=attribution.parts[0].test.line_period)
            parts.append(_linearize(simulation, attribution, test, sizes[0], groups))
        designs = []
        for h in hypotheses:
            error = compute_model_error(parts, h.noise)
            designs.append(build_design(parts, h.noise, error))
        sides = [
            _Side(
                _scale_sizes(own, groups, unit),
                np.array([g in own and g != h.held for g in groups for _ in unit.columns[g]], bool),
                h.noise.angle,
                _compute_information(h.design, groups, unit),
                _compute_information(design, groups, unit) * share,
            )
            for own, h, design in zip(sizes, hypotheses, designs, strict=True)
        ]
        sigmas = {
            (i, j): _compute_separation(a, b, share * _compute_noise_divergences(a, b, programmes))
            for (i, a), (j, b) in combinations(enumerate(sides), 2)
        }
        separations.append(Separation(kind, sigmas))
    return separations


def _is_predictive(group: Group) -> bool:
    """Whether its size in these tests says anything about a test that is yet to be made."""
    return isinstance(group, Effect) or not (isinstance(group, Jump) or group.is_of_each_power_on)


def _linearize(
    simulation: Simulation,
    attribution: Attribution,
    test: ObservedTest,
    truth: Sizes,
    groups: Sequence[Group],
) -> LinearTest:
    """Linear model of a simulated test, with the residual that these sizes would give."""
    device = attribution.device
    effects = [g for g in groups if isinstance(g, Effect)]
    columns = compute_sensitivities(simulation, device, test, effects)
    by_angle = simulation.differentiate_by_angle(device, test)
    where = compute_coordinates(test, vars(test.log), device, by_angle.free_turns)
    terms = {g: size for g, size in truth.items() if isinstance(g, CandidateTerm)}
    response = {name: compute_response(where, name, terms) for name in CHANNELS}
    for effect, own in columns.items():
        for name in CHANNELS if effect in truth else ():
            response[name] += own[name] @ truth[effect]
    answers = {name: getattr(test.log, name) for name in CHANNELS}
    return LinearTest(test, device, answers, response, columns, where, by_angle, frozenset(groups))


def _compute_information(tests: Design, groups: Sequence[Group], unit: Design) -> Array:
    """(p, p) Fisher information on the groups in some tests, in units of another design."""
    where = tests.list_columns(groups)
    norms = tests.norms[where] / unit.norms[unit.list_columns(groups)]
    return np.asarray(tests.gram[np.ix_(where, where)] * np.outer(norms, norms))


@dataclass(frozen=True)
class _Side:
    """A hypothesis as one side of a pair.

    sizes: (p,) sizes of all groups, zero where it has none.
    free: (p,) whether it has the group, of any size.
    noise: noise of the output angle.
    old: (p, p) Fisher information on all groups in the tests made so far.
    new: (p, p) the same in the future test.
    """

    sizes: Array
    free: Mask
    noise: NoiseModel
    old: Array
    new: Array


def _compute_separation(side: _Side, other: _Side, divergences: Array) -> float:
    """Separation by the new tests beyond that by the old ones, in sigma: the smaller one of the two
    ways round (Eqs. (1), (2)). (2,) divergences of the noises in the new tests, each way round, are
    added."""

    def power(truth: _Side, rival: _Side, divergence: float) -> float:
        difference = truth.sizes - rival.sizes
        with_new = _compute_unimitated_power(rival.old + rival.new, difference, rival.free)
        return (
            with_new - _compute_unimitated_power(rival.old, difference, rival.free) + 2 * divergence
        )

    forward, backward = divergences
    smaller = min(power(side, other, forward), power(other, side, backward))
    return math.sqrt(max(smaller, 0.0))


def _compute_noise_divergences(side: _Side, other: _Side, programmes: Sequence[Programme]) -> Array:
    """(2,) divergence of the two noises over some power-ons, each way round."""
    pairs = [(side.noise, other.noise), (other.noise, side.noise)]
    return np.array(
        [sum(compute_divergence(*pair, p.time, p.interval) for p in programmes) for pair in pairs]
    )


def _scale_sizes(known: Sizes, groups: Sequence[Group], unit: Design) -> Array:
    """(p,) sizes of all groups in units of a design's columns; zero where unknown."""
    sizes = [known.get(g, np.zeros(len(unit.columns[g]))) for g in groups]
    return np.concatenate([np.empty(0), *sizes]) * unit.norms[unit.list_columns(groups)]


def _compute_unimitated_power(information: Array, difference: Array, free: Mask) -> float:
    """Power of a difference of sizes that no change of the free sizes makes up for (Eq. (1))."""
    projection = information @ difference
    inverse = np.linalg.pinv(information[np.ix_(free, free)], hermitian=True)
    return float(difference @ projection - projection[free] @ inverse @ projection[free])


def _explain_choice(
    order: Sequence[Separation], pairs: Sequence[Pair], hypotheses: Sequence[Rival]
) -> str:
    """The pairs that the best kind separates least, and what the second best does for them."""
    best, second = order[:2]
    hardest = sorted(best.list_separated(pairs), key=lambda pair: best.sigmas[pair])[
        :MENTIONED_PAIRS
    ]
    separations = [
        f"{_describe_pair(hypotheses[i], hypotheses[j])} by {best.sigmas[i, j]:.2g} sigma "
        f"({second.kind.replace('_', ' ')} by {second.sigmas[i, j]:.2g})"
        for i, j in hardest
    ]
    return f"one hour of it separates {'; '.join(separations)}"


def _describe_pair(hypothesis: Rival, other: Rival) -> str:
    first, second = (
        " with ".join(words for words in mine.words if words not in yours.words)
        for mine, yours in ((hypothesis, other), (other, hypothesis))
    )
    return f"{first or second} from {second if first and second else 'its absence'}"
