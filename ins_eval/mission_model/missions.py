"""Missions of the study: all begin on the ground, powered on and aligned at rest.

A mission lasts as long as asked for, or as long as it lasts: a missile flies for minutes.
"""

from dataclasses import dataclass
from pathlib import Path

from ins_eval.trajectories import catalogue, mission, mission_file
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.units import HOUR

STILL = 300.0
"""From power-on to the alignment's end, s (paper, 2.3)."""
SETTLING = 20.0
"""From power-on to the alignment's beginning, s."""
WARM_UP = 600.0
"""Time constant with which a resonator follows its case, s: the `thermal_lag` of gyros."""
CASE_WARM_UP = 300.0
"""Time constant with which the case warms after power-on, s."""
LONGEST = 10.0
"""Hours that a mission of the study may last."""
CLASSES = (
    "car",
    "aircraft",
    "airliner",
    "ship",
    "missile",
    "long-haul",
    "static-table",
)
"""Ready missions that start at rest; a recorded drive is the eighth."""


@dataclass(frozen=True)
class StudyMission:
    """name: for reports; source: name of a ready mission, or a file; hours: of navigation;
    kept: between the times at which errors are told, s."""

    name: str
    source: str | Path
    hours: float
    kept: float

    def trajectory(self) -> Trajectory:
        """From power-on at -STILL to the end."""
        return catalogue.trajectory(self.source, STILL, self.hours * HOUR)


def study_mission(source: str | Path, hours: float) -> StudyMission:
    """A mission over the hours asked for, or as long as it lasts.

    Args:
        source: name of a ready mission, or a file, as `catalogue.trajectory` takes it.
        hours: of navigation, up to 10.

    Raises:
        TrajectoryError: hours out of range; no such mission or file.
    """
    if not 0 < hours <= LONGEST:
        raise TrajectoryError(f"{source}: found {hours:g} hours, expected above 0 to {LONGEST:g}")
    duration = min(lasts(source), hours * HOUR)
    kept = 600.0 if duration >= HOUR else 60.0
    whole = (duration + 1e-6) // kept * kept
    if whole < kept:
        raise TrajectoryError(f"{source}: lasts {duration:g} s, expected {kept:g} or more")
    return StudyMission(Path(source).name.split(".")[0], source, whole / HOUR, kept)


def lasts(source: str | Path) -> float:
    """Longest duration of a mission, s; infinite if it repeats, as recorded drives do."""
    path = file_of(source)
    if path.suffix != ".toml":
        return float("inf")
    return mission.length(mission_file.read(path))


def file_of(source: str | Path) -> Path:
    """Where a mission is written down."""
    return catalogue.READY / f"{source}.toml" if source in catalogue.names() else Path(source)
