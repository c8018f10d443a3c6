"""Strapdown navigation from increments; reads no file and draws no random number.

Two- to four-sample coning and sculling, Coriolis, transport and gravity at the middle of the step,
WGS-84 (Savage 1998; Groves 2013, chapter 5).
"""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.increments import Increments
from ins_eval.navigation import kernel
from ins_eval.navigation.coefficients import weights
from ins_eval.navigation.height import Free, Height
from ins_eval.state import State, Track

Array = NDArray[np.float64]


class NavigationError(Exception):
    """The navigator can't start or go on; the message says where and why."""


def navigate(
    start: State, increments: Increments, height: Height, keep_every: int, samples: int = 2
) -> Track:
    """Dead reckoning.

    Args:
        start: initial state, at the beginning of the first interval.
        increments: of the IMU; a multiple of `samples` intervals.
        height: what holds the height.
        keep_every: intervals between rows of the result, a multiple of `samples`.
        samples: increments a step, 2 to 4.

    Returns:
        States after every `keep_every` intervals.

    Raises:
        ValueError: numbers of intervals or heights that do not match.
        NavigationError: a start within half a degree of a pole, an attitude that is no rotation,
            or a flight that reaches the pole or diverges.
    """
    count = len(increments)
    if count % samples or keep_every % samples or keep_every < 1:
        raise ValueError(
            f"{count} intervals, every {keep_every} kept: both must be multiples of {samples}"
        )
    check_start(start)
    reference = _reference(height, count)[::samples]
    rows = np.empty((count // keep_every, 10))
    steps = kernel.navigate(
        (start.latitude, start.longitude, start.height),
        np.asarray(start.velocity, dtype=float),
        _quaternion(start.mat_nb),
        increments.interval,
        increments.rotation,
        increments.velocity,
        weights(samples),
        height.mode,
        reference,
        height.gains,
        keep_every // samples,
        rows,
    )
    if steps < count // samples:
        time = increments.start + steps * samples * increments.interval
        raise NavigationError(_what_ended(time, rows[: steps * samples // keep_every], start))
    return Track(
        time=increments.bounds[keep_every::keep_every],
        position=rows[:, :3].copy(),
        velocity=rows[:, 3:6].copy(),
        mat_nb=Rotation.from_quat(rows[:, 6:], scalar_first=True).as_matrix(),
    )


def check_start(start: State) -> None:
    """Refuse a state that the navigator can't start from.

    Raises:
        NavigationError: says what is wrong.
    """
    latitude = np.rad2deg(start.latitude)
    if not abs(start.latitude) < kernel.LIMIT:
        raise NavigationError(
            f"start at latitude {latitude:.4g} deg; "
            f"expected within {np.rad2deg(kernel.LIMIT):g} deg of the equator, short of the poles"
        )
    values = [start.longitude, start.height, *start.velocity]
    if not np.all(np.isfinite(values)):
        raise NavigationError(f"start at {values}: expected finite numbers")
    check_rotation(start.mat_nb)


def check_rotation(matrix: Array) -> None:
    """Refuse a matrix that is no rotation.

    Raises:
        NavigationError: says by how much.
    """
    if np.shape(matrix) != (3, 3) or not np.all(np.isfinite(matrix)):
        raise NavigationError(f"attitude of shape {np.shape(matrix)}: expected a finite 3 x 3")
    skewed = float(np.max(np.abs(matrix @ matrix.T - np.eye(3))))
    determinant = float(np.linalg.det(matrix))
    if skewed > 1e-6 or determinant < 0:
        raise NavigationError(
            f"attitude is no rotation: C C' differs from 1 by {skewed:.1e}, "
            f"determinant {determinant:.3g}; expected at most 1e-6, and 1"
        )


def _reference(height: Height, count: int) -> Array:
    if isinstance(height, Free):
        return np.zeros(count + 1)
    if len(height.heights) != count + 1:
        raise ValueError(f"{len(height.heights)} heights given, {count + 1} expected")
    return np.asarray(height.heights, dtype=float)


def _what_ended(time: float, rows: Array, start: State) -> str:
    """Why the navigator stopped, from the last rows that it kept."""
    last = rows[-1] if len(rows) else np.array([start.latitude, start.longitude, start.height])
    place = f"latitude {np.rad2deg(last[0]):.3f} deg, height {last[2]:.4g} m"
    return (
        f"stopped at {time:.2f} s: latitude near a pole or state no longer finite; "
        f"last kept at {place}: are the increments in rad and m/s, and without gaps?"
    )


def _quaternion(mat_nb: Array) -> Array:
    return np.asarray(Rotation.from_matrix(mat_nb).as_quat(scalar_first=True))
