"""Studies as TOML: what is read, and what is refused with file, key, found and expected."""

import re
from pathlib import Path

import pytest

from ins_eval.study import study_file
from ins_eval.study.run.block import identify_study
from ins_eval.study.specification import TEST, TRAIN, compute_fewest_judged
from ins_eval.trajectories import catalogue
from pyhrg.common.errors import HrgError
from tests.ins_eval.study import cases


def test_study_is_read(tmp_path: Path) -> None:
    study = study_file.read_study(cases.study_file(tmp_path))
    assert (study.seed, study.triads, study.interval_percent) == (3, 75, 90.0)
    assert [(m.name, m.hours) for m in study.missions] == [("car", 1.0), ("ship", 1.0)]
    assert study.missions[0].content == (catalogue.READY_FOLDER / "car.toml").read_bytes()
    assert [study.role_of(triad) for triad in (0, 36, 37, 74)] == [TRAIN, TRAIN, TEST, TEST]


def test_calibrations_may_be_chosen(tmp_path: Path) -> None:
    assert study_file.read_study(cases.study_file(tmp_path)).calibrations == ("mean", "map")
    chosen = cases.study_file(tmp_path, ("hours = 1", 'hours = 1\ncalibrations = ["map"]'))
    assert study_file.read_study(chosen).calibrations == ("map",)


def test_seed_may_be_given_beside_the_file(tmp_path: Path) -> None:
    path = cases.study_file(tmp_path, ("seed = 3\n", ""))
    assert study_file.read_study(path, seed=8).seed == 8


def test_mission_from_a_file_is_placed_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "drive.csv.gz").write_bytes(b"recorded")
    path = cases.study_file(tmp_path, ('name = "car"', 'file = "drive.csv.gz", hours = 0.5'))
    mission = study_file.read_study(path).missions[0]
    assert (mission.name, mission.hours) == ("drive", 0.5)
    with mission.as_file() as placed:
        assert placed.name == "drive.csv.gz"
        assert placed.read_bytes() == b"recorded"
    assert not placed.exists()


def test_recorded_drive_is_flown_where_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else it is left out, which makes another study of it."""
    monkeypatch.setenv("HRG_REAL", str(tmp_path))
    drive = '{ recorded = "drive.csv.gz", class = "drive" },\n]'
    path = cases.study_file(tmp_path, ("]\n", f"  {drive}\n"))
    less = study_file.read_study(path)
    assert (len(less.missions), less.left_out) == (2, ("drive.csv.gz",))
    (tmp_path / "drive.csv.gz").write_bytes(b"recorded")
    whole = study_file.read_study(path)
    assert (len(whole.missions), whole.left_out) == (3, ())
    assert (whole.missions[2].name, whole.missions[2].content) == ("drive", b"recorded")
    assert identify_study(less) != identify_study(whole)


@pytest.mark.parametrize("name", study_file.READY)
def test_ready_study_can_be_flown(name: str) -> None:
    for mission in study_file.load_study(name).missions:
        with mission.as_file() as path:
            assert catalogue.load_trajectory(path, 60.0, 300.0)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("seed = 3\n", "", "seed: found no such key, expected a whole number from 0 to"),
        ("seed = 3", "seed = -1", "seed: found -1, expected a whole number"),
        ("seed = 3", "seed = 3.5", "seed: found 3.5, expected a whole number"),
        ("seed = 3", "sed = 3", "sed: found an unknown key, expected seed"),
        ("triads = 75\n", "", "triads: found no such key"),
        ("triads = 75", 'triads = "many"', "triads: found 'many', expected a whole number"),
        ("triads = 75", "triads = 72", "triads: found 72, expected 73 or more with training 37"),
        ("training = 37\n", "", "training: found no such key"),
        ("hours = 1", "hours = 11", "hours: found 11, expected 0.1 to 10"),
        ("hours = 1", "hours = nan", "hours: found nan, expected 0.1 to 10"),
        ("hours = 1", "interval_percent = 99", "triads: found 75, expected 405 or more"),
        ("hours = 1", "[population]", "population: found an unknown key"),
        ('"car", class', '"cart", class', "missions 1: name: found 'cart', expected aircraft or"),
        (', class = "car"', "", "missions 1: class: found no such key, expected the class"),
        (
            'class = "ship"',
            'class = "ship", half = "test"',
            "missions 2: half: found 'test', expected no such key: all classes are judged",
        ),
        ('name = "ship"', 'name = "car"', "missions 2: name: found 'car', expected a name that"),
        ('name = "ship"', 'file = "no.toml"', "no.toml', expected a file: "),
        ('name = "ship", ', "", "missions 2: name: found no such key, expected aircraft"),
        ('class = "ship"', 'class = "ship", hour = 2', "missions 2: hour: found an unknown key"),
        ('class = "ship"', 'class = "ship", hours = 0', "missions 2: hours: found 0, expected 0.1"),
        ("missions = [", "missions = 3\nx = [", "x: found an unknown key"),
        ("hours = 1", "hours 1", "found what is no TOML"),
        ("hours = 1", "conditions = 1", "conditions: found 1, expected 0, or 2 to 38, the triads"),
        (
            "hours = 1",
            "conditions = 39",
            "conditions: found 39, expected 0, or 2 to 38, the triads",
        ),
        ("hours = 1", "agreement = 39", "agreement: found 39, expected 0, or 2 to 38, the triads"),
        ("hours = 1", "lead = 76", "lead: found 76, expected 0 to 75, the number of triads"),
        (
            "hours = 1",
            'conditions = 38\ncalibrations = ["map"]',
            "conditions: found 38, expected 0 without 'mean' among the calibrations",
        ),
        ("hours = 1", 'calibrations = "mean"', "calibrations: found 'mean', expected some of mean"),
        ("hours = 1", 'calibrations = ["best"]', "calibrations: found ['best'], expected some of"),
        ("hours = 1", "calibrations = []", "calibrations: found [], expected some of mean, map"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, old: str, new: str, message: str) -> None:
    path = cases.study_file(tmp_path, (old, new))
    with pytest.raises(HrgError, match=f"^{re.escape(str(path))}: .*") as raised:
        study_file.read_study(path)
    assert message in str(raised.value)


@pytest.mark.parametrize("missions", ["", "missions = []", "missions = 3", "missions = [3]"])
def test_study_without_missions_is_refused(tmp_path: Path, missions: str) -> None:
    path = tmp_path / "study.toml"
    path.write_text(f"seed = 1\ntriads = 80\ntraining = 40\n{missions}\n")
    with pytest.raises(HrgError, match=r"missions: found .*, expected tables"):
        study_file.read_study(path)


def test_neither_name_nor_file_is_refused() -> None:
    with pytest.raises(
        HrgError, match=r"huge: found no such file .* expected a file or narrow, one"
    ):
        study_file.load_study("huge")


@pytest.mark.parametrize(("percent", "triads"), [(50.0, 6), (90.0, 36), (99.0, 368)])
def test_fewest_triads_let_full_coverage_be_refuted(percent: float, triads: int) -> None:
    """All of them covered is rarer than 2.5 % where the interval is what it says."""
    assert compute_fewest_judged(percent) == triads
    share = percent / 100
    assert share**triads < 0.025 <= share ** (triads - 1)
