"""Manoeuvres in the vertical plane."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import Entry, Leg, Manoeuvre, make_leg
from ins_eval.trajectories.manoeuvres.signals import Step, Steps, lobe, smooth_step, step_to


@dataclass(frozen=True, kw_only=True)
class Climb(Manoeuvre):
    """A change of height from level flight to level flight, downward if it is negative.

    A small change is flown at a smaller climb angle.
    """

    height_change: float = quantity("m", -50_000, 50_000)
    climb_angle: float = quantity("deg", 0.1, 80, 5)
    ramp: float = quantity("s", 0.1, 1000, 10)

    def leg(self, entry: Entry) -> Leg:
        if abs(entry.climb_angle) > 1e-9 or entry.speed < 0.1:
            raise TrajectoryError(
                f"found a climb angle of {math.degrees(entry.climb_angle):.4g} deg at "
                f"{entry.speed:.4g} m/s, expected level flight"
            )
        rise = abs(self.height_change) / entry.speed
        angle, hold = self.climb_angle, 0.0
        if _rise_on_ramps(angle, self.ramp) <= rise:
            hold = (rise - _rise_on_ramps(angle, self.ramp)) / math.sin(angle)
        else:
            angle = float(
                brentq(lambda a: _rise_on_ramps(a, self.ramp) - rise, 0.0, angle, xtol=1e-15)
            )
        steps = lobe(math.copysign(angle, self.height_change), self.ramp, hold)
        return make_leg(entry, hold + 2 * self.ramp, climb_angle=Steps(0.0, steps))


@dataclass(frozen=True, kw_only=True)
class Pitch(Manoeuvre):
    """Changes the climb angle, up or down."""

    climb_angle: float = quantity("deg", -80, 90)
    duration: float = quantity("s", 0.1, 1e4)

    def leg(self, entry: Entry) -> Leg:
        profile = step_to(entry.climb_angle, self.climb_angle, self.duration)
        return make_leg(entry, self.duration, climb_angle=profile)


@dataclass(frozen=True, kw_only=True)
class Boost(Manoeuvre):
    """A vertical launch: accelerates for `duration`, and pitches over after `vertical`."""

    speed: float = quantity("m_s", 1, 4000)
    duration: float = quantity("s", 1, 1000)
    vertical: float = quantity("s", 0, 1000)
    climb_angle: float = quantity("deg", -10, 90)

    def leg(self, entry: Entry) -> Leg:
        if abs(entry.climb_angle - math.pi / 2) > 1e-9:
            raise TrajectoryError(
                f"found a climb angle of {math.degrees(entry.climb_angle):.4g} deg, expected 90: "
                "a boost begins upright (start.climb_angle_deg = 90)"
            )
        over = self.duration - self.vertical
        if over < 0.1:
            raise TrajectoryError(
                f"vertical_s: found {self.vertical:g}, expected at least 0.1 s less than "
                f"duration_s, {self.duration:g}"
            )
        pitch_over = Step(self.vertical, over, self.climb_angle - entry.climb_angle)
        return make_leg(
            entry,
            self.duration,
            speed=step_to(entry.speed, self.speed, self.duration),
            climb_angle=Steps(entry.climb_angle, (pitch_over,)),
        )


def _rise_on_ramps(angle: float, ramp: float) -> float:
    """Return the rise on the two ramps to a climb angle and back, per speed, s."""
    points, weights = np.polynomial.legendre.leggauss(30)
    return ramp * float(weights @ np.sin(angle * smooth_step(0.5 * (points + 1))))
