"""What a manoeuvre is: profiles of speed, turn, climb and roll that begin where the last ended."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import Checked
from ins_eval.trajectories.manoeuvres.signals import Signal, Steps

ZERO = Steps(0.0)


@dataclass(frozen=True)
class Entry:
    """How a vehicle enters a manoeuvre: m/s, rad, rad; local gravity, m/s^2."""

    speed: float
    climb_angle: float
    roll: float
    gravity: float


@dataclass(frozen=True)
class Leg:
    """A manoeuvre from its entry: functions of the time since, s.

    speed: along the path, m/s; climb_angle: of the path, rad; turn_rate: of the path's heading,
    rad/s, beside what a great circle asks for; roll: beside the bank, rad; lean: the bank as a
    share of that of a coordinated turn.
    """

    duration: float
    gravity: float
    speed: Signal
    climb_angle: Signal
    roll: Signal
    turn_rate: Signal = ZERO
    lean: float = 1.0
    great_circle: bool = False

    @property
    def signals(self) -> tuple[Signal, ...]:
        """All of them."""
        return self.speed, self.climb_angle, self.roll, self.turn_rate

    def exit(self) -> Entry:
        """How the next manoeuvre is entered."""
        return Entry(
            speed=float(self.speed(self.duration)),
            climb_angle=float(self.climb_angle(self.duration)),
            roll=float(self.roll(self.duration)),
            gravity=self.gravity,
        )


@dataclass(frozen=True, kw_only=True)
class Manoeuvre(Checked, ABC):
    """One part of a mission. Its fields are in SI; in files its keys carry units."""

    @abstractmethod
    def leg(self, entry: Entry) -> Leg:
        """Its profiles.

        Raises:
            TrajectoryError: it can't be entered like this.
        """


def held(entry: Entry, duration: float, **changes: object) -> Leg:
    """A leg on which everything stays as it was at the entry, but for the changes."""
    signals: dict[str, object] = {
        "speed": Steps(entry.speed),
        "climb_angle": Steps(entry.climb_angle),
        "roll": Steps(entry.roll),
    }
    return Leg(duration, entry.gravity, **(signals | changes))  # type: ignore[arg-type]


def horizontal_speed(entry: Entry) -> float:
    """Of a vehicle that is to turn on its path, m/s.

    Raises:
        TrajectoryError: it stands, or goes straight up.
    """
    speed = entry.speed * math.cos(entry.climb_angle)
    if speed < 0.1:
        raise TrajectoryError(
            f"speed: found {speed:.3g} m/s over ground, expected at least 0.1 m/s to turn at"
        )
    return speed


def must_stand(entry: Entry) -> None:
    """Refuse a vehicle that moves.

    Raises:
        TrajectoryError: says how fast.
    """
    if abs(entry.speed) > 1e-9:
        raise TrajectoryError(f"speed: found {entry.speed:g} m/s, expected 0: the vehicle stands")
