"""Which effects and known parameters explain about as much in each other's place.

A known parameter that is off by more than its tolerance is a hypothesis of its own: its size then
has the prior of an effect's size, not that of its tolerance (docs/methods/verdict.md, "Equivalence
classes").
"""

import math
from collections.abc import Collection, Iterable

import numpy as np

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.evidence import EQUIVALENCE_LOG_ODDS, Fit, fit
from pyhrg.gap.evidence.hypothesis import compute_sigma_along, make_feasibility_check
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95


def find_known_equivalents(
    known: KnownParameters,
    best: Fit,
    nominal: Device,
    cause: Effect,
    candidates: Iterable[Effect],
) -> tuple[str, ...]:
    """Names of the candidates that explain about as much as the cause in its place, beside the
    other groups of the most probable set. The cause or the candidate is a known parameter. The
    candidate's set explains more than these groups alone do, and in it no other known parameter is
    beyond its tolerance than beside the cause."""
    others = [group for group in best.groups if group != cause]
    allowed = _find_beyond(known, best) - {cause}
    alone = _score_set(known, nominal, others, known.effects)
    freed = _score_set(known, nominal, [*others, cause], allowed)
    threshold = max(alone, max(freed, best.log_evidence) - EQUIVALENCE_LOG_ODDS)
    return tuple(
        other.name
        for other in candidates
        if other not in (cause, *others)
        and _score_set(known, nominal, [*others, other], allowed) > threshold
    )


def _score_set(
    known: KnownParameters,
    nominal: Device,
    groups: Collection[Group],
    allowed: Collection[Effect],
) -> float:
    """Log evidence of a set; of known parameters that are no groups of it, only the allowed ones
    may be beyond their tolerance. Minus infinity where others are, the sizes can't be told apart,
    or no gyro has them."""
    design = known.marginal
    if not set(groups) <= set(design.groups):
        return -math.inf
    fitted = fit(design, list(groups))
    effects = [group for group in groups if isinstance(group, Effect)]
    if fitted is None or not make_feasibility_check(nominal, effects)(fitted):
        return -math.inf
    return fitted.log_evidence if _find_beyond(known, fitted) <= {*allowed, *groups} else -math.inf


def _find_beyond(known: KnownParameters, fitted: Fit) -> set[Effect]:
    """Known parameters whose 95 % interval lies beyond their tolerance beside a set."""
    sizes, covariances = known.estimate(fitted.sizes), known.compute_covariances(fitted.groups)
    return {
        effect
        for effect, size in ((e, sizes[e]) for e in known.effects)
        if float(np.linalg.norm(size)) - known.tolerances[effect]
        > NORMAL_95 * compute_sigma_along(size, covariances[effect])
    }
