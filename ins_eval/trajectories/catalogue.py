"""Trajectories by name or file: ready missions, missions as TOML, recorded drives."""

from pathlib import Path

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.mission import build_trajectory
from ins_eval.trajectories.mission_file import read_mission
from ins_eval.trajectories.recorded_drive import read_drive, repeat_drive
from ins_eval.trajectories.trajectory import Trajectory

READY_FOLDER = Path(__file__).parent / "missions"
"""Folder of the missions that come with the package, one TOML file each."""


def list_trajectories() -> list[str]:
    """Return the names of the missions that come with the package."""
    return sorted(path.stem for path in READY_FOLDER.glob("*.toml"))


def find_mission_file(name_or_path: str | Path) -> Path:
    """The file of a mission that is named, or is a file itself."""
    if str(name_or_path) in list_trajectories():
        return READY_FOLDER / f"{name_or_path}.toml"
    return Path(name_or_path)


def load_trajectory(
    name_or_path: str | Path, duration_s: float, still_s: float = 0.0
) -> Trajectory:
    """Load the motion of a vehicle that stands still until time 0 and then moves.

    Args:
        name_or_path: name of a ready mission (`list_trajectories`), or a file: a mission (`.toml`)
            or a recorded drive (`.csv`, `.csv.gz`).
        duration_s: time after time 0, s.
        still_s: time at rest before time 0, s; 0 for a mission that starts in motion.

    Raises:
        TrajectoryError: no such mission or file; a file that is wrong; a mission that is shorter
            than the duration or can't stand still.
    """
    path = find_mission_file(name_or_path)
    if path.suffix == ".toml":
        return build_trajectory(read_mission(path), duration_s, still_s)
    if not path.suffix and not path.exists():
        raise TrajectoryError(
            f"{name_or_path}: found no such mission, expected {', '.join(list_trajectories())}, "
            "or a file .toml, .csv or .csv.gz"
        )
    return repeat_drive(read_drive(path), duration_s, still_s)
