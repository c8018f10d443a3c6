"""Which fits a gyro can have: a delay below zero may fit the records, but no gyro has it."""

import math
from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.noise.noise_search import NORMAL_95

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Possible:
    """Judges fits by the bounds of their effects' parameters.

    believed: the gyro that sizes count from.
    effects: of the catalogue.
    """

    believed: Device
    effects: Collection[Effect]
    _known: dict[Effect, tuple[Array, float, float]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        known = {e: (e.vector(self.believed), *e.bounds) for e in self.effects}
        object.__setattr__(self, "_known", known)

    def __call__(self, fit: Fit) -> bool:
        """Whether no effect is beyond its bounds by more than its 95 % interval."""
        return all(
            (beyond := self._beyond(effect, size)) <= 0
            or beyond <= NORMAL_95 * _spread(size, fit.covariances[effect])
            for effect, size in fit.named.items()
        )

    def _beyond(self, effect: Effect, size: Array) -> float:
        """How far, SI; no more than 0 within."""
        vector, low, high = self._known[effect]
        total = vector + size
        if effect.periods:
            return math.hypot(*total) - high
        return max(low - float(total[0]), float(total[0]) - high)


def _spread(size: Array, covariance: Array) -> float:
    """Standard deviation along a size."""
    along = size / (math.hypot(*size) or 1.0)
    return math.sqrt(float(along @ covariance @ along))
