"""Effects that the data can't tell from a found one: put in its place, they explain as much."""

import math
from collections.abc import Sequence

from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group
from pyhrg.gap.evidence.evidence import Fit, fit

ALIKE = math.log(20.0)
"""Evidence that sets of effects may differ by and still both be possible."""


def equivalents(
    design: Design, best: Fit, effect: Effect, effects: Sequence[Effect]
) -> dict[Effect, Fit]:
    """Effects that may stand in the place of one, and the sets that they then make.

    Args:
        design: around the gyro that the best set makes.
        best: most probable set.
        effect: of that set.
        effects: of the catalogue.
    """
    others: list[Group] = [g for g in best.groups if g != effect]
    found = {}
    for other in effects:
        if other in best.groups or not (design.lengths[design.places[other]] > 0).all():
            continue
        instead = fit(design, [*others, other])
        if instead is not None and instead.log_evidence > best.log_evidence - ALIKE:
            found[other] = instead
    return found
