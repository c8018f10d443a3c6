"""Mounting of three gyros: their true input axes, and those that the navigator assumes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

MAX_CONDITION_NUMBER = 20.0
"""Largest condition number of the input axes. Chosen: decoding amplifies errors by up to it."""


class MountingError(HrgError):
    """The input axes do not span three dimensions."""


@dataclass(frozen=True)
class Mounting:
    """Input axes of three gyros, unit vectors in body axes, one a row.

    Attributes:
        axes: (3, 3) true input axes.
        assumed: (3, 3) input axes that the navigator assumes.
    """

    axes: Array
    assumed: Array

    def project(self, vectors: Array) -> Array:
        """Project vectors (n, 3) in body axes onto the true input axes (n, 3)."""
        return vectors @ self.axes.T

    def decode(self, components: Array) -> Array:
        """Return vectors (n, 3) in body axes that the navigator computes from components (n, 3)."""
        return components @ np.linalg.inv(self.assumed).T

    def disturb(self, deviation: float, generator: np.random.Generator) -> "Mounting":
        """Draw a mounting error: tilt each true axis by `deviation`, rad, in two directions."""
        tilt = generator.normal(0.0, deviation, size=(3, 3))
        across = tilt - np.sum(tilt * self.axes, axis=1, keepdims=True) * self.axes
        return Mounting(normalize_rows(self.axes + across), self.assumed)


def make_mounting(directions: ArrayLike) -> Mounting:
    """Make a mounting that is known exactly, from directions (3, 3) of any length, one a row."""
    axes = normalize_rows(np.asarray(directions, dtype=np.float64))
    condition = float(np.linalg.cond(axes))
    if not condition <= MAX_CONDITION_NUMBER:
        raise MountingError(
            f"found input axes of condition number {condition:.3g}, "
            f"expected at most {MAX_CONDITION_NUMBER:g}: are they in a plane?"
        )
    return Mounting(axes, axes)


def normalize_rows(directions: Array) -> Array:
    """Return rows (3, 3) of length one."""
    if directions.shape != (3, 3):
        raise MountingError(f"found axes of shape {directions.shape}, expected (3, 3)")
    length = np.linalg.norm(directions, axis=1, keepdims=True)
    if not (np.isfinite(length) & (length > 0)).all():
        raise MountingError("found an input axis without direction, expected three that have one")
    return np.asarray(directions / length)


ORTHOGONAL = make_mounting(np.eye(3))
"""Input axes along forward, right and down."""
