"""How far a gap closed, beside what noise alone leaves."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.closing.verification import Distance, Floor, distance, floor, whiteness
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import Gap, GapFigure
from pyhrg.gap.replay.observations import Observed

Array = NDArray[np.float64]

SEED = 1
"""Of the draws of noise that make the floor."""


def gap_figures(
    tests: Sequence[Observed],
    before: Sequence[Array],
    after: Sequence[Array],
    found: Attribution,
) -> Gap:
    """Before, after and the floor, on tests that were fitted to and on those held out.

    Args:
        tests: observed.
        before, after: (n,) residual of the output angle for each test, rad; NaN is left out.
        found: by the search.
    """
    fitted = [i for i, t in enumerate(tests) if not t.test.is_holdout]
    held = [i for i, t in enumerate(tests) if t.test.is_holdout]

    def figures(chosen: Sequence[int]) -> tuple[GapFigure, GapFigure | None]:
        own = [tests[i] for i in chosen]
        ends = [distance(own, [r[i] for i in chosen]) for r in (before, after)]
        return _figures(ends[0], ends[1], floor(own, found.noise.noise, SEED))

    if not held:
        return Gap(*figures(fitted), None, None, None, None)
    kept = figures(held)
    left = [after[i] for i in held]
    white = whiteness([tests[i] for i in held], left, found.noise.noise)
    return Gap(*figures(fitted), *kept, _shrink(kept[0]), white)


def _figures(before: Distance, after: Distance, noise: Floor) -> tuple[GapFigure, GapFigure | None]:
    def figure(field: str, unit: float) -> GapFigure:
        own = getattr(noise, field)
        return GapFigure(
            getattr(before, field) / unit,
            getattr(after, field) / unit,
            own.value / unit,
            (own.interval[0] / unit, own.interval[1] / unit),
        )

    rate = figure("rate", DEG_PER_H) if math.isfinite(before.rate) else None
    return figure("angle", ARCSEC), rate


def _shrink(figure: GapFigure) -> float | None:
    """Of the excess over the floor; none where there is no excess."""
    if figure.before <= figure.floor_95[1]:
        return None
    return 100 * (figure.before - figure.after) / (figure.before - figure.floor)
