"""Attitude: body axes forward, right, down; navigation axes north, east, down.

`mat_nb` turns body into navigation coordinates; Euler angles are yaw about down, then pitch, then
roll (Groves 2013, Eqs. 2.22 to 2.25).
"""

from typing import Any

import numpy as np

from pyhrg.common.arrays import Array


def mat_from_euler(roll: Array, pitch: Array, yaw: Array) -> Array:
    """Return `mat_nb` (..., 3, 3) of Euler angles (...), rad (Groves 2013, Eq. 2.24)."""
    sr, cr = np.sin(roll), np.cos(roll)
    sp, cp = np.sin(pitch), np.cos(pitch)
    sy, cy = np.sin(yaw), np.cos(yaw)
    rows = [
        [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
        [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
        [-sp, sr * cp, cr * cp],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def euler_from_mat(mat_nb: Array) -> tuple[Any, Any, Any]:
    """Return roll, pitch, yaw (...), rad, of `mat_nb` (..., 3, 3); the nose must not point straight
    up or down (Groves 2013, Eq. 2.25)."""
    roll = np.arctan2(mat_nb[..., 2, 1], mat_nb[..., 2, 2])
    pitch = np.arcsin(np.clip(-mat_nb[..., 2, 0], -1.0, 1.0))
    return roll, pitch, np.arctan2(mat_nb[..., 1, 0], mat_nb[..., 0, 0])


def body_rate_from_euler(
    roll: Array, pitch: Array, roll_rate: Array, pitch_rate: Array, yaw_rate: Array
) -> Array:
    """Return `omega_nb_b` (..., 3), rad/s, of Euler angles and their rates (Groves 2013, Eq.
    2.57)."""
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


def skew(v: Array) -> Array:
    """Return the matrices (..., 3, 3) of the cross product: skew(v) @ u = v x u."""
    matrix = np.zeros((*np.shape(v), 3))
    matrix[..., 0, 1], matrix[..., 0, 2] = -v[..., 2], v[..., 1]
    matrix[..., 1, 0], matrix[..., 1, 2] = v[..., 2], -v[..., 0]
    matrix[..., 2, 0], matrix[..., 2, 1] = -v[..., 1], v[..., 0]
    return matrix
