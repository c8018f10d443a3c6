"""What holds a navigator's height: left alone it runs away within the hour."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval import earth
from ins_eval.navigation import kernel

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Free:
    """Integrated like north and east; errors grow exponentially (by e in 9.4 min)."""

    mode = kernel.FREE
    gains = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Clamped:
    """Held to a reference: heights (n + 1,) at the bounds of the intervals, m."""

    heights: Array
    mode = kernel.CLAMPED
    gains = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class BaroDamped:
    """Drawn to a barometer by a third-order loop (Siouris 1993, section 4.5).

    heights: (n + 1,) barometric heights at the bounds of the intervals, m;
    time_constant: of its triple pole, s.
    """

    heights: Array
    time_constant: float = 100.0
    mode = kernel.DAMPED

    @property
    def gains(self) -> tuple[float, float, float]:
        """Of the height's, the velocity's and the integral's correction, 1/s, 1/s2, 1/s3."""
        rate = 1 / self.time_constant
        gravity, radius = earth.GRAVITY_EQUATOR, earth.SEMI_MAJOR
        return 3 * rate, 3 * rate**2 + 2 * gravity / radius, rate**3


Height = Free | Clamped | BaroDamped
