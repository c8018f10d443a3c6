"""Random numbers of one maker: a share of each mechanism's deviate is the same in all its gyros."""

import math
from typing import Any

import numpy as np

MAKER = 0
"""Seed of the maker's own deviates: any number, the same for all gyros. Chosen."""


class MakersGenerator(np.random.Generator):
    """A gyro's generator whose normal deviates correlate with those of all other gyros.

    Draws of the same order in different gyros have the correlation `common`; the distribution of
    each is as before. Uniform draws are the gyro's own.
    """

    def __init__(self, own: np.random.Generator, common: float) -> None:
        """Take over a gyro's generator; `common` is a share of the variance, 0 to 1."""
        super().__init__(own.bit_generator)
        self._maker = np.random.default_rng(MAKER)
        self._shares = math.sqrt(common), math.sqrt(1 - common)

    def normal(self, loc: Any = 0.0, scale: Any = 1.0, size: Any = None) -> Any:
        """Normal deviates, as `numpy.random.Generator.normal`."""
        maker, own = self._maker.standard_normal(size), super().standard_normal(size)
        return loc + scale * (self._shares[0] * maker + self._shares[1] * own)
