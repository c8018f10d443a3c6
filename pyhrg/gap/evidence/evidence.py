"""Marginal likelihood (evidence) of sets of groups by Laplace's method.

A group is an effect or a candidate term with its d columns. The prior of its size is flat in
direction and in the logarithm of its length in sigma, and that of an effect falls beyond its
typical size (docs/methods/evidence.md, Eqs. (3) to (4a); R. E. Kass, A. E. Raftery, J. Am. Stat.
Assoc. 90 (1995), Eq. (3)).
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import accumulate
from typing import TypeVar

import numpy as np
from scipy.linalg.lapack import dpotrf, dpotrs

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.effects.linear_test import Group

AnyGroup = TypeVar("AnyGroup", bound=Group)

MAX_PRIOR_SIZE_SIGMA = 1e5
"""Upper end of the prior of a group's size, in sigma: s_max of Eq. (4). Chosen; a factor of ten
changes a log evidence by 0.2."""
EFFECT_MIN_VARIANCE = 1e-7
"""An effect is collinear with others when these leave less than this share of its columns' power.
Chosen: of an effect of 1e5 sigma (`MAX_PRIOR_SIZE_SIGMA`), 30 sigma then remain."""
TERM_MIN_VARIANCE = 1e-3
"""A candidate term is collinear with others when these leave less than this share of its columns'
power. Terms are approximate shapes: a small difference between two large terms has no meaning.
Chosen."""


EQUIVALENCE_LOG_ODDS = math.log(20.0)
"""Two hypotheses are confounded when their log Bayes factor is below this. Chosen: 20 is the
boundary of "strong" evidence in Kass and Raftery (1995), Sect. 3.2."""

# Prior odds of all that may take part (Eqs. (6), (12), (14), (15)): how often a campaign is
# expected to show each kind of gap. All are chosen. A factor of two changes log odds by 0.7; an
# effect of 6 sigma has a log evidence of about 15.
EFFECT_ODDS = 0.25
"""Some effect of the catalogue takes part, shared equally among the effects."""
BEYOND_ODDS = 0.25
"""Some known parameter is off by far more than its tolerance, shared equally."""
NOISE_ODDS = 0.05
"""A given noise of the catalogue exceeds its stated level."""
UNNAMED_ODDS = 0.05
"""Something outside the catalogue takes part: a candidate term, shared equally among these; the
same odds for an unnamed noise, shared among its correlation times."""
HALF_UNNAMED_ODDS = UNNAMED_ODDS / 2
"""An event that no coordinate predicts takes part. Each of six kinds has these odds: a jump of the
bias, a step of an angle, a line in the residual, a stretch of other noise, noise in spells, far
more than noise."""


@dataclass(frozen=True)
class Fit:
    """A set of groups fitted to the residual by least squares.

    log_evidence: logarithm of the Bayes factor of this set over the empty set.
    explained: decrease of chi-square by the fit.
    values: (d,) size of each group, in units of its columns (SI for an effect).
    covariances: (d, d) of each group's own size.
    """

    groups: tuple[Group, ...]
    log_evidence: float
    explained: float
    values: tuple[Array, ...]
    covariances: tuple[Array, ...]

    @property
    def sizes(self) -> dict[Group, Array]:
        """(d,) size of each group."""
        return dict(zip(self.groups, self.values, strict=True))

    @property
    def named(self) -> dict[Effect, Array]:
        """(d,) size of each effect of the catalogue."""
        return {group: size for group, size in self.sizes.items() if isinstance(group, Effect)}


NO_GROUPS = Fit((), 0.0, 0.0, (), ())
"""The empty set."""


def fit(design: Design, groups: Sequence[Group]) -> Fit | None:
    """Fit a set of groups (Eq. (3)); None where some of them are collinear in these tests, or where
    an effect and a candidate term are the same function: what has a name is not shared with what
    has none."""
    if not groups:
        return NO_GROUPS
    same = design.namesakes
    if any(same[g] in groups for g in groups if isinstance(g, Effect) and g in same):
        return None
    groups = sorted(groups, key=lambda group: isinstance(group, CandidateTerm))
    columns = [design.columns[group] for group in groups]
    sizes = [len(own) for own in columns]
    where = np.concatenate(columns)
    norms = design.norms[where]
    if not norms.all():
        return None
    gram = design.gram[where[:, None], where]
    factor, failed = dpotrf(gram)
    diagonal = factor.diagonal()
    pairs = zip(groups, sizes, strict=True)
    limits = [limit for g, size in pairs for limit in [get_min_free_variance(g)] * size]
    if failed or (diagonal**2 < limits).any():
        return None
    projection = design.projection[where]
    unit = dpotrs(factor, projection)[0]
    explained = float(projection @ unit)
    log_evidence = explained / 2 - float(np.log(diagonal).sum())
    scale = 1 / norms
    values = unit * scale
    parts = [slice(end - size, end) for end, size in zip(accumulate(sizes), sizes, strict=True)]
    sigmas, lengths = norms.tolist(), _measure_lengths(gram, unit, parts)
    for group, part, length in zip(groups, parts, lengths, strict=True):
        log_evidence += _compute_log_prior(design, group, length, values[part], sigmas[part])
    covariance = dpotrs(factor, np.eye(len(where)))[0] * (scale[:, None] * scale)
    return Fit(
        tuple(groups),
        log_evidence,
        explained,
        tuple([values[part] for part in parts]),
        tuple([covariance[part, part] for part in parts]),
    )


def _measure_lengths(gram: Array, unit: Array, parts: Sequence[slice]) -> list[float]:
    """Length of each group's part of a vector, in sigma."""
    numbers, own = unit.tolist(), gram.diagonal().tolist()
    return [
        math.sqrt(numbers[part.start] * own[part.start] * numbers[part.start])
        if part.stop - part.start == 1
        else math.sqrt(float(unit[part] @ gram[part, part] @ unit[part]))
        for part in parts
    ]


def _compute_log_prior(
    design: Design, group: Group, length: float, values: Array, norms: Sequence[float]
) -> float:
    """What the prior of a group's size adds to the log evidence, at a size of this length in sigma
    (Eqs. (4), (4a))."""
    size = len(values)
    log_density = _compute_prior_constant(size) - size * math.log(max(length, math.sqrt(size)))
    if not isinstance(group, Effect) or not length:
        return log_density + design.log_volumes[group]
    magnitude = math.hypot(*values)
    log_norms = sum(map(math.log, norms))
    log_density += size * math.log(length / magnitude) - log_norms
    over_typical = magnitude / group.scale
    return log_density - math.log1p(
        over_typical if group.family == "gyro" else min(over_typical, length)
    )


def compute_log_evidence(power: Array, size: int) -> Array:
    """Log evidence of a single group of `size` orthonormal columns over the empty set (Eq. (5)),
    for each of the (n,) decreases of chi-square by it."""
    length = np.sqrt(np.maximum(power, size))
    return np.asarray(power / 2 + _compute_prior_constant(size) - size * np.log(length))


def get_min_free_variance(group: Group) -> float:
    """Share of a group's power that other groups must leave for the group to be fitted at all."""
    return TERM_MIN_VARIANCE if isinstance(group, CandidateTerm) else EFFECT_MIN_VARIANCE


@cache
def _compute_prior_constant(d: int) -> float:
    """What the prior of a size with d components adds to any log evidence (Eqs. (4), (5))."""
    log_sphere_area = math.log(2) + d / 2 * math.log(math.pi) - math.lgamma(d / 2)
    return (
        d / 2 * math.log(2 * math.pi) - log_sphere_area - math.log(math.log(MAX_PRIOR_SIZE_SIGMA))
    )


def find_equivalents(
    design: Design, best: Fit, group: Group, candidates: Iterable[AnyGroup]
) -> dict[AnyGroup, Fit]:
    """Candidates that explain about as much in the place of a group of the most probable set, each
    with the set that it makes there (docs/methods/verdict.md, Eq. (2)). The normal equations are
    those around the gyro that this set makes."""
    others: list[Group] = [g for g in best.groups if g != group]
    equivalents = {}
    for other in candidates:
        if other in best.groups:
            continue
        swapped = fit(design, [*others, other])
        if swapped is not None and swapped.log_evidence > best.log_evidence - EQUIVALENCE_LOG_ODDS:
            equivalents[other] = swapped
    return equivalents
