"""Trajectories: motion of a vehicle as smooth functions of time, with an ideal IMU's increments.

A trajectory is a quintic spline through position and attitude. Velocity, acceleration and rates
are its exact derivatives, and the IMU's increments integrate them by Gauss-Legendre quadrature:
nothing here inverts the equations of the navigator.
"""

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from ins_eval.common import earth
from ins_eval.common.rotation import body_rate_from_euler, mat_from_euler
from ins_eval.common.state import State, Track
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(3)
_SLACK = 1e-6
"""Tolerance for the rounding of times, s."""
_CHUNK = 20_000
"""Intervals that are integrated at once; chosen to limit memory."""


class Trajectory:
    """Motion of a vehicle between the times `start` and `end`, s, of its first and last knot.

    Args:
        name: name in reports.
        time: (n,) times of the knots, s.
        channels: (n, 6) latitude, longitude, rad, height, m, roll, pitch, yaw, rad, at the knots,
            without jumps of a turn.
        deflection: deflection of the vertical along all of it, north and east, rad.
        remark: what a user should know of how it was made.
    """

    def __init__(
        self,
        name: str,
        time: Array,
        channels: Array,
        deflection: tuple[float, float] = (0.0, 0.0),
        remark: str = "",
    ) -> None:
        self.name = name
        self.remark = remark
        self.deflection = deflection
        self.start = float(time[0])
        self.end = float(time[-1])
        self._origin = np.append(channels[0, :3], np.zeros(3))
        """Position at the first knot; the spline holds differences from it, exactly 0 at rest."""
        self._spline: BSpline = make_interp_spline(time, channels - self._origin, k=5)
        self._knots = np.unique(self._spline.t)
        self._rate = self._spline.derivative(1)
        self._acceleration = self._spline.derivative(2)

    def position(self, time: Array) -> Array:
        """Return latitude, longitude, rad, and height, m, (..., 3) at times (...), s."""
        return self._channels(time)[..., :3]

    def _channels(self, time: Array) -> Array:
        return np.asarray(self._spline(time) + self._origin)

    def mat_nb(self, time: Array) -> Array:
        """Return attitudes (..., 3, 3), body to navigation axes, at times (...), s."""
        euler = self._channels(time)[..., 3:]
        return mat_from_euler(euler[..., 0], euler[..., 1], euler[..., 2])

    def velocity(self, time: Array) -> Array:
        """Return velocity over ground (..., 3), north, east, down, m/s, at times (...), s."""
        return self._velocity(self._channels(time), self._rate(time))

    @staticmethod
    def _velocity(position: Array, rate: Array) -> Array:
        """Return the velocity (..., 3), m/s, of positions and their rates (..., 6)."""
        north = earth.meridian_radius(position[..., 0]) + position[..., 2]
        east = earth.transverse_radius(position[..., 0]) + position[..., 2]
        return np.stack(
            [
                rate[..., 0] * north,
                rate[..., 1] * east * np.cos(position[..., 0]),
                -rate[..., 2],
            ],
            axis=-1,
        )

    def track(self, time: Array) -> Track:
        """Return the states at times (m,), s."""
        return Track(time, self.position(time), self.velocity(time), self.mat_nb(time))

    def state(self, time: float) -> State:
        """Return the state at one time, s."""
        t = np.array(time)
        latitude, longitude, height = map(float, self.position(t))
        return State(latitude, longitude, height, self.velocity(t), self.mat_nb(t))

    def rate_and_force(self, time: Array) -> tuple[Array, Array]:
        """Return `omega_ib_b` (..., 3), rad/s, and specific force `f_b` (..., 3), m/s^2."""
        x, dx, ddx = self._channels(time), self._rate(time), self._acceleration(time)
        latitude, height = x[..., 0], x[..., 2]
        mat_nb = mat_from_euler(x[..., 3], x[..., 4], x[..., 5])
        sin, cos = np.sin(latitude), np.cos(latitude)
        omega_ie = earth.rotation_rate(latitude)
        omega_en = np.stack([dx[..., 1] * cos, -dx[..., 0], -dx[..., 1] * sin], axis=-1)
        omega_nb_b = body_rate_from_euler(x[..., 3], x[..., 4], dx[..., 3], dx[..., 4], dx[..., 5])
        omega_ib_b = omega_nb_b + _to_body(mat_nb, omega_ie + omega_en)
        force = self._acceleration_n(x, dx, ddx) + np.cross(
            2 * omega_ie + omega_en, self._velocity(x, dx)
        )
        north, east = earth.horizontal_gravity(latitude, height, self.deflection)
        force -= np.stack([north, east, earth.gravity(latitude, height)], axis=-1)
        return omega_ib_b, _to_body(mat_nb, force)

    def increments(self, start: float, interval: float, count: int) -> Increments:
        """Return the increments of an ideal IMU over `count` intervals, s, from time `start`, s.

        Raises:
            ValueError: intervals outside the trajectory.
        """
        end = start + interval * count
        if start < self.start - _SLACK or end > self.end + _SLACK:
            raise ValueError(
                f"increments from {start:g} to {end:g} s; {self.name} goes from {self.start:g} "
                f"to {self.end:g} s"
            )
        both = np.empty((count, 6))
        for first in range(0, count, _CHUNK):
            last = min(first + _CHUNK, count)
            bounds = interval * np.arange(last - first + 1.0)
            both[first:last] = self._integrals(start + interval * first, bounds)
        return Increments(interval, both[:, :3].copy(), both[:, 3:].copy(), start)

    def _integrals(self, begin: float, bounds: Array) -> Array:
        """Integrate rate and force (n, 6) between bounds (n + 1,), s since `begin`.

        Panels end at knots too, where higher derivatives jump.
        """
        knots = self._knots - begin
        inside = (knots > 0) & (knots < bounds[-1])
        edges = np.unique(np.concatenate([bounds, knots[inside]]))
        half = 0.5 * np.diff(edges)[:, None]
        time = begin + 0.5 * (edges[1:] + edges[:-1])[:, None] + half * _NODES
        rate_and_force = np.concatenate(self.rate_and_force(time), axis=-1)
        panels = half * (_WEIGHTS @ rate_and_force)
        return np.add.reduceat(panels, np.searchsorted(edges, bounds[:-1]))

    @staticmethod
    def _acceleration_n(x: Array, dx: Array, ddx: Array) -> Array:
        """Return the time derivatives (..., 3) of the velocity's components."""
        latitude, height = x[..., 0], x[..., 2]
        sin, cos = np.sin(latitude), np.cos(latitude)
        meridian, transverse = earth.meridian_radius(latitude), earth.transverse_radius(latitude)
        w = 1 - earth.ECCENTRICITY_SQUARED * sin**2
        bulge = earth.ECCENTRICITY_SQUARED * sin * cos / w * dx[..., 0]
        north = meridian + height
        east = transverse + height
        north_rate = 3 * meridian * bulge + dx[..., 2]
        east_rate = transverse * bulge + dx[..., 2]
        return np.stack(
            [
                ddx[..., 0] * north + dx[..., 0] * north_rate,
                (ddx[..., 1] * east + dx[..., 1] * east_rate) * cos
                - dx[..., 1] * east * sin * dx[..., 0],
                -ddx[..., 2],
            ],
            axis=-1,
        )


def _to_body(mat_nb: Array, vector_n: Array) -> Array:
    return np.einsum("...ij,...i->...j", mat_nb, vector_n)
