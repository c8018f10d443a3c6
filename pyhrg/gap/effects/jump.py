"""A bias or an angle that jumps at a moment of a test which no coordinate foretells."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.effects.candidate_terms import Coordinates, Element

Array = NDArray[np.float64]


Kind = Literal["bias", "pattern", "output"]
"""What jumps: the bias, from then on; the pattern itself, at once; the output, as of counts that
were lost, while the pattern stays where it is."""


@dataclass(frozen=True)
class Jump(Element):
    """In one test, or in several.

    times: since power-on, s, by test.
    log_odds: prior, that jumps are there and then.
    kind: what jumps.
    """

    times: tuple[tuple[str, float], ...] = ()
    log_odds: float = 0.0
    kind: Kind = "bias"

    @property
    def foretells(self) -> bool:
        """Whether it says anything of a test that is yet to be made."""
        return False

    def columns(self, where: Coordinates) -> Array:
        """(n, k) of a test, one for each jump."""
        test = where.test
        there = np.array([float(test.test.id == name) for name, _ in self.times])
        moved = after if self.kind == "bias" else since
        return there * moved(test.log.time, np.array([t for _, t in self.times]))


def jump(times: Sequence[tuple[str, float]], log_odds: float) -> Jump:
    """Of the bias, with its words; arguments as the class has them."""
    others = len(times) - 1
    more = f", and in {others} other test{'s' if others > 1 else ''}" if others else ""
    words = f"bias: a jump {_where(*times[0])}{more}"
    return Jump("gyro_angle", "time", words, None, tuple(times), log_odds)


def step(times: Sequence[tuple[str, float]], log_odds: float, kind: Kind) -> Jump:
    """Of the pattern or of the output alone, with its words; arguments as the class has them."""
    what = "pattern" if kind == "pattern" else "output alone"
    words = f"{what}: a step {'; '.join(_where(*time) for time in times)}"
    return Jump("gyro_angle", "time", words, None, tuple(times), log_odds, kind)


def _where(test: str, time: float) -> str:
    return f"at {time:.6g} s in {test}"


def after(rows: Array, times: Array) -> Array:
    """(n, k) output angle after jumps of the bias by one.

    Args:
        rows: (n,) s.
        times: (k,) of the jumps, s.
    """
    return np.asarray(np.maximum(rows[:, None] - times, 0.0))


def since(rows: Array, times: Array) -> Array:
    """(n, k) output angle after steps of it by one; arguments as `after`, rows at the steps are
    behind them."""
    return np.asarray((rows[:, None] >= times).astype(np.float64))
