"""Trajectories by name or file: ready missions, missions as TOML, recorded drives."""

from pathlib import Path

from ins_eval.trajectories import mission, mission_file, recorded_drive
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory

READY = Path(__file__).parent / "missions"


def names() -> list[str]:
    """Of the missions that come with the package."""
    return sorted(path.stem for path in READY.glob("*.toml"))


def trajectory(name_or_path: str | Path, still: float, duration: float) -> Trajectory:
    """A trajectory that stands still before time 0 and then moves.

    Args:
        name_or_path: of a ready mission (`names`), or a file: a mission (`.toml`) or a recorded
            drive (`.csv`, `.csv.gz`).
        still: time at rest before time 0, s; 0 for a mission that starts in motion.
        duration: time after it, s.

    Raises:
        TrajectoryError: no such mission or file; a file that is wrong; a mission that is shorter
            than the duration or can't stand still.
    """
    if str(name_or_path) in names():
        path = READY / f"{name_or_path}.toml"
        return mission.trajectory(mission_file.read(path), still, duration)
    path = Path(name_or_path)
    if path.suffix == ".toml":
        return mission.trajectory(mission_file.read(path), still, duration)
    if not path.suffix and not path.exists():
        raise TrajectoryError(
            f"{name_or_path}: found no such mission, expected {', '.join(names())}, "
            "or a file .toml, .csv or .csv.gz"
        )
    return recorded_drive.trajectory(recorded_drive.read(path), still, duration)
