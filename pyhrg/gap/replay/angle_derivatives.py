"""Derivatives of a replay by the present pattern angle (docs/methods/replay.md, Eqs. 7 to 7b)."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.gap.replay.observations import CHANNELS, see_angles
from pyhrg.records import Log

ANGLE_SHIFT = 1e-3
"""Shift of the start angle to either side for derivatives by the pattern angle, rad; and the turn
of a pattern at a constant rate until the end of a test. Chosen."""
MIN_REMAINING_SHIFT = 0.5
"""Share of a shift of the start angle that must remain for a derivative by it. Chosen."""


@dataclass(frozen=True)
class AngleDerivatives:
    """Derivatives of a replay by the pattern's present angle.

    That of the output angle is by the start angle instead: what a bias that depends on the angle
    makes of a shift, over the angular gain.

    slopes: (n,) first derivatives by channel, SI/rad. A free pattern's amplitude has that by an
        angle that grew evenly since power-on.
    curvatures: (n,) second derivatives by channel, SI/rad^2.
    free_turns: (n,) output angle of a constant rate, over that where no angle makes a bias, in rows
        with a free pattern; 1 in all others.
    origins: (n,) derivative of a free pattern's amplitude by the start angle, less what `slopes`
        make of the shift that it leaves, SI/rad; 0 in all other rows.
    """

    slopes: Mapping[str, Array]
    curvatures: Mapping[str, Array]
    free_turns: Array
    origins: Array

    def turn(self, channel: str, angles: Array, log: Log) -> Array:
        """(n, ...) first-order change of a channel from the simulated pattern angle to one that is
        (n, ...) `angles` further. What the first reading has was there from the start."""
        seen = see_angles(channel, angles)
        change = (self.slopes[channel] * seen.T).T
        if channel == "amplitude":
            first = angles[np.argmax(np.isfinite(log.gyro_angle))]
            change = change + np.multiply.outer(self.origins, first)
        return np.asarray(change)

    def bend(self, channel: str, angles: Array) -> Array:
        """(n,) what the second order adds to `turn`."""
        return np.asarray(self.curvatures[channel] * see_angles(channel, angles) ** 2 / 2)


@dataclass(frozen=True)
class FreePattern:
    """Change of a replay by a small constant rate, where the drive is off in some rows.

    is_free: (n,) rows in which it is.
    turns: (n,) angle by which the rate turns the case until each row's end, rad.
    changes: (n,) by channel, SI.
    """

    is_free: Mask
    turns: Array
    changes: Mapping[str, Array]


def compute_derivatives(
    bryan_factor: float,
    below: Mapping[str, Array],
    above: Mapping[str, Array],
    free: FreePattern | None,
) -> AngleDerivatives:
    """From the changes, (n,) by channel, from a start angle that is lower by the shift to the
    present one, and from there to one that is higher. A free pattern keeps its quadrature, so that
    its amplitude and its turn depend on all angles since the drive went off."""
    slopes = {name: (below[name] + above[name]) / (2 * ANGLE_SHIFT) for name in CHANNELS}
    growth = 1 - bryan_factor * slopes["gyro_angle"]
    remains = growth > MIN_REMAINING_SHIFT
    shift = np.where(remains, growth, 1.0)
    now = {n: s if n == "gyro_angle" else s / shift for n, s in slopes.items()}
    bends = {name: (above[name] - below[name]) / ANGLE_SHIFT**2 for name in CHANNELS}
    turned = bryan_factor * np.where(remains, bends["gyro_angle"], 0.0)
    curvatures = {n: (b + now[n] * turned) / shift**2 for n, b in bends.items()}
    free_turns, origins = np.ones(len(shift)), np.zeros(len(shift))
    if free:
        is_free, angle = free.is_free, free.changes["gyro_angle"]
        free_turns[is_free] = angle[is_free] / free.turns[is_free]
        by_turn = now["amplitude"].copy()
        by_turn[is_free] = -free.changes["amplitude"][is_free] / (bryan_factor * angle[is_free])
        origins[is_free] = (slopes["amplitude"] - by_turn * growth)[is_free]
        now["amplitude"] = by_turn
    return AngleDerivatives(now, curvatures, free_turns, origins)
