"""A bias that jumps at a moment of a test which no coordinate foretells."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.unknown import Coordinates, Element

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Jump(Element):
    """In one test, or in each of several.

    times: since power-on, s, by test.
    log_odds: prior, that jumps are there and then.
    """

    times: tuple[tuple[str, float], ...] = ()
    log_odds: float = 0.0

    @property
    def foretells(self) -> bool:
        """Whether it says anything of a test that is yet to be made."""
        return False

    def columns(self, where: Coordinates) -> Array:
        """(n, k) of a test, one for each jump."""
        test = where.test
        there = np.array([float(test.test.id == name) for name, _ in self.times])
        return there * after(test.log.time, np.array([t for _, t in self.times]))


def jump(times: Sequence[tuple[str, float]], log_odds: float) -> Jump:
    """One with its words; arguments as the class has them."""
    (test, time), *others = times
    where = f"at {time:.0f} s in {test}"
    many = f"{where}, and in {len(others)} other test{'s' if len(others) > 1 else ''}"
    words = f"bias: a jump {many if others else where}"
    return Jump("gyro_angle", "time", words, None, tuple(times), log_odds)


def after(rows: Array, times: Array) -> Array:
    """(n, k) output angle after jumps of the bias by one.

    Args:
        rows: (n,) s.
        times: (k,) of the jumps, s.
    """
    return np.asarray(np.maximum(rows[:, None] - times, 0.0))
