"""The front door of the validation: the small study, with options in place of some keys."""

from dataclasses import replace
from pathlib import Path

from ins_eval.mission_model.missions import plan_mission
from ins_eval.study.run.block import Arrays
from ins_eval.study.run.run import Cluster, Progress
from ins_eval.study.run_study import StudyResult, make_experiment, run_to_result
from ins_eval.study.specification import (
    CALIBRATIONS,
    LARGEST_TRIADS,
    LONGEST_HOURS,
    MEAN,
    PlannedMission,
    Study,
    compute_fewest_judged,
)
from ins_eval.study.study_data import read_study_data
from ins_eval.study.study_file import load_study
from ins_eval.study.validation.result_files import FILES, write_files
from ins_eval.trajectories.catalogue import find_mission_file
from pyhrg.common.arguments import check_number, check_seed, check_whole_number
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import LOG_BYTES

PRESET = "small"
"""The ready study that a validation runs; its values are the defaults of `validate`."""


def validate(
    out: Path | str,
    *,
    seed: int = 1,
    hours: float = 1.0,
    triads: int = 40,
    calibration: str = MEAN,
    trajectory: Path | str | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> StudyResult:
    """Run the small study that says which bench test predicts the position error.

    Args:
        out: output folder; new, empty, or of the same validation, which is continued.
        seed: seed of all random numbers.
        hours: duration of the missions; the paper's gyro always flies for an hour.
        triads: number of triads that are judged, beside the preset's training triads.
        calibration: what the maker calibrates: "mean" or "map".
        trajectory: the mission beside the car: a ready one, a mission file (TOML) or a recorded
            drive (CSV); the preset's if None.
        workers, scheduler, progress: as in `run_study`.

    Raises:
        HrgError: an argument is out of range; a file that can't be used; or as `run_study`.
        OSError: `out` can't be written.
    """
    study = plan_validation(
        seed=seed, hours=hours, triads=triads, calibration=calibration, trajectory=trajectory
    )
    study_experiment = make_experiment(study)

    def conclude(study: Study, arrays: Arrays, folder: Path) -> None:
        study_experiment.conclude(study, arrays, folder)
        write_files(read_study_data(folder), folder)

    experiment = replace(
        study_experiment, conclude=conclude, files=(*FILES, *study_experiment.files)
    )
    return run_to_result(study, Path(out), experiment, Cluster(scheduler, workers), progress)


def plan_validation(
    *,
    seed: int = 1,
    hours: float = 1.0,
    triads: int = 40,
    calibration: str = MEAN,
    trajectory: Path | str | None = None,
) -> Study:
    """The study of a validation; arguments as `validate`.

    Raises:
        HrgError: an argument is out of range, or the trajectory can't be used.
    """
    preset = load_study(PRESET)
    if calibration not in CALIBRATIONS:
        expected = " or ".join(CALIBRATIONS)
        raise HrgError(f"calibration: found {calibration!r}, expected {expected}")
    fewest = compute_fewest_judged(preset.interval_percent)
    check_whole_number("triads", triads, fewest, LARGEST_TRIADS)
    check_number("hours", hours, 0.1, LONGEST_HOURS)
    study = replace(
        preset,
        seed=check_seed(seed),
        hours=hours,
        triads=preset.training + triads,
        calibrations=(calibration,),
        conditions=preset.conditions if calibration == MEAN else 0,
        missions=tuple(replace(mission, hours=hours) for mission in preset.missions),
    )
    return study if trajectory is None else _fly_trajectory(study, trajectory)


def _fly_trajectory(study: Study, trajectory: Path | str) -> Study:
    """The study with this mission beside its first one; alone if it is that one.

    Raises:
        HrgError: the trajectory can't be used, or does not start at rest.
    """
    plan_mission(trajectory, study.hours).trajectory()
    path = find_mission_file(trajectory)
    name = path.name.split(".")[0]
    classes = {mission.name: mission.mission_class for mission in study.missions}
    chosen = PlannedMission(
        name=name,
        mission_class=classes.get(name, name),
        hours=study.hours,
        file_name=path.name,
        content=read_bytes(path, LOG_BYTES),
    )
    first = study.missions[0]
    return replace(study, missions=(chosen,) if name == first.name else (first, chosen))
