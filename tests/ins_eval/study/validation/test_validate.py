"""The preset of a validation, and what its arguments replace."""

import inspect
from pathlib import Path

import pytest

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
    assert (study.hours, study.judged, study.seed, study.conditions) == (0.5, 100, 9, 24)
    assert {mission.hours for mission in study.missions} == {0.5}
    assert plan_validation(triads=36).triads == 60
    mapped = plan_validation(calibration="map")
    assert (mapped.calibrations, mapped.conditions) == (("map",), 0)


@pytest.mark.parametrize(
    ("name", "missions"),
    [
        ("aircraft", {"car": "car", "aircraft": "aircraft with rolls"}),
        ("car", {"car": "car"}),
        ("ship", {"car": "car", "ship": "ship"}),
    ],
)
def test_trajectory_is_flown_beside_the_car(name: str, missions: dict[str, str]) -> None:
    planned = plan_validation(trajectory=name).missions
    assert {mission.name: mission.mission_class for mission in planned} == missions


def test_recorded_drive_is_flown(tmp_path: Path) -> None:
    drive = write_drive(tmp_path, make_drive())
    flown = plan_validation(trajectory=drive, hours=0.1).missions[-1]
    assert (flown.name, flown.mission_class) == ("drive", "drive")
    assert flown.content == drive.read_bytes()


def test_unknown_calibration_is_refused() -> None:
    with pytest.raises(HrgError, match="calibration: found 'best', expected mean or map"):
        plan_validation(calibration="best")
