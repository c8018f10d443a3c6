"""Plans of an 8N-position test, and the terms that their positions can separate.

A table step turns the pattern by -k times as much. Positions 45 deg of pattern angle apart sample
the fourth harmonic at two phases only and alias it into their mean. Within one table turn, the tilt
of the input axis (once a turn) is confounded with the fourth harmonic (four times in 3.61 turns).
Steps that are 90 deg longer leave the harmonics 4 and 8 as they are and turn the table by 0.9 of a
turn more, which separates the two.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, compute_inflations, make_columns
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

HARMONICS = (2, 4, 8)
"""Orders of the bias map in the pattern angle."""
STARTS = np.arange(0.0, 90.0, 7.5) * DEG
"""Start angles of the pattern, rad, for the worst of which a plan is rated."""

LARGEST_TURNS = 40.0
"""Most turns of the table in a plan that is chosen."""


@dataclass(frozen=True)
class Plan:
    """Positions of the pattern that the table reaches one after the other.

    pattern_step: between neighbours, rad: by how much the pattern angle falls while the table turns
        in its positive direction.
    bryan_factor: angular gain of the gyro.
    """

    positions: int
    pattern_step: float
    bryan_factor: float = 0.277

    def __post_init__(self) -> None:
        if self.positions < 1 or self.positions % 8:
            raise ValueError(f"{self.positions} positions: expected 8, 16, 24, ...")

    @property
    def table_step(self) -> float:
        """Table angle between positions, rad."""
        return self.pattern_step / self.bryan_factor

    def angles(self, start: float = 0.0) -> tuple[Array, Array]:
        """Pattern and table angles (n,), rad, for a start angle of the pattern."""
        number = np.arange(self.positions, dtype=np.float64)
        return start - number * self.pattern_step, number * self.table_step

    def inflation(self) -> float:
        """Largest variance inflation factor over terms and start angles."""
        columns = (make_columns(*self.angles(start), HARMONICS, tilt=True) for start in STARTS)
        return max(max(compute_inflations(each).values()) for each in columns)


def select_visible(
    pattern_angle: Array, table_angle: Array, wanted: Sequence[int] = HARMONICS, tilt: bool = True
) -> tuple[list[int], bool, list[str]]:
    """Terms of the bias map that positions can separate.

    The fourth harmonic is tried first, then the tilt, then the other harmonics. A term is accepted
    if all variance inflation factors stay within `LARGEST_INFLATION` and the positions outnumber
    the terms by two. Without the fourth harmonic, the largest of a whole-angle gyro, no term is
    accepted, for it would alias into them. Positions are (n,) rad, of all power-ons together.
    Returns accepted harmonics, whether the tilt is accepted, and a sentence on each term that is
    not.
    """
    pairs = np.column_stack([pattern_angle % math.pi, table_angle % (2 * math.pi)]) / DEG
    distinct = len(np.unique(np.round(pairs), axis=0))  # that differ by 1 deg or more
    accepted: list[int] = []
    with_tilt = False
    refused = []
    harmonics = sorted(wanted, key=lambda order: order != 4)
    first = harmonics[: int(4 in wanted)]
    for term in (*first, *([None] if tilt else []), *harmonics[len(first) :]):
        trial = [*accepted, term] if term is not None else accepted
        columns = make_columns(pattern_angle, table_angle, trial, with_tilt or term is None)
        worst = max(compute_inflations(columns).values())
        name = "the tilt of the input axis" if term is None else f"harmonic {term}"
        if len(columns) + 2 > distinct:
            refused.append(
                f"{distinct} positions are too few to fit {name} as well "
                f"({len(columns)} terms and 2 to show the scatter)"
            )
        elif worst > LARGEST_INFLATION:
            factor = f"{worst:.3g} times" if math.isfinite(worst) else "infinitely"
            refused.append(
                f"the positions can't separate {name} from the other terms: "
                f"variance inflated {factor}, at most {LARGEST_INFLATION:g} is accepted"
            )
        elif term is None:
            with_tilt = True
        else:
            accepted.append(term)
    if 4 in wanted and 4 not in accepted:
        refused = [text for text in refused if "harmonic 4" in text]
        hidden = "nothing else is fitted, for harmonic 4 would show as tilt or as another harmonic"
        return [], False, [*refused, hidden]
    return sorted(accepted), with_tilt, refused


def choose_plan(positions: int, bryan_factor: float = 0.277) -> Plan:
    """The plan with the smallest variance inflation; of equal plans, that with the shortest steps.

    Only plans are considered whose positions fill whole periods of the fourth harmonic, so that
    their mean holds none of it, and that take no more turns of the table than `LARGEST_TURNS`.
    """
    share = 90.0 / positions
    plans = [
        Plan(positions, (part * share + 90.0 * more) * DEG, bryan_factor)
        for more in range(5)
        for part in range(1, positions)
    ]
    plans = [p for p in plans if positions * p.table_step <= LARGEST_TURNS * 2 * math.pi]
    return min(plans, key=lambda plan: (round(plan.inflation(), 1), plan.pattern_step))
