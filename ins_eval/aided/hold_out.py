"""Free-inertial navigation after the last fix that was used, judged by the fixes that were not."""

from dataclasses import dataclass

import numpy as np

from ins_eval.aided.correction import correct_increments
from ins_eval.aided.fixes import Fixes
from ins_eval.aided.kalman.drive import SAMPLES
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.common.state import State, displace, position_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

SPACING = 1.0
"""Time between the navigated states that are compared with fixes, s. Chosen."""


@dataclass(frozen=True)
class HoldOut:
    """Horizontal distance from the fixes that were held out.

    time: (m,) since the last fix that was used, s; corrected, uncorrected: (m,) m, with and without
    the errors of the sensors that were found; both start from the filtered state.
    """

    time: Array
    corrected: Array
    uncorrected: Array


def judge_hold_out(
    increments: Increments,
    turned: Array,
    fixes: Fixes,
    start: State,
    sensors: SensorStates,
    coefficients: Array,
    lever_arm: Array,
) -> HoldOut:
    """Navigate freely with and without the coefficients (c,).

    increments: from the last fix that was used on, of which an odd one at the end is left out;
    turned: at their bounds, rad; fixes: their
    heights hold the navigator's.

    Raises:
        HrgError: too few positions after the start.
    """
    count = len(increments) // SAMPLES * SAMPLES
    increments, turned = increments.between(0, count), turned[: count + 1]
    after = fixes.select(fixes.has_position & (fixes.time > increments.start + SPACING))
    if len(after) < 2:
        raise HrgError(f"{fixes.source}: found {len(after)} positions held out, expected 2 or more")
    heights = np.interp(increments.bounds, after.time, after.position[:, 2])
    corrected = correct_increments(increments, turned, sensors, coefficients, increments.start)
    distances = [
        _measure_distance(each, after, start, heights, lever_arm)
        for each in (corrected, increments)
    ]
    last = SPACING * (increments.duration // SPACING) + increments.start
    kept = after.time <= last
    return HoldOut(after.time[kept] - increments.start, *(each[kept] for each in distances))


def _measure_distance(
    increments: Increments, fixes: Fixes, start: State, heights: Array, lever_arm: Array
) -> Array:
    each = SAMPLES * max(1, round(SPACING / increments.interval / SAMPLES))
    way = navigate(start, increments, Clamped(heights), each, SAMPLES)
    antenna = displace(way.position, way.mat_nb @ lever_arm)
    at = np.stack([np.interp(fixes.time, way.time, column) for column in antenna.T], axis=-1)
    return np.asarray(np.linalg.norm(position_error(at, fixes.position)[:, :2], axis=1))
