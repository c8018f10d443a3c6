"""Error-free flights that a navigator must come back from; shared with the tests."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from benchmarks.navigation.weave import Weave
from ins_eval.common import earth
from ins_eval.common.state import State, Track, TrackError, track_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

KEPT_EACH = 60.0
"""Time between points of comparison, s."""
LATITUDE = np.deg2rad(45.0)
HEIGHT = 100.0
"""Where a vehicle at rest is, rad, m."""
OMEGA_IE = earth.RATE * np.array([np.cos(LATITUDE), 0.0, -np.sin(LATITUDE)])
FORCE = -np.array(
    [*earth.horizontal_gravity(LATITUDE, HEIGHT, (0.0, 0.0)), earth.gravity(LATITUDE, HEIGHT)]
)
"""What it feels, in navigation axes, rad/s, m/s^2."""
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
    """At rest; the nose 30 deg east of north, 3 deg up, rolled by 5 deg."""
    attitude = Rotation.from_euler("ZYX", [30.0, 3.0, 5.0], degrees=True)
    count = seconds * rate + 1
    rotation = np.tile(attitude.inv().apply(OMEGA_IE) / rate, (count, 1))
    velocity = np.tile(attitude.inv().apply(FORCE) / rate, (count, 1))

    def truth(time: Array) -> Track:
        return _in_place(time, np.tile(attitude.as_matrix(), (len(time), 1, 1)))

    record = Increments(1 / rate, rotation, velocity, -1 / rate)
    return Flight(f"static, {seconds} s, {rate} Hz", record, truth)


def coning(half_angle: float, frequency: float, seconds: int, rate: int) -> Flight:
    """At rest but for being tilted by an angle, rad, about a level axis that turns at a frequency,
    Hz; increments by Gauss-Legendre quadrature with six points an interval."""
    w = 2 * np.pi * frequency
    interval = 1 / rate
    middles = interval * (np.arange(-1, seconds * rate) + 0.5)
    rotation, velocity = np.zeros((len(middles), 3)), np.zeros((len(middles), 3))
    for node, weight in zip(_NODES, 0.5 * interval * _WEIGHTS, strict=True):
        angle = w * (middles + 0.5 * interval * node)
        to_body = _tilted(half_angle, angle).inv()
        rotation += weight * (_coning_rate(half_angle, w, angle) + to_body.apply(OMEGA_IE))
        velocity += weight * to_body.apply(FORCE)

    def truth(time: Array) -> Track:
        return _in_place(time, _tilted(half_angle, w * time).as_matrix())

    name = f"coning {np.rad2deg(half_angle):g} deg, {frequency:g} Hz, {seconds} s, {rate} Hz"
    return Flight(name, Increments(interval, rotation, velocity, -interval), truth)


def _tilted(half_angle: float, angle: Array) -> Rotation:
    axis = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)
    return Rotation.from_rotvec(half_angle * axis)


def _coning_rate(half_angle: float, w: float, angle: Array) -> Array:
    """`omega_nb_b` (n, 3) (Savage 1998, Part I, section on pure coning)."""
    size = w * np.sin(half_angle)
    steady = np.full_like(angle, -2 * w * np.sin(half_angle / 2) ** 2)
    return np.stack([-size * np.sin(angle), size * np.cos(angle), steady], axis=-1)


def _in_place(time: Array, mat_nb: Array) -> Track:
    position = np.tile([LATITUDE, 0.0, HEIGHT], (len(time), 1))
    return Track(time, position, np.zeros((len(time), 3)), mat_nb)
