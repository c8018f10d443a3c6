"""The result of an alignment: attitude with covariance and history."""

from dataclasses import dataclass

import numpy as np

from ins_eval.common.rotation import euler_from_mat
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG

MIN_ANGLE_FROM_VERTICAL = np.deg2rad(1.0)
"""Smallest angle of the nose from the vertical, rad, at which heading and roll are given. Chosen:
closer, they are one rotation."""


@dataclass(frozen=True)
class History:
    """Estimates over the record.

    Attributes:
        time: (m,) s.
        mat_nb: (m, 3, 3) attitudes.
        covariance: (m, 3, 3) as in `Alignment`.
        innovation: (m, 2) normalized innovations of the level displacement.
    """

    time: Array
    mat_nb: Array
    covariance: Array
    innovation: Array


@dataclass(frozen=True)
class Alignment:
    """Attitude at one time, with its covariance.

    Attributes:
        time: time of the attitude, s.
        mat_nb: (3, 3) attitude.
        covariance: (3, 3) of the attitude error, the rotation vector about north, east, down of
            `TrackError`, rad^2.
        history: estimates over the record.
        sway: standard deviation of the vehicle's level displacement, m.
    """

    time: float
    mat_nb: Array
    covariance: Array
    history: History
    sway: float

    @property
    def heading_deg(self) -> float:
        """Heading, clockwise from north, 0 to 360 deg.

        Raises:
            HrgError: the nose points along the vertical; roll and sigmas raise it too.
        """
        self._check_readable()
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[2]) % 360)

    @property
    def pitch_deg(self) -> float:
        """Pitch, positive nose up, deg."""
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[1]))

    @property
    def roll_deg(self) -> float:
        """Roll, positive right side down, deg."""
        self._check_readable()
        return float(np.rad2deg(euler_from_mat(self.mat_nb)[0]))

    @property
    def euler_sigma_deg(self) -> Array:
        """(3,) one-sigma of roll, pitch, heading, deg."""
        self._check_readable()
        turns = euler_from_rotation_vector(self.mat_nb)
        return np.sqrt(np.diag(turns @ self.covariance @ turns.T)) / DEG

    def __str__(self) -> str:
        roll, pitch, heading = self.euler_sigma_deg
        return (
            f"heading {self.heading_deg:.4f} +- {heading:.4f} deg, "
            f"pitch {self.pitch_deg:.4f} +- {pitch:.4f} deg, "
            f"roll {self.roll_deg:.4f} +- {roll:.4f} deg "
            f"(one sigma; fine, at {self.time:.2f} s)"
        )

    def _check_readable(self) -> None:
        if abs(self.pitch_deg * DEG) > np.pi / 2 - MIN_ANGLE_FROM_VERTICAL:
            raise HrgError(
                f"pitch {self.pitch_deg:.4g} deg: heading and roll are one rotation within "
                f"{np.rad2deg(MIN_ANGLE_FROM_VERTICAL):g} deg of the vertical; use mat_nb and "
                "covariance"
            )


def euler_from_rotation_vector(mat_nb: Array) -> Array:
    """Return (3, 3) the changes of roll, pitch, yaw per small rotation about north, east, down.

    It is the inverse of the Euler rates' matrix (Groves 2013, Eq. 2.58, in navigation axes).
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
