"""Free fall: the manoeuvre of a vehicle without thrust above the air."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import BSpline, make_interp_spline

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import Entry, Leg, Manoeuvre, make_leg
from ins_eval.trajectories.manoeuvres.signals import Steps, lobe
from pyhrg.common.arrays import Array

STEEPEST = math.radians(85.0)
"""Largest climb angle of a fall, rad. Chosen: straight up, the heading has no meaning."""
KNOTS_PER_RAMP = 24
"""Number of knots within a ramp. Chosen."""
TOLERANCE = 1e-11
"""Relative tolerance of the integration. Chosen like that of the path."""


@dataclass(frozen=True)
class Sampled:
    """A signal between times 0 and `length`, s, constant before and after.

    Attributes:
        breaks, scale: as of `Signal`.
    """

    spline: BSpline
    length: float
    breaks: tuple[float, ...]
    scale: float

    def __call__(self, time: Any) -> Any:
        return self.spline(np.clip(time, 0.0, self.length))


@dataclass(frozen=True, kw_only=True)
class Coast(Manoeuvre):
    """Coasts without thrust and lift; the specific force fades within `ramp` and returns at the
    end.

    Between the ramps the path is that of free fall on the rotating Earth.
    """

    duration: float = quantity("s", 2, 1e4)
    ramp: float = quantity("s", 1, 100, 3)

    def leg(self, entry: Entry) -> Leg:
        if entry.speed < 1 or abs(entry.climb_angle) > STEEPEST:
            raise TrajectoryError(
                f"found {entry.speed:.4g} m/s at a climb angle of "
                f"{math.degrees(entry.climb_angle):.4g} deg, expected at least 1 m/s within "
                f"{math.degrees(STEEPEST):g} deg"
            )
        ramp = min(self.ramp, self.duration / 2)
        share = Steps(0.0, lobe(1.0, ramp, self.duration - 2 * ramp))
        place = entry.place
        start = [place.latitude, place.height, place.heading, entry.speed, entry.climb_angle]
        time = np.linspace(0.0, self.duration, math.ceil(KNOTS_PER_RAMP * self.duration / ramp) + 1)
        solved = solve_ivp(
            lambda t, y: fall(y) * np.array([1, 1, *[float(share(t))] * 3]),
            (0.0, self.duration),
            start,
            method="DOP853",
            t_eval=time,
            max_step=ramp,
            rtol=TOLERANCE,
            atol=TOLERANCE,
        )
        turn_rate = share(time) * np.array([fall(y)[2] for y in solved.y.T])
        breaks = tuple(b for b in share.breaks if 0 < b < self.duration)
        speed, climb_angle, turn = (
            Sampled(make_interp_spline(time, values, k=5), self.duration, breaks, ramp)
            for values in (solved.y[3], solved.y[4], turn_rate)
        )
        return make_leg(
            entry, self.duration, speed=speed, climb_angle=climb_angle, turn_rate=turn, lean=0.0
        )


def fall(state: Array) -> Array:
    """Rates of latitude, height, heading, speed and climb angle in free fall (Groves 2013, Eq.
    5.53 without specific force)."""
    latitude, height, heading, speed, climb = map(float, state)
    sin, cos = math.sin(climb), math.cos(climb)
    level = np.array([math.cos(heading), math.sin(heading), 0.0])
    up = np.array([0.0, 0.0, -1.0])
    velocity = speed * (cos * level + sin * up)
    radius_n = float(earth.meridian_radius(latitude)) + height
    radius_e = float(earth.transverse_radius(latitude)) + height
    north, east = velocity[0] / radius_n, velocity[1] / radius_e
    turning = 2 * earth.rotation_rate(latitude) + [east, -north, -east * math.tan(latitude)]
    pull = [
        *earth.horizontal_gravity(latitude, height, (0.0, 0.0)),
        earth.gravity(latitude, height),
    ]
    acceleration = np.array(pull) - np.cross(turning, velocity)
    right = np.array([-level[1], level[0], 0.0])
    return np.array(
        [
            north,
            speed * sin,
            acceleration @ right / (speed * cos),
            acceleration @ (cos * level + sin * up),
            acceleration @ (cos * up - sin * level) / speed,
        ]
    )
