"""Attitude: body axes forward, right, down; navigation axes north, east, down.

`mat_nb` turns body into navigation coordinates; Euler angles are yaw about down, then pitch, then
roll (Groves 2013, Eqs. 2.22 to 2.25).
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def mat_from_euler(roll: Array, pitch: Array, yaw: Array) -> Array:
    """`mat_nb` (..., 3, 3) from Euler angles (...), rad."""
    sr, cr = np.sin(roll), np.cos(roll)
    sp, cp = np.sin(pitch), np.cos(pitch)
    sy, cy = np.sin(yaw), np.cos(yaw)
    rows = [
        [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
        [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
        [-sp, sr * cp, cr * cp],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def euler_from_mat(mat_nb: Array) -> tuple[float, float, float]:
    """Roll, pitch, yaw, rad, of one `mat_nb` (3, 3) that does not point straight up or down."""
    roll = float(np.arctan2(mat_nb[2, 1], mat_nb[2, 2]))
    pitch = float(np.arcsin(np.clip(-mat_nb[2, 0], -1.0, 1.0)))
    return roll, pitch, float(np.arctan2(mat_nb[1, 0], mat_nb[0, 0]))


def body_rate_from_euler(
    roll: Array, pitch: Array, roll_rate: Array, pitch_rate: Array, yaw_rate: Array
) -> Array:
    """`omega_nb_b` (..., 3), rad/s, from Euler angles and their rates."""
    sr, cr = np.sin(roll), np.cos(roll)
    sp, cp = np.sin(pitch), np.cos(pitch)
    return np.stack(
        [
            roll_rate - yaw_rate * sp,
            pitch_rate * cr + yaw_rate * sr * cp,
            -pitch_rate * sr + yaw_rate * cr * cp,
        ],
        axis=-1,
    )
