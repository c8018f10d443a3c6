"""Missions of the study, and weights of them on disk."""

import os
from pathlib import Path

import numpy as np
import pytest

from ins_eval.mission_model import weights_cache
from ins_eval.mission_model.missions import CLASSES, STILL, StudyMission, study_mission
from ins_eval.mission_model.weights_cache import digest, kept_weights
from ins_eval.trajectories.errors import TrajectoryError

RECORDED = Path(os.environ.get("HRG_REAL", Path(__file__).parents[4] / "shared/real"))


@pytest.mark.parametrize("name", CLASSES)
def test_all_begin_at_rest(name: str) -> None:
    mission = study_mission(name, 0.1)
    path = mission.trajectory()
    assert path.start == -STILL
    assert np.abs(path.velocity(np.array([-STILL, -1.0]))).max() < 1e-9


def test_recorded_drive_repeats_to_length() -> None:
    drive = RECORDED / "turin_drive.csv.gz"
    if not drive.exists():
        pytest.skip(f"{drive} is not there; HRG_REAL says where recorded data are")
    mission = study_mission(drive, 2.0)
    assert mission.name == "turin_drive"
    assert mission.trajectory().end >= 7200


def test_missile_flies_for_minutes() -> None:
    mission = study_mission("missile", 2.0)
    assert 0.1 < mission.hours < 0.5
    assert mission.kept == 60


@pytest.mark.parametrize(
    ("name", "hours", "message"),
    [
        ("car", 0.0, "found 0 hours, expected above 0 to 10"),
        ("car", 0.001, "lasts 3.6 s, expected 60 or more"),
        ("tram", 1.0, "tram"),
    ],
)
def test_wrong_missions_are_refused(name: str, hours: float, message: str) -> None:
    with pytest.raises((TrajectoryError, OSError), match=message):
        study_mission(name, hours).trajectory()


def test_weights_are_made_once(
    short: StudyMission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = kept_weights(short, tmp_path)
    assert len(list(tmp_path.iterdir())) == 1

    def never(mission: StudyMission) -> None:
        raise AssertionError(mission.name)

    monkeypatch.setattr(weights_cache, "mission_weights", never)
    again = kept_weights(short, tmp_path)
    assert np.array_equal(again.noise, made.noise)
    assert np.array_equal(again.standing.attitude, made.standing.attitude)
    assert again.standing.height == made.standing.height


def test_other_missions_have_other_weights(short: StudyMission) -> None:
    assert digest(short) == digest(study_mission("car", 0.1))
    others = [study_mission("car", 0.2), study_mission("ship", 0.1)]
    assert len({digest(mission) for mission in (short, *others)}) == 3


def test_failed_write_leaves_nothing(
    short: StudyMission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*args: object, **kwargs: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez", full)
    with pytest.raises(OSError, match="No space left"):
        kept_weights(short, tmp_path)
    assert list(tmp_path.iterdir()) == []
