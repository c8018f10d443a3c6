"""The preset of a validation, and what its arguments replace."""

import inspect
from pathlib import Path

import pytest

from ins_eval.study.specification import TEST, TRAIN
from ins_eval.study.study_file import load_study
from ins_eval.study.validation.validate import plan_validation, validate
from pyhrg.common.errors import HrgError
from tests.ins_eval.trajectories.test_recorded_drive import make_drive, write_drive


def test_defaults_are_those_of_the_small_study() -> None:
    assert plan_validation() == load_study("small")
    defaults = {
        name: parameter.default
        for name, parameter in inspect.signature(validate).parameters.items()
    }
    study = plan_validation(
        **{name: defaults[name] for name in inspect.signature(plan_validation).parameters}
    )
    assert study == load_study("small")


def test_arguments_replace_keys() -> None:
    study = plan_validation(hours=0.5, triads=100, seed=9)
    assert (study.hours, study.triads, study.seed, study.conditions) == (0.5, 100, 9, 40)
    assert {mission.hours for mission in study.missions} == {0.5}
    assert plan_validation(triads=72).conditions == 36
    mapped = plan_validation(calibration="map")
    assert (mapped.calibrations, mapped.conditions) == (("map",), 0)


@pytest.mark.parametrize(
    ("name", "training", "judged_class"),
    [
        ("aircraft", "car", "aircraft with rolls"),
        ("car", "aircraft", "car"),
        ("ship", "car", "ship"),
    ],
)
def test_trajectory_is_the_test_mission(name: str, training: str, judged_class: str) -> None:
    first, second = plan_validation(trajectory=name).missions
    assert (first.name, first.half) == (training, TRAIN)
    assert (second.name, second.half, second.mission_class) == (name, TEST, judged_class)
    assert first.mission_class != second.mission_class


def test_recorded_drive_is_the_test_mission(tmp_path: Path) -> None:
    drive = write_drive(tmp_path, make_drive())
    judged = plan_validation(trajectory=drive, hours=0.1).missions[-1]
    assert (judged.name, judged.half) == ("drive", TEST)
    assert judged.content == drive.read_bytes()


def test_unknown_calibration_is_refused() -> None:
    with pytest.raises(HrgError, match="calibration: found 'best', expected mean or map"):
        plan_validation(calibration="best")
