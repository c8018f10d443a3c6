"""What is commanded of a triad in a mission: start angles, virtual rotation, turns of its case."""

from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.linear_model import AXES
from pyhrg.common.arrays import Array

VERTICAL = 2
"""Axis about which the case is turned."""


@dataclass(frozen=True)
class Sweep:
    """An angle that goes to and fro at a constant speed.

    Attributes:
        rate: rad/s, from the start on; 0 is an angle that stays.
        span: angle after which the rate changes its sign, rad.
        start: rad.
    """

    rate: float = 0.0
    span: float = np.inf
    start: float = 0.0

    def angle(self, since: Array) -> Array:
        """Angle at times since power-on, s, rad."""
        way = abs(self.rate) * since
        if np.isfinite(self.span):
            way = self.span - np.abs(self.span - np.mod(way, 2 * self.span))
        return np.asarray(self.start + np.sign(self.rate) * way)


STILL_ANGLE = Sweep()
PATTERN_PERIOD = np.pi / ANGULAR_GAIN
"""Virtual rotation that turns a pattern by half a turn, the period of its map, rad."""


TAKES_MEAN = (True, True, True)
LEVEL_AT_START = (False, False, True)
"""Gyros of which the map's mean is taken out: of all; of the vertical one alone, whose pattern the
vehicle's turns take all round."""


@dataclass(frozen=True)
class Schedule:
    """Commands from power-on; by default there are none.

    Attributes:
        start_angles: (3,) angles at which the patterns start, rad; None is the gyro's own.
        virtual_rotation: (3,) turns of the patterns, as input rates.
        case: turn of the triad's case about the vehicle's downward axis.
        takes_mean: (3,) whether the map's mean is taken out of a gyro's output, or the bias by its
            map where its pattern starts.
    """

    start_angles: tuple[float | None, ...] = (None,) * AXES
    virtual_rotation: tuple[Sweep, ...] = (STILL_ANGLE,) * AXES
    case: Sweep = STILL_ANGLE
    takes_mean: tuple[bool, ...] = LEVEL_AT_START


def turn_into_case(values: Array, angle: Array) -> Array:
    """(n, 3) components in body axes along the axes of a case that is turned by angles (n,), rad,
    about the third."""
    cos, sin = np.cos(angle), np.sin(angle)
    x, y, z = values.T
    return np.stack([cos * x + sin * y, cos * y - sin * x, z], axis=1)
