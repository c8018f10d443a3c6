"""What holds a navigator's height: left alone it runs away within the hour."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ins_eval.common import earth

Array = NDArray[np.float64]

Gains = tuple[float, float, float]


class VerticalChannel(NamedTuple):
    """A height's hold as the compiled navigator takes it.

    clamped: the reference is taken as it is; otherwise height is integrated and drawn to it.
    height: (m + 1,) reference at the bounds of the steps, m; climb: (m + 1,) its rate, m/s.
    gains: of the height's, the velocity's and the integral's correction, 1/s, 1/s^2, 1/s^3.
    """

    clamped: bool
    height: Array
    climb: Array
    gains: Gains


@dataclass(frozen=True)
class Free:
    """Integrated like north and east; errors grow exponentially (by e in 9.5 min)."""

    def channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """For `count` intervals, `samples` a step."""
        nothing = np.zeros(count // samples + 1)
        return VerticalChannel(False, nothing, nothing, (0.0, 0.0, 0.0))


@dataclass(frozen=True)
class Clamped:
    """Held to a reference: heights (n + 1,) at the bounds of the intervals, m."""

    heights: Array

    def channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """For `count` intervals, `samples` a step.

        Raises:
            ValueError: another number of heights, or heights that are not finite.
        """
        height = _at_steps(self.heights, count, samples)
        order: Literal[1, 2] = 2 if len(height) > 2 else 1
        climb = np.gradient(height, samples * interval, edge_order=order)
        return VerticalChannel(True, height, climb, (0.0, 0.0, 0.0))


@dataclass(frozen=True)
class BaroDamped:
    """Drawn to a barometer by a third-order loop (Siouris 1993, section 4.5).

    heights: (n + 1,) barometric heights at the bounds of the intervals, m;
    time_constant: of its triple pole, s.
    """

    heights: Array
    time_constant: float = 100.0

    @property
    def gains(self) -> Gains:
        """Of the height's, the velocity's and the integral's correction, 1/s, 1/s^2, 1/s^3."""
        rate = 1 / self.time_constant
        return 3 * rate, 3 * rate**2 + 2 * earth.GRAVITY_EQUATOR / earth.SEMI_MAJOR, rate**3

    def channel(self, count: int, samples: int, interval: float) -> VerticalChannel:
        """For `count` intervals, `samples` a step.

        Raises:
            ValueError: another number of heights, heights that are not finite, or a time constant
                that is not longer than a step.
        """
        if not samples * interval < self.time_constant < np.inf:
            raise ValueError(
                f"time constant of {self.time_constant:g} s: "
                f"expected longer than a step, {samples * interval:g} s"
            )
        height = _at_steps(self.heights, count, samples)
        return VerticalChannel(False, height, np.zeros_like(height), self.gains)


Height = Free | Clamped | BaroDamped


def _at_steps(heights: Array, count: int, samples: int) -> Array:
    if np.shape(heights) != (count + 1,):
        given = f"heights of shape {np.shape(heights)}"
        raise ValueError(f"{given}: expected ({count + 1},), at the bounds of {count} intervals")
    at_steps = np.array(heights[::samples], dtype=float)
    if not np.all(np.isfinite(at_steps)):
        first = int(np.flatnonzero(~np.isfinite(at_steps))[0])
        raise ValueError(f"height {first * samples} is {at_steps[first]}: expected finite, in m")
    return at_steps
