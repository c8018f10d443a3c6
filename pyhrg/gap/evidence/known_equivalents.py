"""Which effects and known parameters explain about as much in each other's place.

A known parameter that is off by more than its tolerance is a hypothesis of its own: its size then
has the prior of an effect's size, not that of its tolerance (docs/methods/verdict.md, "Equivalence
classes").
"""

import math
from collections.abc import Collection, Iterable, Sequence

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Group
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.evidence.evidence import EQUIVALENCE_LOG_ODDS, fit
from pyhrg.gap.evidence.hypothesis import make_feasibility_check


def find_known_equivalents(
    known: KnownParameters,
    groups: Sequence[Group],
    nominal: Device,
    cause: Effect,
    candidates: Iterable[Effect],
) -> tuple[str, ...]:
    """Names of the candidates that explain about as much as the cause in its place, beside the
    other groups of the most probable set. The cause or the candidate is a known parameter."""
    others = [group for group in groups if group != cause]
    threshold = _score_set(known, nominal, [*others, cause]) - EQUIVALENCE_LOG_ODDS
    return tuple(
        other.name
        for other in candidates
        if other not in (cause, *others)
        and _score_set(known, nominal, [*others, other]) > threshold
    )


def _score_set(known: KnownParameters, nominal: Device, groups: Collection[Group]) -> float:
    """Log likelihood of a set whose sizes are integrated out, up to a constant. Known parameters
    within it may have any size; all others have their tolerances. Minus infinity where the sizes
    can't be told apart or no gyro can have them."""
    tolerances = {e: size for e, size in known.tolerances.items() if e not in groups}
    design = KnownParameters(known.whole, tolerances).marginal
    if not set(groups) <= set(design.groups):
        return -math.inf
    fitted = fit(design, list(groups))
    effects = [group for group in groups if isinstance(group, Effect)]
    if fitted is None or not make_feasibility_check(nominal, effects)(fitted):
        return -math.inf
    return design.log_likelihood + fitted.log_evidence
