"""How three gyros are mounted, and how the navigator believes they are."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.common.errors import HrgError

Array = NDArray[np.float64]

WORST_CONDITION = 20.0
"""Most that decoding may magnify one gyro's error against another's: condition number."""


class MountingError(HrgError):
    """The input axes don't span the three directions."""


@dataclass(frozen=True)
class Mounting:
    """Input axes of three gyros.

    axes: (3, 3), a row each, unit vectors in body axes; believed: likewise, as the navigator has
    them.
    """

    axes: Array
    believed: Array

    def sensed(self, vectors: Array) -> Array:
        """Components (n, 3) along the true input axes of vectors (n, 3) in body axes."""
        return vectors @ self.axes.T

    def decoded(self, components: Array) -> Array:
        """Vectors (n, 3) in body axes, as the navigator works them out from components (n, 3)."""
        return components @ np.linalg.inv(self.believed).T

    def disturbed(self, deviation: float, generator: np.random.Generator) -> "Mounting":
        """The same belief; each true axis tilted in two directions, deviation (rad) in each."""
        tilt = generator.normal(0.0, deviation, size=(3, 3))
        across = tilt - np.sum(tilt * self.axes, axis=1, keepdims=True) * self.axes
        return Mounting(unit_rows(self.axes + across), self.believed)


def mounted(directions: ArrayLike) -> Mounting:
    """A mounting that is known exactly, of directions (3, 3), a row each, of any length.

    Raises:
        MountingError: a direction of no length, or axes so nearly in a plane that the condition
            number is beyond `WORST_CONDITION`.
    """
    axes = unit_rows(np.asarray(directions, dtype=np.float64))
    condition = float(np.linalg.cond(axes))
    if not condition <= WORST_CONDITION:
        raise MountingError(
            f"found input axes of condition number {condition:.3g}, "
            f"expected at most {WORST_CONDITION:g}: are they in a plane?"
        )
    return Mounting(axes, axes)


def unit_rows(directions: Array) -> Array:
    """Rows (3, 3) of length one.

    Raises:
        MountingError: a row that is zero or not finite, or another shape.
    """
    if directions.shape != (3, 3):
        raise MountingError(f"found axes of shape {directions.shape}, expected (3, 3)")
    length = np.linalg.norm(directions, axis=1, keepdims=True)
    if not (np.isfinite(length) & (length > 0)).all():
        raise MountingError("found an input axis without direction, expected three that have one")
    return np.asarray(directions / length)


ORTHOGONAL = mounted(np.eye(3))
"""Along forward, right, down."""
