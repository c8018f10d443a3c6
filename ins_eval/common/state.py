"""Position, velocity and attitude of a vehicle: at one time, over time, and their errors."""

from dataclasses import dataclass

import numpy as np

from ins_eval.common import earth
from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly


@dataclass(frozen=True)
class State:
    """State of a vehicle at one time.

    Attributes:
        latitude, longitude: geodetic, rad.
        height: height above the ellipsoid, m.
        velocity: (3,) velocity over ground, north, east, down, m/s.
        mat_nb: (3, 3) attitude, from body to navigation axes.
    """

    latitude: float
    longitude: float
    height: float
    velocity: Array
    mat_nb: Array

    @staticmethod
    def at_rest(position: Array, mat_nb: Array) -> "State":
        """The state of a vehicle at rest at a position (3,), with attitude (3, 3)."""
        latitude, longitude, height = map(float, position)
        return State(latitude, longitude, height, np.zeros(3), mat_nb)

    @property
    def position(self) -> Array:
        """(3,) latitude, longitude, rad, height, m."""
        return np.array([self.latitude, self.longitude, self.height])


@dataclass(frozen=True)
class Track:
    """States of a vehicle at m times.

    Attributes:
        time: (m,) s.
        position: (m, 3) latitude, longitude (rad; continuous, not wrapped), height (m).
        velocity: (m, 3) north, east, down, m/s.
        mat_nb: (m, 3, 3).
    """

    time: Array
    position: Array
    velocity: Array
    mat_nb: Array

    __repr__ = describe_briefly

    def __len__(self) -> int:
        return len(self.time)


@dataclass(frozen=True)
class TrackError:
    """Errors of a track: navigator less truth.

    Attributes:
        time: (m,) s.
        position: (m, 3) north, east, down, m.
        velocity: (m, 3) north, east, down, m/s.
        attitude: (m, 3) rotation vector about north, east, down that turns the true axes into the
            computed ones, rad: `mat_nb` computed = (I + [attitude x]) `mat_nb` true.
    """

    time: Array
    position: Array
    velocity: Array
    attitude: Array


def track_error(track: Track, truth: Track) -> TrackError:
    """Return the errors of a track against the truth at the same times."""
    if len(track) != len(truth) or not np.allclose(track.time, truth.time, rtol=0, atol=1e-6):
        raise ValueError("track and truth: expected the same times")
    turned = track.mat_nb @ np.swapaxes(truth.mat_nb, -1, -2)
    odd = 0.5 * (turned - np.swapaxes(turned, -1, -2))
    sine = np.stack([odd[..., 2, 1], odd[..., 0, 2], odd[..., 1, 0]], axis=-1)
    size = np.linalg.norm(sine, axis=-1, keepdims=True)
    cosine = 0.5 * (np.trace(turned, axis1=-2, axis2=-1)[..., None] - 1)
    angle = np.arctan2(size, cosine)
    scale = np.divide(angle, size, out=np.ones_like(size), where=size > 1e-12)
    return TrackError(
        time=track.time,
        position=position_error(track.position, truth.position),
        velocity=track.velocity - truth.velocity,
        attitude=sine * scale,
    )


def position_error(position: Array, truth: Array) -> Array:
    """Return north, east and down errors (..., 3), m, of positions (..., 3) against true ones; both
    are latitude, longitude (rad) and height (m)."""
    latitude, height = truth[..., 0], truth[..., 2]
    around = np.remainder(position[..., 1] - truth[..., 1] + np.pi, 2 * np.pi) - np.pi
    east_radius = (earth.transverse_radius(latitude) + height) * np.cos(latitude)
    return np.stack(
        [
            (position[..., 0] - latitude) * (earth.meridian_radius(latitude) + height),
            around * east_radius,
            height - position[..., 2],
        ],
        axis=-1,
    )


def displace(position: Array, moved: Array) -> Array:
    """Positions (..., 3), rad and m, that lie short ways (..., 3) north, east, down, m, from
    others."""
    latitude, height = position[..., 0], position[..., 2]
    return position + np.stack(
        [
            moved[..., 0] / (earth.meridian_radius(latitude) + height),
            moved[..., 1] / (earth.transverse_radius(latitude) + height) / np.cos(latitude),
            -moved[..., 2],
        ],
        axis=-1,
    )
