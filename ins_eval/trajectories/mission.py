"""A mission: where it starts and what is done, as data; flown, it is a trajectory."""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.common import earth
from ins_eval.trajectories import path
from ins_eval.trajectories.errors import MovingStartError, TrajectoryError
from ins_eval.trajectories.keys import Checked, quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import Entry, Leg, Manoeuvre
from ins_eval.trajectories.manoeuvres.overlays import Overlay
from ins_eval.trajectories.trajectory import Knots, Trajectory

HEIGHTS = (-1000.0, 200_000.0)
"""That can be flown, m."""
HARDEST = 1000.0
"""Specific force that a vehicle can feel, m/s^2: beyond it, a number is wrong."""
FASTEST = 100.0
"""Its rotation rate, rad/s."""
BEYOND = 10.0
"""Time that a repeated course goes on after the end asked for, s."""


@dataclass(frozen=True, kw_only=True)
class Start(Checked):
    """Where a mission starts, which way it heads, and how fast. `climb_angle` is the nose's too."""

    latitude: float = quantity("deg", -89, 89)
    longitude: float = quantity("deg", -180, 180)
    height: float = quantity("m", -500, 100_000, 0)
    heading: float = quantity("deg", -360, 360, 0)
    speed: float = quantity("m_s", 0, 4000, 0)
    climb_angle: float = quantity("deg", -80, 90, 0)


@dataclass(frozen=True, kw_only=True)
class Mission:
    """Manoeuvres one after another: `departure` once, then `course`, `repeat` times, or as often as
    the time asked for needs if None; overlays beside them, from time 0."""

    name: str
    start: Start
    course: tuple[Manoeuvre, ...]
    departure: tuple[Manoeuvre, ...] = ()
    overlays: tuple[Overlay, ...] = ()
    repeat: int | None = 1

    def manoeuvres(self) -> Iterator[tuple[str, Manoeuvre]]:
        """All in turn, with their places in the file; without end if `repeat` is None."""
        departure = [(f"departure {i}", m) for i, m in enumerate(self.departure, 1)]
        course = [(f"course {i}", m) for i, m in enumerate(self.course, 1)]
        rounds = itertools.count() if self.repeat is None else range(self.repeat)
        yield from departure
        for _ in rounds:
            yield from course


def trajectory(mission: Mission, still: float, duration: float) -> Trajectory:
    """Fly a mission: at rest before time 0, then its manoeuvres.

    Args:
        mission: what to do.
        still: time at rest before time 0, s; 0 for a mission that starts in motion.
        duration: time after it, s.

    Raises:
        TrajectoryError: times below 0; a manoeuvre that can't be entered; a mission shorter than
            the duration or beyond 89 deg of latitude; heights, forces or rates that no vehicle has.
        MovingStartError: in motion when it should stand.
    """
    if not (0 <= still < math.inf and 0 < duration < math.inf):
        raise TrajectoryError(
            f"{mission.name}: found {still:g} s at rest and {duration:g} s after, expected 0 or "
            "more and above 0"
        )
    if still > 0 and mission.start.speed > 0:
        raise MovingStartError(
            f"{mission.name}: starts at {mission.start.speed:g} m/s, expected at rest: it can't "
            f"stand still for {still:g} s before"
        )
    legs = _legs(mission, duration + BEYOND)
    lasts = _length(legs)
    if lasts < duration - 1e-6:
        raise TrajectoryError(
            f"{mission.name}: lasts {lasts:.6g} s, shorter than the {duration:g} s asked for"
        )
    motions = [overlay.motion() for overlay in mission.overlays]
    until = min(lasts, duration + BEYOND)
    try:
        knots = path.knots(_origin(mission.start), legs, motions, still, until)
    except TrajectoryError as error:
        raise TrajectoryError(f"{mission.name}: {error}") from None
    flown = Trajectory(mission.name, knots)
    _check(flown, knots)
    return flown


def _check_joint(before: Leg, after: Leg) -> None:
    """Rates of turn meet, as the bank follows them."""
    ends, begins = float(before.turn_rate(before.duration)), float(after.turn_rate(0.0))
    if abs(ends - begins) > 1e-9:
        raise TrajectoryError(
            f"turns at {math.degrees(begins):.3g} deg/s from the first, where the manoeuvre before "
            f"ends at {math.degrees(ends):.3g} deg/s; expected the same: give a weave a ramp_s"
        )


def _check(flown: Trajectory, knots: Knots) -> None:
    omega, force = flown.rate_and_force(knots.time)
    low, high = HEIGHTS
    for values, least, most, what in (
        (knots.height, low, high, "m of height"),
        (np.linalg.norm(force, axis=-1), 0.0, HARDEST, "m/s2 of specific force"),
        (np.linalg.norm(omega, axis=-1), 0.0, FASTEST, "rad/s"),
    ):
        wrong = ~((values >= least) & (values <= most))
        if np.any(wrong):
            i = int(np.argmax(wrong))
            raise TrajectoryError(
                f"{flown.name}: at {knots.time[i]:.1f} s it has {values[i]:.4g} {what}; "
                f"expected {least:g} to {most:g}: is a speed too high, or a duration too short?"
            )


def length(mission: Mission) -> float:
    """Time from 0 to the end of the last manoeuvre, s; infinite if it repeats without end.

    Raises:
        TrajectoryError: a manoeuvre that can't be entered.
    """
    return math.inf if mission.repeat is None else _length(_legs(mission, math.inf))


def _length(legs: Sequence[Leg]) -> float:
    return math.fsum(leg.duration for leg in legs)


def _origin(start: Start) -> path.Origin:
    return path.Origin(start.latitude, start.longitude, start.height, start.heading)


def _legs(mission: Mission, until: float) -> list[Leg]:
    start = mission.start
    gravity = float(earth.gravity(start.latitude, start.height))
    entry = Entry(start.speed, start.climb_angle, 0.0, gravity)
    legs: list[Leg] = []
    time = 0.0
    for place, manoeuvre in mission.manoeuvres():
        try:
            leg = manoeuvre.leg(entry)
            if legs:
                _check_joint(legs[-1], leg)
            legs.append(leg)
        except TrajectoryError as error:
            raise TrajectoryError(f"{mission.name}: {place}: {error}") from None
        entry = legs[-1].exit()
        time += legs[-1].duration
        if time >= until:
            break
    return legs
