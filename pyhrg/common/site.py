"""Where a gyro is tested."""

import math
from dataclasses import dataclass

from pyhrg.common.units import DEG

EARTH_RATE = 7.292115e-5
"""Earth's rotation rate, rad/s (WGS-84)."""


@dataclass(frozen=True)
class Site:
    """A laboratory, SI; by default the paper's, at 39.9 deg north."""

    latitude: float = 39.9 * DEG
    """Geodetic latitude, rad."""
    gravity: float = 9.8015
    """Local gravity, m/s2."""

    @property
    def vertical_rate(self) -> float:
        """Component of Earth's rate on local up, rad/s."""
        return EARTH_RATE * math.sin(self.latitude)

    @property
    def horizontal_rate(self) -> float:
        """Component of Earth's rate on local north, rad/s."""
        return EARTH_RATE * math.cos(self.latitude)
