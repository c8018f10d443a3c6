"""Ready-made manoeuvres as knots of a trajectory."""

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import cumulative_trapezoid

from ins_eval import earth
from ins_eval.trajectories.trajectory import Knots, Trajectory

Array = NDArray[np.float64]

TURNS_DEG = (90, 90, -180, 45, -135, 90, -90, 180, -45, 135)
"""Heading changes of the car's round, one at each junction."""
LEG = 240.0
"""Time between junctions, s."""
TURN = 20.0
"""Duration of a turn, s."""
SPEEDS = (14.0, 22.0, 10.0, 25.0, 17.0)
"""Speed of successive legs, m/s."""
DEPARTURE = 20.0
"""Time that the car still stands after time 0, s."""


def car(still: float, duration: float) -> Trajectory:
    """A car that stands, then drives legs of four minutes between junctions.

    It turns by 45 to 180 degrees at each junction, so that heading goes through the full circle;
    hills pitch it by 2 degrees, and it leans out of its turns by up to 3 degrees.

    Args:
        still: time at rest before time 0, s.
        duration: time after it, s.
    """
    fine = np.arange(-still, duration + 30.0, 0.1)
    heading = np.full_like(fine, np.deg2rad(30.0))
    speed = _ramp(fine, DEPARTURE, 15.0) * SPEEDS[0]
    for leg in range(int(duration / LEG) + 1):
        junction = DEPARTURE + (leg + 1) * LEG
        heading += np.deg2rad(TURNS_DEG[leg % len(TURNS_DEG)]) * _ramp(fine, junction, TURN)
        step = SPEEDS[(leg + 1) % len(SPEEDS)] - SPEEDS[leg % len(SPEEDS)]
        speed += step * _ramp(fine, junction - 15.0, 15.0)
    moving = _ramp(fine, DEPARTURE, 60.0)
    pitch = np.deg2rad(2.0) * moving * np.sin(2 * np.pi * fine / 310.0)
    height = 50.0 + cumulative_trapezoid(speed * np.sin(pitch), fine, initial=0.0)
    roll = -0.15 * speed / 9.8 * np.gradient(heading, fine)
    latitude, longitude = _dead_reckoned(
        fine, speed * np.cos(pitch), heading, height, np.deg2rad(39.9), np.deg2rad(116.4)
    )
    each = slice(None, None, 10)
    knots = Knots(*(x[each] for x in (fine, latitude, longitude, height, roll, pitch, heading)))
    return Trajectory("car", knots)


def _ramp(time: Array, start: float, length: float) -> Array:
    """From 0 to 1 with continuous acceleration."""
    s = np.clip((time - start) / length, 0.0, 1.0)
    return np.asarray(s**3 * (10 - 15 * s + 6 * s**2))


def _dead_reckoned(
    time: Array, speed: Array, heading: Array, height: Array, latitude: float, longitude: float
) -> tuple[Array, Array]:
    north = cumulative_trapezoid(speed * np.cos(heading), time, initial=0.0)
    lat = latitude + north / (earth.meridian_radius(latitude) + height)
    east_rate = speed * np.sin(heading) / (earth.transverse_radius(lat) + height) / np.cos(lat)
    return lat, longitude + cumulative_trapezoid(east_rate, time, initial=0.0)
