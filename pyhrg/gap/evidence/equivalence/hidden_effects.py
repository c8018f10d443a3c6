"""Effects that the records can't see beside the most probable set, and whose absence from it shifts
the sizes of its causes (omitted-variable bias).

A swap of one effect for another doesn't find them: a damping anisotropy makes two harmonics of the
bias, a mismatch of the drives one of the two, so that the first fits a gyro that has both.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95

HIDDEN_SHARE = 0.1
"""Size at which an effect is looked for, over its typical size. Chosen: well made gyros have a
tenth of it."""


@dataclass(frozen=True)
class HiddenEffect:
    """An effect outside the most probable set, at a tenth of its typical size.

    shifted: effects of the set whose sizes leave their 95 % intervals beside it.
    fit: the set with it, fitted to the same records.
    """

    effect: Effect
    shifted: tuple[Effect, ...]
    fit: Fit


def find_hidden_effects(
    design: Design, best: Fit, candidates: Iterable[Effect]
) -> list[HiddenEffect]:
    """Candidates that, at a tenth of their typical size and in their least visible direction,
    change chi-square by less than 1.96^2 once the set is fitted again, and shift the size of one of
    its effects by more than 1.96 standard deviations (docs/methods/verdict.md, Eq. (12))."""
    hidden = []
    for effect in candidates if best.groups else ():
        if effect in best.groups or not (design.norms[design.columns[effect]] > 0).all():
            continue
        size, power, shifts = _refit_beside(design, best, effect)
        groups = zip(best.groups, shifts, best.covariances, strict=True)
        shifted = tuple(
            group
            for group, shift, covariance in groups
            if isinstance(group, Effect)
            and shift @ np.linalg.solve(covariance, shift) > NORMAL_95**2
        )
        if power < NORMAL_95**2 and shifted:
            values = (*(v + s for v, s in zip(best.values, shifts, strict=True)), size)
            hidden.append(HiddenEffect(effect, shifted, _extend(best, effect, values)))
    return hidden


def _refit_beside(design: Design, best: Fit, effect: Effect) -> tuple[Array, float, list[Array]]:
    """Size of an effect in its least visible direction, SI; the change of chi-square by it once
    the set is fitted again; and the shift of each group's size."""
    own = design.columns[effect]
    parts = [design.columns[group] for group in best.groups]
    where = np.concatenate(parts)
    beside = design.gram[np.ix_(where, own)]
    response = -np.linalg.lstsq(design.gram[np.ix_(where, where)], beside)[0]
    free = design.gram[np.ix_(own, own)] + beside.T @ response
    norms = design.norms[own]
    powers, directions = np.linalg.eigh(free * np.outer(norms, norms))
    length = HIDDEN_SHARE * effect.scale
    size = length * directions[:, 0]
    shifts = response @ (norms * size) / design.norms[where]
    ends = np.cumsum([len(part) for part in parts])[:-1]
    return size, float(powers[0]) * length**2, np.split(shifts, ends)


def _extend(best: Fit, effect: Effect, values: tuple[Array, ...]) -> Fit:
    """The set with an effect whose size is not known."""
    covariances = (*best.covariances, effect.scale**2 * np.eye(effect.size))
    return replace(best, groups=(*best.groups, effect), values=values, covariances=covariances)
