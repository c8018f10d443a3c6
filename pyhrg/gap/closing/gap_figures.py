"""How far closing shrinks the gap, with the noise floor."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.closing.verification import (
    Distance,
    Floor,
    compute_whiteness,
    estimate_noise_floor,
    measure_distance,
)
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import Gap, GapFigure
from pyhrg.gap.replay.observations import ObservedTest

Array = NDArray[np.float64]

SEED = 1
"""Seed of the noise draws that make the floor."""


def compute_gap_figures(
    tests: Sequence[ObservedTest],
    before: Sequence[Array],
    after: Sequence[Array],
    attribution: Attribution,
) -> Gap:
    """Residuals before and after closing with the noise floor, on fitted and on held-out tests.

    Args:
        tests: all tests that were used.
        before, after: (n,) residual of the output angle in each test, rad; NaN is left out.
        attribution: result of the search; its noise of the output angle makes the floor.
    """
    fitted = [i for i, t in enumerate(tests) if not t.test.is_holdout]
    held_out = [i for i, t in enumerate(tests) if t.test.is_holdout]
    noise = attribution.noise.noise

    def figures(indices: Sequence[int]) -> tuple[GapFigure, GapFigure | None]:
        chosen = [tests[i] for i in indices]
        ends = [measure_distance(chosen, [r[i] for i in indices]) for r in (before, after)]
        return _figures(ends[0], ends[1], estimate_noise_floor(chosen, noise, SEED))

    if not held_out:
        return Gap(*figures(fitted), None, None, None, None)
    angle, rate = figures(held_out)
    residuals = [after[i] for i in held_out]
    whiteness = compute_whiteness([tests[i] for i in held_out], residuals, noise)
    return Gap(*figures(fitted), angle, rate, _shrink_percent(angle), whiteness)


def _figures(before: Distance, after: Distance, floor: Floor) -> tuple[GapFigure, GapFigure | None]:
    def figure(field: str, unit: float) -> GapFigure:
        spread = getattr(floor, field)
        return GapFigure(
            getattr(before, field) / unit,
            getattr(after, field) / unit,
            spread.value / unit,
            (spread.interval[0] / unit, spread.interval[1] / unit),
        )

    rate = figure("rate", DEG_PER_H) if math.isfinite(before.rate) else None
    return figure("angle", ARCSEC), rate


def _shrink_percent(figure: GapFigure) -> float | None:
    """Share of the excess over the floor that closing removes (docs/methods/verdict.md, Eq. (5));
    None where there is no excess."""
    if figure.before <= figure.floor_95[1]:
        return None
    return 100 * (figure.before - figure.after) / (figure.before - figure.floor)
