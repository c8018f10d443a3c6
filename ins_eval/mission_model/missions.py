"""Missions of the study: all begin on the ground, powered on and aligned at rest.

A mission ends after the hours asked for, or earlier where its trajectory ends: a missile flies for
minutes.
"""

from dataclasses import dataclass
from pathlib import Path

from ins_eval.trajectories import catalogue, mission, mission_file
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.units import HOUR

STILL = 300.0
"""Time from power-on to the alignment's end, s (paper, 2.3)."""
SETTLING = 20.0
"""Time from power-on to the alignment's beginning, s. Chosen."""
WARM_UP = 600.0
"""Time constant with which a resonator follows its case, s: `Device.thermal_lag`. Chosen."""
CASE_WARM_UP = 300.0
"""Time constant with which the case warms after power-on, s. Chosen."""
LONGEST_HOURS = 10.0
"""Longest duration of a mission of the study, h."""


@dataclass(frozen=True)
class StudyMission:
    """A mission that is flown from power-on to its end.

    Attributes:
        name: the name in reports.
        source: name of a ready mission, or a file.
        hours: duration of the navigation.
        interval: time between the instants at which position errors are kept, s.
    """

    name: str
    source: str | Path
    hours: float
    interval: float

    def trajectory(self) -> Trajectory:
        """The true trajectory from power-on at -STILL s to the end."""
        return catalogue.load_trajectory(self.source, self.hours * HOUR, STILL)


def plan_mission(source: str | Path, hours: float) -> StudyMission:
    """A mission of the hours asked for, or of its own duration where that is shorter.

    source: name of a ready mission, or a file, as `catalogue.load_trajectory` takes it; hours:
    duration of the navigation, up to `LONGEST_HOURS`.
    """
    if not 0 < hours <= LONGEST_HOURS:
        raise TrajectoryError(
            f"{source}: found {hours:g} hours, expected above 0 to {LONGEST_HOURS:g}"
        )
    duration = min(compute_duration(source), hours * HOUR)
    interval = 600.0 if duration >= HOUR else 60.0
    whole = (duration + 1e-6) // interval * interval
    if whole < interval:
        raise TrajectoryError(f"{source}: lasts {duration:g} s, expected {interval:g} or more")
    return StudyMission(Path(source).name.split(".")[0], source, whole / HOUR, interval)


def compute_duration(source: str | Path) -> float:
    """Longest duration of a mission, s; infinite where it repeats, as recorded drives do."""
    path = catalogue.find_mission_file(source)
    if path.suffix != ".toml":
        return float("inf")
    return mission.compute_duration(mission_file.read_mission(path))
