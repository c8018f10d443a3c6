"""Missions as data: a start and manoeuvres, from which a trajectory is built."""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.common import earth
from ins_eval.trajectories import path
from ins_eval.trajectories.errors import MovingStartError, TrajectoryError, check_durations
from ins_eval.trajectories.keys import Checked, quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import Entry, Leg, Manoeuvre, Place
from ins_eval.trajectories.manoeuvres.overlays import Overlay
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array

HEIGHT_RANGE = (-1000.0, 200_000.0)
"""Heights that a mission may reach, m. Chosen."""
MAX_SPECIFIC_FORCE = 1000.0
"""Largest specific force, m/s^2. Chosen: no vehicle withstands more, so a number must be wrong."""
MAX_ROTATION_RATE = 100.0
"""Largest rotation rate, rad/s. Chosen like `MAX_SPECIFIC_FORCE`."""
END_MARGIN = 10.0
"""Time by which a trajectory outlasts the duration asked for, s, so that no spline ends in it."""


@dataclass(frozen=True, kw_only=True)
class Start(Checked):
    """Place, heading and speed at time 0. `climb_angle` is the pitch of the nose as well."""

    latitude: float = quantity("deg", -89, 89)
    longitude: float = quantity("deg", -180, 180)
    height: float = quantity("m", -500, 100_000, 0)
    heading: float = quantity("deg", -360, 360, 0)
    speed: float = quantity("m_s", 0, 4000, 0)
    climb_angle: float = quantity("deg", -80, 90, 0)


@dataclass(frozen=True, kw_only=True)
class Deflection(Checked):
    """Deflection of the vertical, the same everywhere: the zenith leans to the north and the east.

    The truth has it; the navigator does not, unless told (`navigate(deflection=...)`). An alignment
    at rest takes it for a tilt, which cancels most of its effect on the navigation.
    """

    north: float = quantity("arcsec", -100, 100, 0)
    east: float = quantity("arcsec", -100, 100, 0)


@dataclass(frozen=True, kw_only=True)
class Mission:
    """Manoeuvres one after another, and overlays that act from time 0.

    The `departure` is flown once, then the `course` is flown `repeat` times; None repeats it for as
    long as asked.
    """

    name: str
    start: Start
    course: tuple[Manoeuvre, ...]
    departure: tuple[Manoeuvre, ...] = ()
    overlays: tuple[Overlay, ...] = ()
    repeat: int | None = 1
    deflection: Deflection = Deflection()

    def manoeuvres(self) -> Iterator[tuple[str, Manoeuvre]]:
        """Yield all manoeuvres with their places in the file; endless if `repeat` is None."""
        departure = [(f"departure {i}", m) for i, m in enumerate(self.departure, 1)]
        course = [(f"course {i}", m) for i, m in enumerate(self.course, 1)]
        rounds = itertools.count() if self.repeat is None else range(self.repeat)
        yield from departure
        for _ in rounds:
            yield from course


def build_trajectory(mission: Mission, duration: float, still: float = 0.0) -> Trajectory:
    """Build the trajectory of a mission, which stands still for `still` s and moves from time 0 for
    `duration` s."""
    check_durations(mission.name, duration, still)
    if still > 0 and mission.start.speed > 0:
        raise MovingStartError(
            f"{mission.name}: starts at {mission.start.speed:g} m/s, expected at rest: it can't "
            f"stand still for {still:g} s before"
        )
    legs = _build_legs(mission, duration + END_MARGIN)
    total = _sum_durations(legs)
    if total < duration - 1e-6:
        raise TrajectoryError(
            f"{mission.name}: lasts {total:.6g} s, shorter than the {duration:g} s asked for"
        )
    motions = [overlay.motion() for overlay in mission.overlays]
    until = min(total, duration + END_MARGIN)
    start = mission.start
    origin = np.array([start.latitude, start.longitude, start.height, start.heading])
    try:
        time, channels = path.compute_knots(origin, legs, motions, still, until)
    except TrajectoryError as error:
        raise TrajectoryError(f"{mission.name}: {error}") from None
    deflection = mission.deflection
    trajectory = Trajectory(mission.name, time, channels, (deflection.north, deflection.east))
    _check_ranges(trajectory, time, channels[:, 2])
    return trajectory


def _check_joint(before: Leg, after: Leg) -> None:
    """Check that the turn rate, and with it the bank, is continuous between two legs."""
    end_rate, start_rate = float(before.turn_rate(before.duration)), float(after.turn_rate(0.0))
    if abs(end_rate - start_rate) > 1e-9:
        raise TrajectoryError(
            f"turns at {math.degrees(start_rate):.3g} deg/s at its beginning, and the manoeuvre "
            f"before ends at {math.degrees(end_rate):.3g} deg/s; expected the same: give a weave a "
            "ramp_s"
        )


def _check_ranges(trajectory: Trajectory, time: Array, height: Array) -> None:
    omega, force = trajectory.rate_and_force(time)
    low, high = HEIGHT_RANGE
    for values, lowest, highest, unit in (
        (height, low, high, "m of height"),
        (np.linalg.norm(force, axis=-1), 0.0, MAX_SPECIFIC_FORCE, "m/s2 of specific force"),
        (np.linalg.norm(omega, axis=-1), 0.0, MAX_ROTATION_RATE, "rad/s"),
    ):
        wrong = ~((values >= lowest) & (values <= highest))
        if np.any(wrong):
            i = int(np.argmax(wrong))
            raise TrajectoryError(
                f"{trajectory.name}: at {time[i]:.1f} s it has {values[i]:.4g} {unit}; "
                f"expected {lowest:g} to {highest:g}: is a speed too high, or a duration too short?"
            )


def compute_duration(mission: Mission) -> float:
    """Return the time from 0 to the end of the last manoeuvre, s; infinite for an endless
    mission."""
    return math.inf if mission.repeat is None else _sum_durations(_build_legs(mission, math.inf))


def _sum_durations(legs: Sequence[Leg]) -> float:
    return math.fsum(leg.duration for leg in legs)


def _build_legs(mission: Mission, until: float) -> list[Leg]:
    start = mission.start
    gravity = float(earth.gravity(start.latitude, start.height))
    origin = Place(start.latitude, start.height, start.heading)
    entry = Entry(start.speed, start.climb_angle, 0.0, gravity, origin)
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
