"""Strapdown navigation: from increments of an IMU to position, velocity and attitude.

Coning and sculling with 2 to 4 increments a step, on WGS-84 (Savage 1998; Groves 2013, chapter 5).
The equations are in docs/methods/navigation.md.
"""

import numpy as np
from scipy.spatial.transform import Rotation

from ins_eval.common.state import State, Track
from ins_eval.navigation import kernel
from ins_eval.navigation.coefficients import derive_coefficients
from ins_eval.navigation.height import Height
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments


def navigate(
    start: State,
    increments: Increments,
    height: Height,
    keep_every: int,
    samples: int = 2,
    deflection: tuple[float, float] = (0.0, 0.0),
) -> Track:
    """Navigate by dead reckoning, and return the states after every `keep_every` increments.

    Args:
        start: state at the beginning of the first increment.
        increments: output of the IMU; their number is a multiple of `samples`.
        height: height aiding: `Free()`, `Clamped(heights)` or `BaroDamped(heights)`.
        keep_every: increments between rows of the result, a multiple of `samples`.
        samples: increments a step, 2 to 4.
        deflection: deflection of the vertical that the navigator assumes, north and east, rad; by
            default none, whatever the truth has.

    Raises:
        HrgError: `samples` out of range; heights of the wrong number or not finite.
        HrgError: numbers of increments that do not match; a start within half a degree of a
            pole; an attitude that is not a rotation matrix; increments that are not finite; a path
            that reaches a pole or diverges.
    """
    count = len(increments)
    if count % samples or keep_every % samples or not 1 <= keep_every <= count:
        raise HrgError(
            f"found {count} increments and keep_every {keep_every}: expected multiples of samples, "
            f"{samples}, and keep_every at most the number of increments"
        )
    check_start(start)
    check_increments(increments)
    rows = np.empty((count // keep_every, kernel.STATE_SIZE))
    steps, latitude, reached = kernel.run_steps(
        (float(start.latitude), float(start.longitude), float(start.height)),
        tuple(map(float, start.velocity)),
        tuple(map(float, Rotation.from_matrix(start.mat_nb).as_quat(scalar_first=True))),
        float(increments.interval),
        np.ascontiguousarray(increments.rotation, dtype=float),
        np.ascontiguousarray(increments.velocity, dtype=float),
        derive_coefficients(samples),
        height.make_channel(count, samples, increments.interval),
        (float(deflection[0]), float(deflection[1])),
        keep_every // samples,
        rows,
    )
    if steps < count // samples:
        step = increments.between(steps * samples, (steps + 1) * samples)
        raise HrgError(_describe_stop(step, latitude, reached))
    return Track(
        time=increments.bounds[keep_every::keep_every],
        position=rows[:, :3].copy(),
        velocity=rows[:, 3:6].copy(),
        mat_nb=Rotation.from_quat(rows[:, 6:], scalar_first=True).as_matrix(),
    )


def check_start(start: State) -> None:
    latitude = np.rad2deg(start.latitude)
    if not abs(start.latitude) < kernel.MAX_LATITUDE:
        hint = "; is it in degrees where radians are meant?" if abs(latitude) > 90 else ""
        raise HrgError(
            f"start at latitude {latitude:.4g} deg; expected within "
            f"{np.rad2deg(kernel.MAX_LATITUDE):g} deg of the equator, short of the poles{hint}"
        )
    if np.shape(start.velocity) != (3,):
        raise HrgError(f"start with a velocity of shape {np.shape(start.velocity)}: expected (3,)")
    values = [start.longitude, start.height, *start.velocity]
    if not np.all(np.isfinite(values)):
        raise HrgError(f"start at {values}: expected finite numbers")
    check_rotation(start.mat_nb)


def check_rotation(matrix: Array) -> None:
    """Check that a matrix is a finite rotation matrix (3, 3)."""
    matrix = np.asarray(matrix)
    if np.shape(matrix) != (3, 3) or not np.all(np.isfinite(matrix)):
        raise HrgError(f"attitude of shape {np.shape(matrix)}: expected a finite 3 x 3")
    deviation = float(np.max(np.abs(matrix @ matrix.T - np.eye(3))))
    determinant = float(np.linalg.det(matrix))
    if deviation > 1e-6 or determinant < 0:
        raise HrgError(
            f"attitude is not a rotation matrix: C C' differs from 1 by {deviation:.1e}, "
            f"determinant {determinant:.3g}; expected at most 1e-6, and 1"
        )


def check_increments(increments: Increments) -> None:
    """Check shapes and interval of increments; the compiled loop checks that values are finite."""
    shapes = np.shape(increments.rotation), np.shape(increments.velocity)
    if shapes != ((len(increments), 3),) * 2:
        raise HrgError(
            f"increments of shapes {shapes[0]} and {shapes[1]}: expected (n, 3) both, the same n"
        )
    if not 0 < increments.interval < np.inf:
        raise HrgError(f"increments of {increments.interval} s: expected longer than 0 s")


def _describe_stop(step: Increments, latitude: float, height: float) -> str:
    """Say why the navigator stopped in a step that led to this latitude and height."""
    reading = np.hstack([step.rotation, step.velocity])
    bad = np.flatnonzero(~np.isfinite(reading).all(axis=1))
    if len(bad):
        return (
            f"increments of the interval from {step.bounds[bad[0]]:.6g} s are "
            f"{reading[bad[0]].tolist()}: expected finite numbers, rad and m/s"
        )
    ended = f"stopped at {step.start:.6g} s, latitude {np.rad2deg(latitude):.4f} deg, "
    ended += f"height {height:.4g} m"
    if not abs(latitude) < kernel.MAX_LATITUDE:
        return f"{ended}: beyond {np.rad2deg(kernel.MAX_LATITUDE):g} deg, too near a pole"
    return f"{ended}: diverged; are the increments in rad and m/s, and without gaps?"
