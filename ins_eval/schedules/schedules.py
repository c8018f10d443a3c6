"""The front door of schedules: choose one by a triad's maps, and fly triads under those chosen."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from fmu_build.bundle import build_fmu
from ins_eval.common.metrics import MIN_SAMPLE_FOR_MEDIAN
from ins_eval.error_model.linear_model import AXES
from ins_eval.mission_model.bench_map import read_bench_map
from ins_eval.mission_model.missions import LONGEST_HOURS, StudyMission, plan_mission
from ins_eval.schedules import report
from ins_eval.schedules.choice import Planner, Prediction
from ins_eval.schedules.comparison import Comparison, Experiment, compare
from ins_eval.schedules.families import FAMILIES
from ins_eval.schedules.knowledge import describe_gyro
from ins_eval.schedules.schedule import Schedule
from ins_eval.schedules.weights import compute_mission_response
from ins_eval.study.cosimulated import sample_truth
from pyhrg.common.arguments import check_number, check_seed, check_whole_number
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import stage_files
from pyhrg.common.units import DEG, DEG_PER_H, PPM
from pyhrg.device.ready_devices import load_device
from pyhrg.fmu import GyroFmu

MAX_TRIADS = 10_000


class ScheduleComparison(Comparison):
    """Flights of the same triads under schedules chosen for them, and under others."""

    __repr__ = describe_briefly

    @property
    def summary(self) -> str:
        """Position errors by case, flown and predicted, as text."""
        return report.summarize(self)

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that `write` makes."""
        return report.FILES

    def plot(self) -> Figure:
        """Draw the growth of the position error by schedule, and errors predicted and flown."""
        return report.plot_comparison(self)

    def write(self, folder: Path | str) -> None:
        """Write `files` into a folder, all or none.

        Raises:
            OSError: the folder can't be written.
        """
        with stage_files(Path(folder), self.files) as aside:
            report.write(self, aside)


def compare_schedules(
    trajectory: str = "car",
    *,
    hours: float = 2.0,
    triads: int = 12,
    seed: int = 1,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> ScheduleComparison:
    """Fly triads under the schedules that the linear model chooses by their maps, and under others.

    Args:
        trajectory: ready mission, mission file (TOML) or recorded drive.
        hours: mission length, up to 10; a mission may end earlier.
        triads: number of triads, at least 6.
        seed: seed of all random numbers; the same result on any number of workers.
        workers: number of threads; as many as this process has cores if None.
        progress: function that is called with the steps done and those of all.

    Raises:
        HrgError: an argument out of range, or a trajectory that can't be flown.
    """
    check_whole_number("triads", triads, MIN_SAMPLE_FOR_MEDIAN, MAX_TRIADS)
    checked_seed, mission = check_seed(seed), _plan(trajectory, hours)
    planner = Planner(compute_mission_response(mission))
    experiment = Experiment(GyroFmu(build_fmu()), planner, sample_truth(mission))
    comparison = compare(
        experiment, mission, triads, checked_seed, workers=workers, progress=progress
    )
    return ScheduleComparison(**vars(comparison))


def _plan(trajectory: str, hours: float) -> StudyMission:
    return plan_mission(trajectory, check_number("hours", hours, 1 / 60, LONGEST_HOURS))


@dataclass(frozen=True)
class ChosenSchedules:
    """The schedules chosen for a triad in a mission.

    Attributes:
        mission: name of the mission; hours: its length.
        unscheduled: what is predicted without a schedule.
        chosen: what is predicted under each family's schedule, by the family's name.
    """

    mission: str
    hours: float
    unscheduled: Prediction
    chosen: dict[str, Prediction]

    __repr__ = describe_briefly

    @property
    def document(self) -> dict[str, Any]:
        """The commands of each schedule, and the error predicted, for other programs."""
        return {
            "mission": self.mission,
            "hours": self.hours,
            "unscheduled_rms_m": self.unscheduled.rms,
            "families": {
                name: {"rms_m": each.rms, **report.describe(each.schedule)}
                for name, each in self.chosen.items()
            },
        }

    @property
    def summary(self) -> str:
        """The commands of each schedule, and the error predicted, as text."""
        return report.summarize_choice(self.document)


def choose_schedules(
    bench: Sequence[Path | str],
    trajectory: str = "car",
    *,
    hours: float = 2.0,
    bench_drift: tuple[float, float] = (0.0, 0.0),
    start_angles_deg: Sequence[float] | None = None,
    device: str | Path = "typical",
) -> ChosenSchedules:
    """Choose where to park the patterns of a triad, how to turn its case, and how to turn its
    patterns, so that a mission's position error is least by the linear model.

    Args:
        bench: result.json of the bench's test `calibration` of the gyros that point forward, right
            and down.
        trajectory: ready mission, mission file (TOML) or recorded drive.
        hours: mission length, up to 10; a mission may end earlier.
        bench_drift: standard deviation of a term's change since the bench: of the bias, deg/h, and
            of the scale-factor error, ppm.
        start_angles_deg: the gyros' own pattern angles at power-on; by default unknown.
        device: ready device or file (TOML), whose noise and scatter of power-on angles count.

    Raises:
        HrgError: an argument out of range, a trajectory that can't be flown, a file that is no
            such result.
    """
    mission = _plan(trajectory, hours)
    if len(bench) != AXES:
        raise HrgError(f"bench: found {len(bench)} results, expected {AXES}")
    if start_angles_deg is not None and len(start_angles_deg) != AXES:
        raise HrgError(f"start_angles_deg: found {len(start_angles_deg)}, expected {AXES}")
    starts = [
        None if start is None else check_number("start_angles_deg", start, -360.0, 360.0) * DEG
        for start in start_angles_deg or (None,) * AXES
    ]
    drift = check_number("bench_drift", bench_drift[0], 0.0, 1e4) * DEG_PER_H
    scale_drift = check_number("bench_drift", bench_drift[1], 0.0, 1e4) * PPM
    noise = load_device(device)
    gyros = [
        describe_gyro(noise, read_bench_map(path, (drift, scale_drift)), start=start)
        for path, start in zip(bench, starts, strict=True)
    ]
    planner = Planner(compute_mission_response(mission))
    chosen = {family.name: planner.choose(family, gyros) for family in FAMILIES}
    return ChosenSchedules(mission.name, mission.hours, planner.predict(Schedule(), gyros), chosen)
