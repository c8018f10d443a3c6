"""Effects that the tests can't separate from one of the most probable set (equivalence class)."""

import math
from collections.abc import Sequence

from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group
from pyhrg.gap.evidence.evidence import Fit, fit

EQUIVALENCE_LOG_ODDS = math.log(20.0)
"""Two hypotheses are confounded when their log Bayes factor is below this. Chosen: 20 is the
boundary of "strong" evidence in Kass and Raftery (1995), Sect. 3.2."""


def find_equivalents(
    design: Design, best: Fit, effect: Effect, effects: Sequence[Effect]
) -> dict[Effect, Fit]:
    """Effects that explain about as much in the place of one (docs/methods/verdict.md, Eq. (2)).

    Args:
        design: normal equations around the gyro that the best set makes.
        best: most probable set.
        effect: the effect of that set to be replaced.
        effects: all effects of the catalogue.

    Returns:
        Each equivalent effect, with the set that it makes in the place of the other.
    """
    others: list[Group] = [g for g in best.groups if g != effect]
    equivalents = {}
    for other in effects:
        if other in best.groups or not (design.norms[design.columns[other]] > 0).all():
            continue
        swapped = fit(design, [*others, other])
        if swapped is not None and swapped.log_evidence > best.log_evidence - EQUIVALENCE_LOG_ODDS:
            equivalents[other] = swapped
    return equivalents
