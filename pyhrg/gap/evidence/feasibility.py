"""Which fits are feasible: a negative delay may fit the records, but no gyro has one."""

import math
from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Feasibility:
    """Checks fits against the bounds of the effects' parameters.

    nominal: the gyro that sizes count from.
    effects: effects of the catalogue.
    """

    nominal: Device
    effects: Collection[Effect]
    _bounds: dict[Effect, tuple[Array, float, float]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        bounds = {e: (e.vector(self.nominal), *e.bounds) for e in self.effects}
        object.__setattr__(self, "_bounds", bounds)

    def __call__(self, fit: Fit) -> bool:
        """Whether every effect is within its bounds, or outside by less than its 95 % interval."""
        return all(
            (excess := self._excess(effect, size)) <= 0
            or excess <= NORMAL_95 * _sigma_along(size, fit.covariances[effect])
            for effect, size in fit.named.items()
        )

    def _excess(self, effect: Effect, size: Array) -> float:
        """Distance outside the bounds, SI; zero or negative within them."""
        vector, low, high = self._bounds[effect]
        total = vector + size
        if effect.periods:
            return math.hypot(*total) - high
        return max(low - float(total[0]), float(total[0]) - high)


def _sigma_along(size: Array, covariance: Array) -> float:
    """Standard deviation of a size along its own direction."""
    along = size / (math.hypot(*size) or 1.0)
    return math.sqrt(float(along @ covariance @ along))
