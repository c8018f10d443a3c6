"""How well groups of columns explain a residual, with their sizes integrated out.

Each group has a size that may be anything: its prior is flat in direction and in the logarithm of
its length, in deviations of the noise, from that of noise alone to `LARGEST`. The integral is
Laplace's (R. E. Kass, A. E. Raftery, J. Am. Stat. Assoc. 90 (1995), Eq. (3)).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve
from scipy.special import gammaln

from pyhrg.gap.effects.candidate_terms import Element
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group

Array = NDArray[np.float64]

LARGEST = 1e5
"""Deviations of the noise that an effect may have."""
SAME = 1e-7
"""Columns of which less than this share of variance is left beside others are the same."""
ALIKE = 1e-3
"""The same of elements, which are rough: what two of them, or one and an effect, differ by when
both are large says nothing."""


@dataclass(frozen=True)
class Fit:
    """A set of groups fitted to the residual.

    log_evidence: over that of nothing at all.
    explained: power of the residual that is explained, in deviations of the noise squared.
    values: (d,) of each group, per unit of its columns.
    covariance: (D, D) of all values, group after group.
    """

    groups: tuple[Group, ...]
    log_evidence: float
    explained: float
    values: tuple[Array, ...]
    covariance: Array

    @property
    def sizes(self) -> dict[Group, Array]:
        """Values by group."""
        return dict(zip(self.groups, self.values, strict=True))

    @property
    def covariances(self) -> dict[Group, Array]:
        """(d, d) of each group's own values."""
        ends = np.cumsum([len(values) for values in self.values]).tolist()
        parts = [slice(e - len(v), e) for e, v in zip(ends, self.values, strict=True)]
        own = [self.covariance[part, part] for part in parts]
        return dict(zip(self.groups, own, strict=True))

    @property
    def named(self) -> dict[Effect, Array]:
        """Those of the catalogue."""
        return {group: size for group, size in self.sizes.items() if isinstance(group, Effect)}


def fit(design: Design, groups: Sequence[Group]) -> Fit | None:
    """Fit groups; None where they are one and the same to these data."""
    if not groups:
        return Fit((), 0.0, 0.0, (), np.zeros((0, 0)))
    groups = sorted(groups, key=lambda group: isinstance(group, Element))
    where = np.concatenate([design.places[g] for g in groups])
    gram = design.gram[where[:, None], where]
    try:
        factor = cho_factor(gram)
    except LinAlgError:
        return None
    diagonal = np.diag(factor[0])
    least = np.repeat([least_left(g) for g in groups], [len(design.places[g]) for g in groups])
    if (diagonal**2 < least).any():
        return None
    unit = cho_solve(factor, design.pull[where])
    explained = float(design.pull[where] @ unit)
    scale = 1 / design.lengths[where]
    inverse = cho_solve(factor, np.eye(len(where)))
    log_evidence = explained / 2 - float(np.log(diagonal).sum())
    values, begin = [], 0
    for group in groups:
        part = slice(begin, begin + len(design.places[group]))
        own = gram[part, part]
        log_evidence += _log_prior(own, unit[part]) + (part.stop - begin) / 2 * math.log(
            2 * math.pi
        )
        values.append(unit[part] * scale[part])
        begin = part.stop
    return Fit(
        tuple(groups), log_evidence, explained, tuple(values), inverse * np.outer(scale, scale)
    )


def log_evidence(power: Array, size: int) -> Array:
    """Of groups whose columns are at right angles, over that of nothing.

    Args:
        power: of the residual that each explains, in deviations of the noise squared.
        size: columns of each.
    """
    length = np.sqrt(np.maximum(power, size))
    surface = math.log(2) + size / 2 * math.log(math.pi) - float(gammaln(size / 2))
    prior = -surface - size * np.log(length) - math.log(math.log(LARGEST))
    return np.asarray(power / 2 + size / 2 * math.log(2 * math.pi) + prior)


def least_left(group: Group) -> float:
    """Share of variance that a group's columns must have left beside others."""
    return ALIKE if isinstance(group, Element) else SAME


def _log_prior(information: Array, values: Array) -> float:
    """Density of a group's values where its own information is this."""
    d = len(values)
    length = math.sqrt(max(float(values @ information @ values), d))
    surface = math.log(2) + d / 2 * math.log(math.pi) - float(gammaln(d / 2))
    volume = float(np.linalg.slogdet(information)[1]) / 2
    return volume - surface - d * math.log(length) - math.log(math.log(LARGEST))
