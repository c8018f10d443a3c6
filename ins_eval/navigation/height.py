"""Height aiding of the navigator: without it the vertical channel diverges within the hour."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from ins_eval.common import earth
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

Gains = tuple[float, float, float]


class VerticalChannel(NamedTuple):
    """Height aiding in the form that the compiled navigator takes.

    Attributes:
        clamped: whether height and vertical velocity are those of the reference; otherwise they are
            integrated and corrected by feedback of their difference from it.
        height: (m + 1,) reference at the bounds of the m steps, m.
        climb: (m + 1,) its rate, m/s.
        gains: feedback to height, velocity and integral, 1/s, 1/s^2, 1/s^3.
    """

    clamped: bool
    height: Array
    climb: Array
    gains: Gains


@dataclass(frozen=True)
class Free:
    """No aiding: height is integrated like north and east. Its error grows e-fold in 9.5 min."""

    def make_channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """Make the channel for `count` intervals, `samples` of them a step."""
        zeros = np.zeros(count // samples + 1)
        return VerticalChannel(False, zeros, zeros, (0.0, 0.0, 0.0))


@dataclass(frozen=True)
class Clamped:
    """Height is set to a reference. heights: (n + 1,) at the bounds of the n intervals, m."""

    heights: Array

    def make_channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """Make the channel for `count` intervals, `samples` of them a step."""
        height = _pick_steps(self.heights, count, samples)
        order: Literal[1, 2] = 2 if len(height) > 2 else 1
        climb = np.gradient(height, samples * interval, edge_order=order)
        return VerticalChannel(True, height, climb, (0.0, 0.0, 0.0))


@dataclass(frozen=True)
class BaroDamped:
    """Height is corrected by a barometer through a third-order loop (Siouris 1993, section 4.5).

    Attributes:
        heights: (n + 1,) barometric heights at the bounds of the n intervals, m.
        time_constant: time constant of the loop's triple pole, s; the default is chosen.
    """

    heights: Array
    time_constant: float = 100.0

    @property
    def gains(self) -> Gains:
        """Feedback to height, velocity and integral, 1/s, 1/s^2, 1/s^3 (docs/methods/navigation.md,
        Eq. 14)."""
        rate = 1 / self.time_constant
        return 3 * rate, 3 * rate**2 + 2 * earth.GRAVITY_EQUATOR / earth.SEMI_MAJOR, rate**3

    def make_channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """Make the channel for `count` intervals, `samples` of them a step."""
        if not samples * interval < self.time_constant < np.inf:
            raise HrgError(
                f"time constant of {self.time_constant:g} s: "
                f"expected longer than a step, {samples * interval:g} s"
            )
        height = _pick_steps(self.heights, count, samples)
        return VerticalChannel(False, height, np.zeros_like(height), self.gains)


Height = Free | Clamped | BaroDamped
"""The kinds of height aiding that `navigate` takes."""


def _pick_steps(heights: Array, count: int, samples: int) -> Array:
    if np.shape(heights) != (count + 1,):
        given = f"heights of shape {np.shape(heights)}"
        raise HrgError(f"{given}: expected ({count + 1},), at the bounds of {count} intervals")
    at_steps = np.array(heights[::samples], dtype=float)
    if not np.all(np.isfinite(at_steps)):
        first = int(np.flatnonzero(~np.isfinite(at_steps))[0])
        raise HrgError(f"height {first * samples} is {at_steps[first]}: expected finite, in m")
    return at_steps
