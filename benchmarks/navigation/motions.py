"""Error-free flights that a navigator must come back from; shared with the tests."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval import earth
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.state import State, Track, TrackError, track_error
from ins_eval.trajectories.weave import Weave

Array = NDArray[np.float64]

KEPT_EACH = 60.0
"""Time between points of comparison, s."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(6)


@dataclass(frozen=True)
class Flight:
    """What an ideal IMU records on a motion at constant height.

    record: increments, the first of them of the interval before time 0;
    truth: states at times, s.
    """

    name: str
    record: Increments
    truth: Callable[[Array], Track]

    @property
    def increments(self) -> Increments:
        """From time 0 on."""
        return self.record.between(1, len(self.record))

    def start(self) -> State:
        """At time 0."""
        at = self.truth(np.zeros(1))
        latitude, longitude, height = map(float, at.position[0])
        return State(latitude, longitude, height, at.velocity[0], at.mat_nb[0])

    def clamp(self) -> Clamped:
        """The true height."""
        return Clamped(np.full(len(self.record), self.start().height))

    def flown(self, samples: int) -> Track:
        """By this navigator."""
        keep = round(KEPT_EACH / self.record.interval)
        return navigate(self.start(), self.increments, self.clamp(), keep, samples)

    def error(self, track: Track) -> TrackError:
        """Against the truth."""
        return track_error(track, self.truth(track.time))


def weaving(weave: Weave, seconds: int, rate: int) -> Flight:
    """A weave at `rate` Hz."""
    trajectory = weave.trajectory(seconds)
    record = trajectory.increments(-1 / rate, 1 / rate, seconds * rate + 1)
    name = f"weave, {weave.speed:g} m/s, {seconds} s, {rate} Hz"
    return Flight(name, record, trajectory.track)


def static(seconds: int, rate: int) -> Flight:
    """At rest at 45 deg; the nose 30 deg east of north, 3 deg up, rolled by 5 deg."""
    turned = Rotation.from_euler("ZYX", [30.0, 3.0, 5.0], degrees=True)

    def attitude(time: Array) -> Rotation:
        return turned * Rotation.from_rotvec(np.zeros((np.size(time), 3)))

    def rate_nb(time: Array) -> Array:
        return np.zeros((np.size(time), 3))

    return _at_a_place(f"static, {seconds} s, {rate} Hz", attitude, rate_nb, seconds, rate)


def coning(half_angle: float, frequency: float, seconds: int, rate: int) -> Flight:
    """At rest but for the nose's axis, which is tilted by an angle, rad, about a level axis that
    turns at a frequency, Hz."""
    w = 2 * np.pi * frequency

    def attitude(time: Array) -> Rotation:
        zero = np.zeros_like(time)
        axis = np.stack([np.cos(w * time), np.sin(w * time), zero], axis=-1)
        return Rotation.from_rotvec(half_angle * axis)

    def rate_nb(time: Array) -> Array:
        steady = np.full_like(time, -2 * w * np.sin(half_angle / 2) ** 2)
        size = w * np.sin(half_angle)
        return np.stack([-size * np.sin(w * time), size * np.cos(w * time), steady], axis=-1)

    name = f"coning {np.rad2deg(half_angle):g} deg, {frequency:g} Hz, {seconds} s, {rate} Hz"
    return _at_a_place(name, attitude, rate_nb, seconds, rate)


def _at_a_place(
    name: str,
    attitude: Callable[[Array], Rotation],
    rate_nb: Callable[[Array], Array],
    seconds: int,
    rate: int,
) -> Flight:
    """Attitude, and its rate `omega_nb_b`, over time at 45 deg, 100 m; by Gauss-Legendre
    quadrature with six points an interval."""
    latitude, height = np.deg2rad(45.0), 100.0
    omega_ie = earth.RATE * np.array([np.cos(latitude), 0.0, -np.sin(latitude)])
    force_n = np.array([0.0, 0.0, -earth.gravity(latitude, height)])
    interval = 1 / rate
    middles = interval * (np.arange(-1, seconds * rate) + 0.5)
    rotation, velocity = np.zeros((len(middles), 3)), np.zeros((len(middles), 3))
    for node, weight in zip(_NODES, _WEIGHTS, strict=True):
        time = middles + 0.5 * interval * node
        to_body = attitude(time).inv()
        rotation += 0.5 * interval * weight * (rate_nb(time) + to_body.apply(omega_ie))
        velocity += 0.5 * interval * weight * to_body.apply(force_n)

    def truth(time: Array) -> Track:
        position = np.tile([latitude, 0.0, height], (len(time), 1))
        return Track(time, position, np.zeros((len(time), 3)), attitude(time).as_matrix())

    return Flight(name, Increments(interval, rotation, velocity, -interval), truth)
