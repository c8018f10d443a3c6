"""Strapdown navigation from increments; reads no file and draws no random number.

Two- to four-sample coning and sculling, Coriolis, transport and gravity at the middle of the step,
WGS-84 (Savage 1998; Groves 2013, chapter 5).
"""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.common.increments import Increments
from ins_eval.common.state import State, Track
from ins_eval.navigation import kernel
from ins_eval.navigation.coefficients import weights
from ins_eval.navigation.height import Height
from pyhrg.common.errors import HrgError

Array = NDArray[np.float64]


class NavigationError(HrgError):
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
    if count % samples or keep_every % samples or not 1 <= keep_every <= count:
        raise ValueError(
            f"{count} intervals, every {keep_every} kept: both must be multiples of {samples}, "
            "and the second not above the first"
        )
    check_start(start)
    check_increments(increments)
    rows = np.empty((count // keep_every, kernel.STATE_SIZE))
    steps, latitude, reached = kernel.navigate(
        (float(start.latitude), float(start.longitude), float(start.height)),
        tuple(map(float, start.velocity)),
        tuple(map(float, Rotation.from_matrix(start.mat_nb).as_quat(scalar_first=True))),
        float(increments.interval),
        np.ascontiguousarray(increments.rotation, dtype=float),
        np.ascontiguousarray(increments.velocity, dtype=float),
        weights(samples),
        height.channel(count, samples, increments.interval),
        keep_every // samples,
        rows,
    )
    if steps < count // samples:
        step = increments.between(steps * samples, (steps + 1) * samples)
        raise NavigationError(_what_ended(step, latitude, reached))
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
        hint = "; is it in degrees where radians are meant?" if abs(latitude) > 90 else ""
        raise NavigationError(
            f"start at latitude {latitude:.4g} deg; "
            f"expected within {np.rad2deg(kernel.LIMIT):g} deg of the equator, short of the poles"
            f"{hint}"
        )
    if np.shape(start.velocity) != (3,):
        raise NavigationError(
            f"start with a velocity of shape {np.shape(start.velocity)}: expected (3,)"
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
    matrix = np.asarray(matrix)
    if np.shape(matrix) != (3, 3) or not np.all(np.isfinite(matrix)):
        raise NavigationError(f"attitude of shape {np.shape(matrix)}: expected a finite 3 x 3")
    skewed = float(np.max(np.abs(matrix @ matrix.T - np.eye(3))))
    determinant = float(np.linalg.det(matrix))
    if skewed > 1e-6 or determinant < 0:
        raise NavigationError(
            f"attitude is no rotation: C C' differs from 1 by {skewed:.1e}, "
            f"determinant {determinant:.3g}; expected at most 1e-6, and 1"
        )


def check_increments(increments: Increments) -> None:
    """Refuse increments that the compiled navigator can't read; their numbers it checks itself.

    Raises:
        NavigationError: says what is wrong.
    """
    shapes = np.shape(increments.rotation), np.shape(increments.velocity)
    if shapes != ((len(increments), 3),) * 2:
        raise NavigationError(
            f"increments of shapes {shapes[0]} and {shapes[1]}: expected (n, 3) both, the same n"
        )
    if not 0 < increments.interval < np.inf:
        raise NavigationError(f"increments of {increments.interval} s: expected longer than 0 s")


def _what_ended(step: Increments, latitude: float, height: float) -> str:
    """Why the navigator stopped, from the step that it could not make and where that led."""
    reading = np.hstack([step.rotation, step.velocity])
    bad = np.flatnonzero(~np.isfinite(reading).all(axis=1))
    if len(bad):
        return (
            f"increments of the interval from {step.bounds[bad[0]]:.6g} s are "
            f"{reading[bad[0]].tolist()}: expected finite numbers, rad and m/s"
        )
    ended = f"stopped at {step.start:.6g} s, latitude {np.rad2deg(latitude):.4f} deg, "
    ended += f"height {height:.4g} m"
    if not abs(latitude) < kernel.LIMIT:
        return f"{ended}: beyond {np.rad2deg(kernel.LIMIT):g} deg, too near a pole"
    return f"{ended}: diverged; are the increments in rad and m/s, and without gaps?"
