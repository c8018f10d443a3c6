"""Missions of the study, and weights of them on disk."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.mission_model import weights_cache
from ins_eval.mission_model.missions import STILL, StudyMission, plan_mission
from ins_eval.mission_model.weights_cache import compute_weights_digest, load_mission_weights
from ins_eval.trajectories.errors import TrajectoryError
from tests.recordings import find_recording

READY_MISSIONS = ("car", "aircraft", "airliner", "ship", "missile", "long-haul", "static-table")
"""Ready missions that start at rest."""


@pytest.mark.parametrize("name", READY_MISSIONS)
def test_all_begin_at_rest(name: str) -> None:
    mission = plan_mission(name, 0.1)
    path = mission.trajectory()
    assert path.start == -STILL
    assert np.abs(path.velocity(np.array([-STILL, -1.0]))).max() < 1e-9


def test_recorded_drive_repeats_to_length() -> None:
    mission = plan_mission(find_recording("turin_drive.csv.gz"), 2.0)
    assert mission.name == "turin_drive"
    assert mission.trajectory().end >= 7200


def test_missile_flies_for_minutes() -> None:
    mission = plan_mission("missile", 2.0)
    assert 0.1 < mission.hours < 0.5
    assert mission.interval == 60


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
        plan_mission(name, hours).trajectory()


def test_weights_are_made_once(
    short: StudyMission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = load_mission_weights(short, tmp_path)
    assert len(list(tmp_path.iterdir())) == 1

    def never(mission: StudyMission) -> None:
        raise AssertionError(mission.name)

    monkeypatch.setattr(weights_cache, "compute_mission_weights", never)
    again = load_mission_weights(short, tmp_path)
    assert np.array_equal(again.noise, made.noise)
    assert np.array_equal(again.alignment.attitude, made.alignment.attitude)
    assert again.alignment.height == made.alignment.height


def test_other_missions_have_other_weights(short: StudyMission) -> None:
    assert compute_weights_digest(short) == compute_weights_digest(plan_mission("car", 0.1))
    others = [plan_mission("car", 0.2), plan_mission("ship", 0.1)]
    assert len({compute_weights_digest(mission) for mission in (short, *others)}) == 3


def test_failed_write_leaves_nothing(
    short: StudyMission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*args: object, **kwargs: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez", full)
    with pytest.raises(OSError, match="No space left"):
        load_mission_weights(short, tmp_path)
    assert list(tmp_path.iterdir()) == []
