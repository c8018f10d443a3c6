"""An aircraft that weaves about a heading in coordinated turns: the navigator's yardstick."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from ins_eval.common import earth
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array

KNOTS_EACH = 0.25
"""s."""
BEFORE_AND_AFTER = 5.0
"""Knots beyond the flight's ends, s."""


@dataclass(frozen=True)
class Weave:
    """Heading `heading` + `swing` sin(2 pi t / `period`) at constant speed and height.

    latitude, longitude: at time 0, rad; height: m; speed: m/s; heading, swing: rad; period: s.
    """

    latitude: float = np.deg2rad(45.0)
    longitude: float = 0.0
    height: float = 1000.0
    speed: float = 250.0
    heading: float = 0.0
    swing: float = np.deg2rad(20.0)
    period: float = 60.0

    def trajectory(self, duration: float) -> Trajectory:
        """From time 0 on; integrated by an eighth-order Runge-Kutta method (DOP853)."""
        first = -BEFORE_AND_AFTER
        time = np.arange(first, duration + BEFORE_AND_AFTER, KNOTS_EACH)
        latitude, longitude = self._ground_track(time)
        phase = 2 * np.pi * time / self.period
        level = np.zeros_like(time)
        turn_rate = self.swing * 2 * np.pi / self.period * np.cos(phase)
        roll = np.arctan(self.speed * turn_rate / earth.gravity(latitude, self.height))
        yaw = self._yaw(time)
        channels = [latitude, longitude, level + self.height, roll, level, yaw]
        return Trajectory("weave", time, np.stack(channels, axis=-1))

    def _yaw(self, time: Array) -> Array:
        return self.heading + self.swing * np.sin(2 * np.pi * time / self.period)

    def _ground_track(self, time: Array) -> Array:
        """Latitudes and longitudes (2, n); the flight passes its start at time 0."""
        ends = solve_ivp(self._motion, (0.0, time[0]), [self.latitude, self.longitude], **_CLOSE)
        flown = solve_ivp(
            self._motion, (time[0], time[-1]), ends.y[:, -1], t_eval=time, max_step=1.0, **_CLOSE
        )
        return np.asarray(flown.y)

    def _motion(self, time: float, place: Array) -> list[float]:
        yaw = self._yaw(np.asarray(time))
        north = earth.meridian_radius(place[0]) + self.height
        east = (earth.transverse_radius(place[0]) + self.height) * np.cos(place[0])
        return [self.speed * np.cos(yaw) / north, self.speed * np.sin(yaw) / east]


_CLOSE = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
