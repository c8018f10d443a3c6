"""The study that `hrg validate` runs: the small one, with options in place of some of its keys."""

from dataclasses import replace

from ins_eval.mission_model.missions import file_of, study_mission
from ins_eval.study import study_file
from ins_eval.study.specification import MEAN, TEST, TRAIN, PlannedMission, Study

NAME = "small"


def default() -> Study:
    """As it is."""
    return study_file.study(NAME)


def with_hours(study: Study, hours: float) -> Study:
    """All of its missions as long."""
    missions = tuple(replace(mission, hours=hours) for mission in study.missions)
    return replace(study, hours=hours, missions=missions)


def with_triads(study: Study, triads: int) -> Study:
    """As many, and in conditions as before, if there are as many to judge."""
    judged = triads - triads // 2
    return replace(study, triads=triads, conditions=min(study.conditions, judged))


def judged_in(study: Study, name_or_path: str) -> Study:
    """Predictors made on the study's first mission that is another, and judged in this one.

    Args:
        study: whose missions are replaced.
        name_or_path: of a ready mission, or of a file: a mission (TOML) or a recorded drive (CSV).

    Raises:
        TrajectoryError: neither; or it does not stand still before it starts.
    """
    study_mission(name_or_path, study.hours).trajectory()
    path = file_of(name_or_path)
    name = path.name.split(".")[0]
    known = {mission.name: mission.mission_class for mission in study.missions}
    judged = PlannedMission(
        name=name,
        mission_class=known.get(name, name),
        half=TEST,
        hours=study.hours,
        file_name=path.name,
        content=path.read_bytes(),
    )
    training = next(m for m in study.missions if m.name != name)
    return replace(study, missions=(replace(training, half=TRAIN), judged))


def calibrated(study: Study, calibration: str) -> Study:
    """By the maker, so alone; conditions are of gyros that are calibrated at the mean."""
    conditions = study.conditions if calibration == MEAN else 0
    return replace(study, calibrations=(calibration,), conditions=conditions)
