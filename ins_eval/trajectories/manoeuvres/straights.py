"""Manoeuvres without a turn of the path: rest, straight, accelerate, roll; and a turntable."""

from dataclasses import dataclass

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import choice, quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import (
    Entry,
    Leg,
    Manoeuvre,
    check_standing,
    make_leg,
)
from ins_eval.trajectories.manoeuvres.signals import Steps, lobe, step_to


@dataclass(frozen=True, kw_only=True)
class Rest(Manoeuvre):
    """The vehicle stands still."""

    duration: float = quantity("s", 0.1, 1e6)

    def leg(self, entry: Entry) -> Leg:
        check_standing(entry)
        return make_leg(entry, self.duration)


@dataclass(frozen=True, kw_only=True)
class Straight(Manoeuvre):
    """Continues at constant speed with constant heading (rhumb line) or on a great circle.

    The great circle is the geodesic of the surface at its height. By Clairaut's relation,
    (N + h) cos(latitude) sin(heading) is constant, so that the heading turns at the rate
    v tan(latitude) sin(heading) / (N + h).
    """

    duration: float = quantity("s", 0.1, 1e6)
    path: str = choice("rhumb", "great-circle")

    def leg(self, entry: Entry) -> Leg:
        return make_leg(entry, self.duration, great_circle=self.path == "great-circle")


@dataclass(frozen=True, kw_only=True)
class Accelerate(Manoeuvre):
    """Changes the speed smoothly; the peak acceleration is 1.875 times the mean. A negative speed
    reverses."""

    speed: float = quantity("m_s", -50, 4000)
    duration: float = quantity("s", 0.1, 1e6)

    def leg(self, entry: Entry) -> Leg:
        return make_leg(entry, self.duration, speed=step_to(entry.speed, self.speed, self.duration))


@dataclass(frozen=True, kw_only=True)
class Roll(Manoeuvre):
    """Rolls about the path, to the right if positive; 360 deg is one full roll."""

    roll: float = quantity("deg", -3600, 3600, 360)
    duration: float = quantity("s", 0.1, 1e4)

    def leg(self, entry: Entry) -> Leg:
        return make_leg(
            entry, self.duration, roll=step_to(entry.roll, entry.roll + self.roll, self.duration)
        )


@dataclass(frozen=True, kw_only=True)
class Turntable(Manoeuvre):
    """Turns about the vertical at rest, by an angle, at a rate that is reached within `ramp`."""

    turn: float = quantity("deg", -36_000, 36_000)
    rate: float = quantity("deg_s", 0.001, 1000)
    ramp: float = quantity("s", 0.1, 100, 1)

    def leg(self, entry: Entry) -> Leg:
        check_standing(entry)
        hold = abs(self.turn) / self.rate - self.ramp
        if hold < 0:
            raise TrajectoryError(
                f"turn_deg: found {abs(self.turn / self.rate):.3g} s at the full rate, "
                f"expected at least ramp_s, {self.ramp:g} s: turn further, or slower"
            )
        rate = self.rate if self.turn > 0 else -self.rate
        return make_leg(
            entry,
            hold + 2 * self.ramp,
            turn_rate=Steps(0.0, lobe(rate, self.ramp, hold)),
        )
