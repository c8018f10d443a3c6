"""Plans of an 8N-position test: which spacing sees what, and which does not.

The table moves the pattern: a step of the table turns it by -k times as much. Positions that lie
45 deg of pattern apart take the fourth harmonic at two phases only and alias it into their mean;
within one turn of the table the tilt of the input axis, once a turn, looks like the fourth
harmonic, four times in 3.61 turns. Turning the pattern by another 90 deg changes no harmonic of
order 4 and 8 and moves the table on by most of a turn: that separates them.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, TILT, design, harmonic, inflation
from pyhrg.common.units import DEG

Array = NDArray[np.float64]

HARMONICS = (2, 4, 8)
STARTS = np.arange(0.0, 90.0, 7.5) * DEG
"""Power-on angles that a plan is judged at: it is as good as at the worst of them."""


@dataclass(frozen=True)
class Plan:
    """Positions of the pattern, reached by the table from one to the next.

    pattern_step: rad between neighbours, positive as the table turns.
    """

    positions: int
    pattern_step: float
    bryan_factor: float = 0.277

    def __post_init__(self) -> None:
        if self.positions < 1 or self.positions % 8:
            raise ValueError(f"{self.positions} positions: expected 8, 16, 24, ...")

    @property
    def table_step(self) -> float:
        """Of the table between positions, rad."""
        return self.pattern_step / self.bryan_factor

    def angles(self, start: float = 0.0) -> tuple[Array, Array]:
        """Pattern and table angles (n,), rad, from a power-on angle of the pattern."""
        number = np.arange(self.positions, dtype=np.float64)
        return start - number * self.pattern_step, number * self.table_step

    def inflation(self, harmonics: Sequence[int] = HARMONICS, tilt: bool = True) -> float:
        """Largest factor, over terms and power-on angles, by which terms disturb each other."""
        return max(
            max(inflation(design(*self.angles(start), harmonics, tilt)).values())
            for start in STARTS
        )


def visible(
    pattern_angle: Array,
    table_angle: Array,
    wanted: Sequence[int] = HARMONICS,
    tilt: bool = True,
) -> tuple[list[int], bool, list[str]]:
    """What positions can tell apart.

    The fourth harmonic comes first, then tilt, then the others, as long as every term stays
    within `LARGEST_INFLATION` and two positions are left to show the scatter. Where the fourth, the
    largest of a whole-angle gyro, is not seen, nothing else is either: it would look like it.

    Args:
        pattern_angle, table_angle: (n,) positions, rad; all power-ons together.
        wanted: harmonics.
        tilt: whether the tilt of the input axis is wanted.

    Returns:
        Harmonics that are seen, whether tilt is, and a sentence on each that is not.
    """
    distinct = _distinct(pattern_angle, table_angle)
    seen: list[int] = []
    with_tilt = False
    refused = []
    order: list[int | None] = [*[h for h in (4,) if h in wanted]]
    order += [None] if tilt else []
    order += [h for h in wanted if h != 4]
    for term in order:
        trial = [*seen, term] if term is not None else seen
        columns = design(pattern_angle, table_angle, trial, with_tilt or term is None)
        worst = max(inflation(columns).values())
        name = "the tilt of the input axis" if term is None else f"harmonic {term}"
        if len(columns) + 2 > distinct:
            refused.append(
                f"{distinct} positions are too few to fit {name} as well "
                f"({len(columns)} terms and 2 to show the scatter)"
            )
        elif worst > LARGEST_INFLATION:
            factor = f"{worst:.3g} times" if math.isfinite(worst) else "infinitely"
            refused.append(
                f"the positions can't tell {name} from the other terms: "
                f"variance inflated {factor}, at most {LARGEST_INFLATION:g} is accepted"
            )
        elif term is None:
            with_tilt = True
        else:
            seen.append(term)
    if 4 in wanted and 4 not in seen:
        refused = [text for text in refused if "harmonic 4" in text]
        hidden = "nothing else is fitted, for harmonic 4 would show as tilt or as another harmonic"
        return [], False, [*refused, hidden]
    return sorted(seen), with_tilt, refused


def _distinct(pattern_angle: Array, table_angle: Array) -> int:
    """Number of different positions: pattern within 180 deg, table within a turn, to 1 deg."""
    pairs = np.column_stack([pattern_angle % math.pi, table_angle % (2 * math.pi)]) / DEG
    return len(np.unique(np.round(pairs), axis=0))


def chosen(
    positions: int,
    bryan_factor: float = 0.277,
    harmonics: Iterable[int] = HARMONICS,
    tilt: bool = True,
    largest_turns: float = 40.0,
) -> Plan:
    """The plan with the least disturbance between terms; of equals, the least turning.

    Only plans are considered whose positions go round the fourth harmonic a whole number of times,
    so that nothing of it is left in their mean.

    Args:
        positions: 8N.
        bryan_factor: of the gyro.
        harmonics: to be told apart; with 8 positions the fourth alone is.
        tilt: whether the tilt of the input axis is to be told from them.
        largest_turns: of the table, in all.
    """
    wanted = tuple(harmonics)
    share = 90.0 / positions
    plans = [
        Plan(positions, (part * share + 90.0 * more) * DEG, bryan_factor)
        for more in range(5)
        for part in range(1, positions)
    ]
    plans = [p for p in plans if positions * p.table_step <= largest_turns * 2 * math.pi]

    def badness(plan: Plan) -> tuple[float, float]:
        return round(plan.inflation(wanted, tilt), 1), plan.pattern_step

    return min(plans, key=badness)


def terms(harmonics: Sequence[int], tilt: bool) -> list[str]:
    """Names of the fit's terms beside the mean."""
    names = [name for order in harmonics for name in harmonic(order)]
    return [*names, *TILT] if tilt else names
