"""The search repeated around the gyro with its terms, whose responses are linear only nearby.

A bias that depends on the pattern angle turns the pattern, and so changes itself. The candidate
terms of the search lack this (docs/methods/equation.md, Eq. 4). What they miss of a large term must
not be read as other terms.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.closing.equation.closed_fmu import load_closed_fmu, put_terms
from pyhrg.gap.closing.equation.proposal import list_coefficients, make_terms
from pyhrg.gap.closing.equation.series import estimate_terms
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.effects.form import build_reading_columns
from pyhrg.gap.effects.linear_test import LinearTest, shape_origin, whiten_rows
from pyhrg.gap.effects.sensitivities import linearize_test
from pyhrg.gap.effects.term_columns import compute_response
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.form_error import NEGLIGIBLE_CHI2, rank_with_forms
from pyhrg.gap.evidence.posterior import Posterior, compare_noises
from pyhrg.gap.replay.angle_derivatives import MIN_REMAINING_SHIFT
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.replay.sampled import replay_sampled_together
from pyhrg.gap.replay.simulation import ChannelValues, Simulation, add_channels
from pyhrg.gap.whitening.campaign_noise import CampaignNoise

TermSizes = Mapping[CandidateTerm, Array]
"""(d,) size of each term that can be written, in units of its columns."""

MAX_ROUNDS = 4
"""Number of searches around the gyro with its terms after which the last is taken. Chosen."""
CONVERGENCE_SIGMA = 0.1
"""The terms have converged when none moves by more than this many standard deviations. Chosen: as
for effects."""


def refine_terms(
    simulation: Simulation, attribution: Attribution, noises: Sequence[NoiseEffect]
) -> Attribution:
    """Repeat the search around the device with the written terms of its most probable set, until
    the terms stay, then compare noises. A search that did not converge is left as it is, as is one
    without terms."""
    first = attribution.parts
    for number in range(1, MAX_ROUNDS + 1):
        if not attribution.settled or not _has_terms(attribution.posterior):
            break
        sizes, parts = _list_curved(attribution.posterior), list(first)
        curved = find_curved_tests(first, sizes, attribution.channel_noise)
        if curved:
            alone = estimate_terms(attribution.posterior.best)
            terms = make_terms(attribution.posterior, {term: alone[term] for term in sizes})
            fmu = load_closed_fmu(attribution.device, terms)
        for i in curved:
            part = first[i]
            ends = put_terms(part.device, terms, part.test.test.id), part.device
            on, off = replay_sampled_together(fmu, ends, part.test.inputs)
            answers = add_channels(part.simulated, {name: on[name] - off[name] for name in off})
            parts[i] = _linearize(simulation, attribution.nominal, part, answers, sizes)
        posterior = _search_around(attribution, parts)
        has_converged = _have_converged(posterior, sizes)
        if has_converged or number == MAX_ROUNDS or not _has_terms(posterior):
            posterior = compare_noises(posterior.best, parts, noises)
            has_converged = _have_converged(posterior, sizes)
        attribution = replace(attribution, parts=tuple(parts), posterior=posterior)
        if has_converged:
            break
    return attribution


def _has_terms(posterior: Posterior) -> bool:
    return any(isinstance(group, CandidateTerm) for group in posterior.best.ranking.best.groups)


def list_sizes(posterior: Posterior) -> dict[CandidateTerm, Array]:
    """Size of each term of the most probable set that can be written."""
    best = posterior.best.ranking.best
    return {
        group: size
        for group, size in best.sizes.items()
        if isinstance(group, CandidateTerm) and list_coefficients(group)
    }


def _list_curved(posterior: Posterior) -> dict[CandidateTerm, Array]:
    """Size of each of these terms whose response is linear only where it is small."""
    return {term: size for term, size in list_sizes(posterior).items() if term.is_curved}


def find_moved_tests(
    parts: Sequence[LinearTest], sizes: TermSizes, noise: CampaignNoise
) -> list[int]:
    """Indices of the tests in which terms of these sizes change the records by a chi-square of at
    least `NEGLIGIBLE_CHI2`."""

    def compute_changes(part: LinearTest) -> dict[str, Array]:
        return {name: compute_response(part.where, name, sizes) for name in CHANNELS}

    return _find_tests(parts, compute_changes, noise)


def find_curved_tests(
    parts: Sequence[LinearTest], sizes: TermSizes, noise: CampaignNoise
) -> list[int]:
    """Indices of the tests in which the linear response to terms of these sizes misses a chi-square
    of at least `NEGLIGIBLE_CHI2`. Elsewhere the FMU with them need not run."""
    return _find_tests(parts, partial(estimate_missed, sizes=sizes), noise) if sizes else []


def estimate_missed(part: LinearTest, sizes: TermSizes) -> dict[str, Array]:
    """(n,) by channel: what the linear response to terms of these sizes misses, because they turn
    the pattern and damp its free decay (docs/methods/equation.md, Eqs. 3a and 3b)."""
    where, slopes = part.where, part.by_angle.slopes["gyro_angle"]
    is_driven = part.test.log.is_driven  # what a free pattern does is in its linear response
    growth = np.maximum(shape_origin(part.bryan_factor, slopes), MIN_REMAINING_SHIFT)
    growth = np.where(is_driven, growth, 1.0)
    linear = {name: compute_response(where, name, sizes) for name in CHANNELS}
    angle = linear["gyro_angle"]
    decay = np.where(is_driven, 0.0, linear["amplitude"])
    moved = replace(
        where,
        pattern_angle=where.pattern_angle - part.bryan_factor * angle,
        amplitude=where.amplitude + decay,
        level=where.level + decay / 2,
    )
    missed = {name: compute_response(moved, name, sizes) - own for name, own in linear.items()}
    grown = growth * np.cumsum(np.diff(angle, prepend=0.0) / growth)
    return missed | {"gyro_angle": missed["gyro_angle"] + grown - angle}


def _find_tests(
    parts: Sequence[LinearTest],
    compute: Callable[[LinearTest], Mapping[str, Array]],
    noise: CampaignNoise,
) -> list[int]:
    """Indices of the tests in which (n,) changes by channel are not negligible."""

    def measure(part: LinearTest) -> float:
        changes = {name: change[:, None] for name, change in compute(part).items() if change.any()}
        white = [whiten_rows(part, *change, noise).series for change in changes.items()]
        return sum(float((series**2).sum()) for series in white)

    return [i for i, part in enumerate(parts) if measure(part) >= NEGLIGIBLE_CHI2]


def _search_around(attribution: Attribution, parts: Sequence[LinearTest]) -> Posterior:
    """The search with newly linearized tests, under the present noise."""
    best = attribution.posterior.best
    hypothesis = rank_with_forms(best.noise, parts, best)
    return Posterior((hypothesis,), (1.0,))


def _linearize(
    simulation: Simulation,
    nominal: Device,
    part: LinearTest,
    answers: ChannelValues,
    sizes: TermSizes,
) -> LinearTest:
    """A test linearized around a device with terms; its residual is referred to no terms.

    Other channels are compared at the measured angle, to which the terms have turned the pattern.
    What the terms add to the output angle's residual is therefore taken out of them again, but for
    errors of the reading, which make the comparison wrong.
    """
    around = linearize_test(
        simulation, nominal, part.device, part.test, answers, part.sensitivities
    )
    residual = dict(around.residual)
    for channel in residual:
        residual[channel] = residual[channel] + compute_response(around.where, channel, sizes)
    turned = residual["gyro_angle"] - around.residual["gyro_angle"]
    for term, values in build_reading_columns(around.where, sizes):
        turned = turned - values @ sizes[term]
    for channel in residual:
        if channel != "gyro_angle":
            turning = around.at_measured_angle(np.zeros((len(turned), 1)), turned[:, None], channel)
            residual[channel] = residual[channel] - turning[:, 0]
    return replace(around, residual=residual, simulated=part.simulated)


def _have_converged(posterior: Posterior, before: TermSizes) -> bool:
    """Whether the most probable set has the same terms, each where it was."""
    after, best = _list_curved(posterior), posterior.best.ranking.best
    if after.keys() != before.keys():
        return False
    return all(
        np.all(
            np.abs(size - before[term])
            <= CONVERGENCE_SIGMA * np.sqrt(np.diag(best.covariances[best.groups.index(term)]))
        )
        for term, size in after.items()
    )
