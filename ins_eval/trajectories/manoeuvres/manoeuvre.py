"""Manoeuvres: profiles of speed, turn, climb and roll that continue those of the one before."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_trapezoid, trapezoid

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import Checked
from ins_eval.trajectories.manoeuvres.signals import Signal, Steps

ZERO = Steps(0.0)
PLACE_POINTS = 65
"""Points of a leg at which its place is followed. Chosen: a fall needs gravity to 1e-3."""


@dataclass(frozen=True)
class Place:
    """About where a manoeuvre begins: latitude, rad; height, m; heading of the path, rad."""

    latitude: float = 0.0
    height: float = 0.0
    heading: float = 0.0


@dataclass(frozen=True)
class Entry:
    """State at a manoeuvre's beginning: speed, m/s; climb angle and roll, rad; gravity at the
    mission's start, m/s^2; place."""

    speed: float
    climb_angle: float
    roll: float
    gravity: float
    place: Place = Place()


@dataclass(frozen=True)
class Leg:
    """A manoeuvre from its entry, as functions of the time since then, s.

    Attributes:
        speed: along the path, m/s.
        climb_angle: climb angle of the path, rad.
        turn_rate: turn rate of the path's heading, rad/s, in addition to that of a great circle.
        roll: roll in addition to the bank, rad.
        lean: ratio of the bank to that of a coordinated turn.
        place: place where the leg begins.
    """

    duration: float
    gravity: float
    speed: Signal
    climb_angle: Signal
    roll: Signal
    turn_rate: Signal = ZERO
    lean: float = 1.0
    great_circle: bool = False
    place: Place = Place()

    @property
    def signals(self) -> tuple[Signal, ...]:
        return self.speed, self.climb_angle, self.roll, self.turn_rate

    def exit(self) -> Entry:
        """Return the state in which the next manoeuvre begins."""
        return Entry(
            speed=float(self.speed(self.duration)),
            climb_angle=float(self.climb_angle(self.duration)),
            roll=float(self.roll(self.duration)),
            gravity=self.gravity,
            place=self._move_place(),
        )

    def _move_place(self) -> Place:
        """Place at the end, on a sphere and without overlays, by the trapezoidal rule."""
        time = np.linspace(0.0, self.duration, PLACE_POINTS)
        step = time[1]
        speed, climb = self.speed(time), self.climb_angle(time)
        turned = cumulative_trapezoid(self.turn_rate(time), dx=step, initial=0.0)
        heading = self.place.heading + turned
        north = trapezoid(speed * np.cos(climb) * np.cos(heading), dx=step)
        return Place(
            latitude=self.place.latitude + float(north) / earth.SEMI_MAJOR,
            height=self.place.height + float(trapezoid(speed * np.sin(climb), dx=step)),
            heading=float(heading[-1]),
        )


@dataclass(frozen=True, kw_only=True)
class Manoeuvre(Checked, ABC):
    """One part of a mission. Its fields are in SI; in files its keys carry units."""

    @abstractmethod
    def leg(self, entry: Entry) -> Leg:
        """Return the manoeuvre's profiles."""


def make_leg(entry: Entry, duration: float, **changes: object) -> Leg:
    """Make a leg on which all signals keep their values at the entry, except those in `changes`."""
    signals: dict[str, object] = {
        "speed": Steps(entry.speed),
        "climb_angle": Steps(entry.climb_angle),
        "roll": Steps(entry.roll),
    }
    return Leg(duration, entry.gravity, place=entry.place, **(signals | changes))  # type: ignore[arg-type]


def horizontal_speed(entry: Entry) -> float:
    """Return the speed over ground, m/s, of a vehicle that is about to turn."""
    speed = abs(entry.speed) * math.cos(entry.climb_angle)
    if speed < 0.1:
        raise TrajectoryError(
            f"speed: found {speed:.3g} m/s over ground, expected at least 0.1 m/s to turn at"
        )
    return speed


def check_standing(entry: Entry) -> None:
    if abs(entry.speed) > 1e-9:
        raise TrajectoryError(f"speed: found {entry.speed:g} m/s, expected 0: the vehicle stands")
