"""What an alignment hands over."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.rotation import euler_from_mat
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG

Array = NDArray[np.float64]

NEAREST_VERTICAL = np.deg2rad(1.0)
"""Of the nose: nearer, heading and roll have no meaning apart."""


class AlignmentError(HrgError):
    """The record can't be aligned on."""


@dataclass(frozen=True)
class Biases:
    """Gyro (3,), rad/s, and accelerometer (3,), m/s^2, biases as estimated, body axes: what
    is constant over the record.

    covariance: (6, 6) of the estimates' errors, gyros first.
    """

    gyro: Array
    accelerometer: Array
    covariance: Array


@dataclass(frozen=True)
class History:
    """How the estimate came about.

    time: (m,) s; mat_nb: (m, 3, 3); covariance: (m, 3, 3) as in `Alignment`; innovation: (m, 2)
    of the level displacement, each divided by its sigma.
    """

    time: Array
    mat_nb: Array
    covariance: Array
    innovation: Array


@dataclass(frozen=True)
class Alignment:
    """Attitude at one moment, with its uncertainty.

    method: what made it; time: that it holds at, s; mat_nb: (3, 3); covariance: (3, 3) of the
    attitude error, rad^2: the rotation vector about north, east, down of
    `TrackError`. Where the method finds none of them, None: biases; history; sway,
    standard deviation of the vehicle's level displacement, m.
    """

    method: str
    time: float
    mat_nb: Array
    covariance: Array
    biases: Biases | None = None
    history: History | None = None
    sway: float | None = None

    @property
    def heading_deg(self) -> float:
        """Clockwise from north, 0 to 360.

        Raises:
            AlignmentError: the nose points along the vertical; so do roll and all the sigmas.
        """
        self._check_readable()
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[2]) % 360)

    @property
    def pitch_deg(self) -> float:
        """Nose up."""
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[1]))

    @property
    def roll_deg(self) -> float:
        """Right side down."""
        self._check_readable()
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[0]))

    @property
    def euler_sigma_deg(self) -> Array:
        """(3,) one-sigma of roll, pitch, heading."""
        self._check_readable()
        turns = euler_from_rotation_vector(self.mat_nb)
        return np.sqrt(np.diag(turns @ self.covariance @ turns.T)) / DEG

    def __str__(self) -> str:
        roll, pitch, heading = self.euler_sigma_deg
        return (
            f"heading {self.heading_deg:.4f} +- {heading:.4f} deg, "
            f"pitch {self.pitch_deg:.4f} +- {pitch:.4f} deg, "
            f"roll {self.roll_deg:.4f} +- {roll:.4f} deg "
            f"(one sigma; {self.method}, at {self.time:.2f} s)"
        )

    def _check_readable(self) -> None:
        if abs(self.pitch_deg * DEG) > np.pi / 2 - NEAREST_VERTICAL:
            raise AlignmentError(
                f"pitch {self.pitch_deg:.4g} deg: heading and roll have no meaning apart within "
                f"{np.rad2deg(NEAREST_VERTICAL):g} deg of the vertical; use mat_nb and covariance"
            )


def euler_from_rotation_vector(mat_nb: Array) -> Array:
    """(3, 3): changes of roll, pitch, yaw by a small rotation about north, east, down.

    The inverse of the Euler rates' matrix (Groves 2013, Eq. 2.58, in navigation axes).
    """
    _, pitch, yaw = euler_from_mat(mat_nb)
    sin, cos, tan = np.sin(yaw), np.cos(yaw), np.tan(pitch)
    return np.array(
        [
            [cos / np.cos(pitch), sin / np.cos(pitch), 0.0],
            [-sin, cos, 0.0],
            [cos * tan, sin * tan, 1.0],
        ]
    )
