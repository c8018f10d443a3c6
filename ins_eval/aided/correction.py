"""Increments less what estimated coefficients make of them (docs/methods/aided.md, Eq. 14)."""

import numpy as np

from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import PARTS, Motion
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

PIECE = 100_000
"""Increments that are corrected at once; it bounds memory. Chosen."""


def correct_increments(
    increments: Increments,
    turned: Array,
    sensors: SensorStates,
    coefficients: Array,
    known_at: float,
) -> Increments:
    """Increments without the errors by coefficients (c,).

    turned: (n + 1, 3) turn of each gyro at the bounds, rad; known_at: time at which the
    coefficients were estimated, s; those with a correlation time fade after it.
    """
    pieces = [
        _correct_piece(
            increments.between(first, first + PIECE),
            turned[first : first + PIECE + 1],
            sensors,
            coefficients,
            known_at,
        )
        for first in range(0, len(increments), PIECE)
    ]
    return Increments(
        increments.interval,
        np.concatenate([piece.rotation for piece in pieces]),
        np.concatenate([piece.velocity for piece in pieces]),
        increments.start,
    )


def _correct_piece(
    part: Increments, turned: Array, sensors: SensorStates, coefficients: Array, known_at: float
) -> Increments:
    interval, count = part.interval, len(part)
    middle = Motion(
        step=PARTS * interval,
        start=part.start + 0.5 * interval,
        latitude=np.zeros(count),
        height=np.zeros(count),
        velocity=np.zeros((count, AXES)),
        mat_nb=np.zeros((count, AXES, AXES)),
        rate=part.rotation / interval,
        force=part.velocity / interval,
        turned=0.5 * (turned[1:] + turned[:-1]),
    )
    since = np.maximum(part.bounds[:-1] - known_at, 0.0)[:, None]
    errors = {"gyro": np.zeros((count, AXES)), "accelerometer": np.zeros((count, AXES))}
    for effect, own in zip(sensors.effects, coefficients.reshape(-1, AXES), strict=True):
        fading = np.exp(-since / effect.correlation_time)
        errors[effect.sensor] += own * effect.regressor(middle) * fading
    return Increments(
        interval,
        part.rotation - interval * errors["gyro"],
        part.velocity - interval * errors["accelerometer"],
        part.start,
    )
