"""The front door of parking: the position error of level gyros whose patterns start at chosen
angles."""

from collections.abc import Callable
from pathlib import Path

from matplotlib.figure import Figure

from fmu_build.bundle import build_fmu
from ins_eval.common.metrics import MIN_SAMPLE_FOR_MEDIAN
from ins_eval.mission_model.missions import STILL
from ins_eval.parking import report
from ins_eval.parking.mission import sample_mission
from ins_eval.parking.report import plot_comparison
from ins_eval.parking.study import Comparison, compare
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.arguments import check_seed, check_whole_minutes, check_whole_number
from pyhrg.common.errors import describe_briefly
from pyhrg.common.files import stage_files

LONGEST_FLIGHT_HOURS = 24.0
"""Longest flight, h."""
MAX_TRIADS = 10_000
MARGIN = 10.0
"""Time by which trajectories go on beyond the mission's end, s, so that no spline ends in it."""


class ParkingComparison(Comparison):
    """Flights of the same triads with parked patterns and without."""

    __repr__ = describe_briefly

    @property
    def summary(self) -> str:
        """Position errors by case, and the cost of start-up, as text."""
        return report.summarize(self)

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that `write` makes."""
        return report.FILES

    def plot(self) -> Figure:
        """Draw the growth of the position error by case, and ratios to the first case."""
        return plot_comparison(self)

    def write(self, folder: Path | str) -> None:
        """Write `report.FILES` into a folder, all or none.

        Raises:
            OSError: the folder can't be written.
        """
        with stage_files(Path(folder), self.files) as aside:
            report.write(self, aside)


def compare_parking(
    trajectory: str = "car",
    *,
    hours: float = 2.0,
    triads: int = 12,
    seed: int = 1,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> ParkingComparison:
    """Fly triads with the level gyros' patterns parked where their bias is known, and without.

    Args:
        trajectory: ready mission, mission file (TOML) or recorded drive.
        hours: mission length, in whole minutes, up to 24.
        triads: number of triads, at least 6.
        seed: seed of all random numbers; the same result on any number of workers.
        workers: number of threads; as many as this process has cores if None.
        progress: function that is called with the gyro minutes done and those of all.

    Raises:
        HrgError: an argument out of range, or a trajectory that can't be flown.
    """
    check_whole_number("triads", triads, MIN_SAMPLE_FOR_MEDIAN, MAX_TRIADS)
    minutes = check_whole_minutes("hours", hours, LONGEST_FLIGHT_HOURS)
    path = load_trajectory(trajectory, minutes * 60 + MARGIN, STILL)
    mission = sample_mission(path, minutes / 60)
    checked_seed = check_seed(seed)
    comparison = compare(
        build_fmu(), mission, triads, checked_seed, workers=workers, progress=progress
    )
    return ParkingComparison(**vars(comparison))
