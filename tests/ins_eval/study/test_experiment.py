"""A small study from gyros to report: what blocks hold, what the table and study.json say."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from numpy.typing import NDArray

from ins_eval.study import conclusion, lead
from ins_eval.study.conclusion import list_files, write_conclusion
from ins_eval.study.experiment import (
    NOISELESS,
    STEADY_LOOPS,
    WITNESS,
    compute_block,
    prepare,
    select_errors,
)
from ins_eval.study.gyros.makers_calibration import METHODS
from ins_eval.study.run import block
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import TEST, TRAIN, PlannedMission, Study
from ins_eval.study.study_data import read_study_data
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import AGREEMENT, RANGE, STEADY_AGREEMENT
from ins_eval.study.witness import block as block_of_channels
from ins_eval.trajectories import catalogue
from pyhrg.common.errors import HrgError

PLAN = {
    "runs": 2,
    "fixed_runs": 2,
    "positions": 16,
    "segments": 1,
    "fixed_segments": 2,
    "periods": 1,
}


def planned(name: str) -> PlannedMission:
    path = catalogue.READY_FOLDER / f"{name}.toml"
    return PlannedMission(
        name=name,
        mission_class=name,
        hours=0.2,
        file_name=path.name,
        content=path.read_bytes(),
    )


STUDY = Study(
    seed=5,
    triads=24,
    training=2,
    missions=(planned("car"), planned("static-table")),
    settings={"bench": PLAN, "calibration": {**PLAN, "runs": 1}},
)


@pytest.fixture(scope="module")
def three() -> Arrays:
    return block.join_blocks([compute_block(STUDY, range(0, 2)), compute_block(STUDY, range(2, 3))])


@pytest.fixture(scope="module")
def arrays(three: Arrays) -> Arrays:
    """Those three, and more that are as them in all but size: the bench takes its time."""
    sizes = np.random.default_rng(1).uniform(0.5, 2.0, STUDY.triads)

    def sized(values: NDArray[Any]) -> NDArray[Any]:
        many = np.concatenate([values] * (STUDY.triads // 3))
        if many.dtype.kind != "f":
            return many
        return np.asarray(many * sizes.reshape(-1, *[1] * (many.ndim - 1)))

    return {name: sized(values) for name, values in three.items()}


@pytest.fixture(scope="module")
def folder(arrays: Arrays, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("study")
    write_conclusion(STUDY, arrays, path)
    return path


@pytest.fixture(scope="module")
def table(folder: Path) -> pd.DataFrame:
    return pd.read_parquet(folder / c.TABLE)


def test_triads_are_the_same_in_any_block(three: Arrays) -> None:
    """But for the last bits of products of matrices, whose shape is the block's."""
    alone = compute_block(STUDY, range(1, 2))
    assert alone.keys() == three.keys()
    for name, values in alone.items():
        np.testing.assert_allclose(three[name][1:2], values, rtol=1e-9, err_msg=name)


def test_the_lead_case_flies_beside_the_triads_of_its_numbers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Cut short; the bench's figures are with the first."""
    monkeypatch.setattr(lead, "HOURS", 0.1)
    study = replace(STUDY, lead=1, calibrations=("mean",), missions=STUDY.missions[:1])
    first, second = (compute_block(study, range(number, number + 1)) for number in range(2))
    assert first["lead/flown"].shape[0] == first["lead/bench"].shape[0] == 1
    assert np.isfinite(first["lead/flown"]).all()
    assert not any(name.startswith("lead/") for name in second)


def test_one_row_a_triad_calibration_and_mission(table: pd.DataFrame) -> None:
    keys = table[[c.TRIAD, c.CALIBRATION, c.MISSION]]
    assert len(table) == len(keys.drop_duplicates()) == STUDY.triads * len(METHODS) * 2
    assert np.isfinite(table.select_dtypes("number")).all(axis=None)


def test_parts_add_up(table: pd.DataFrame) -> None:
    for axis, flown in (("north", c.FLOWN_NORTH), ("east", c.FLOWN_EAST)):
        total = sum(table[c.name_part(name, axis)] for name in c.PARTS)
        linear = table[c.FLOWN_BY] == c.LINEAR
        np.testing.assert_allclose(total[linear], table[flown][linear], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(
        np.hypot(table[c.FLOWN_NORTH], table[c.FLOWN_EAST]), table[c.FLOWN_RADIAL]
    )


def test_judged_triads_are_co_simulated_in_every_class(table: pd.DataFrame) -> None:
    """Of each three triads two are training triads: the others are as the third."""
    for name in ("car", "static-table"):
        rows = table[(table[c.CALIBRATION] == "map") & (table[c.MISSION] == name)]
        assert rows[c.ROLE].tolist() == [TRAIN] * 2 + [TEST] * 22
        assert rows[c.FLOWN_BY].tolist() == [c.LINEAR, c.LINEAR, c.COSIMULATED] * 8
        same = np.isclose(rows[c.FLOWN_RADIAL], rows[c.LINEAR_RADIAL], rtol=1e-9)
        assert same.tolist() == (rows[c.FLOWN_BY] == c.LINEAR).tolist()


def test_growth_ends_every_ten_minutes(table: pd.DataFrame) -> None:
    """Of 12 minutes, one."""
    assert table[c.HOURS].unique() == pytest.approx([0.2])
    assert {len(values) for values in table[c.GROWTH]} == {1}


def test_only_judged_triads_are_scored(folder: Path) -> None:
    """Constants of classes are of the training triads."""
    document = json.loads((folder / "study.json").read_text())
    roles = {(score["role"], score["score"] == "class_constant") for score in document["scores"]}
    assert roles == {(TEST, False), (TRAIN, True)}
    assert (document["seed"], document["triads"], document["training"]) == (5, 24, 2)
    assert read_study_data(folder).scores


def test_phase_diagram_names_the_missions(folder: Path) -> None:
    document = json.loads((folder / "study.json").read_text())["phase_diagram"]
    assert set(document["missions"]) == {"car", "static-table"}
    assert len(document["rows"]) == len(pd.read_csv(folder / "phase_diagram.csv"))


def test_witnessed_flights_have_rows_and_scores(arrays: Arrays, tmp_path: Path) -> None:
    """Made-up channels of two triads, with both kinds of start."""
    random, numbers, tests = np.random.default_rng(4), [5, 17], len(block_of_channels.TESTS)
    study = replace(STUDY, witnessed=2, calibrations=("map",), missions=STUDY.missions[:1])
    made = dict(arrays)
    for name, shape in block_of_channels.SHAPES.items():
        values = np.full((STUDY.triads, tests, *shape), np.nan)
        drawn = random.uniform(1.0, 2.0, values[numbers].shape)
        values[numbers] = drawn if len(shape) == 1 else drawn * np.eye(2)
        made[f"map/0/{WITNESS}/{name}"] = values
    write_conclusion(study, made, tmp_path)
    rows = pd.read_csv(tmp_path / "witness.csv")
    assert len(rows) == 2 * tests
    assert set(rows["triad"]) == set(numbers)
    scores = json.loads((tmp_path / "study.json").read_text())["witness"]
    assert {each["mission_class"] for each in scores} == {"all", "car"}
    assert "What the gyros tell of themselves" in (tmp_path / "report.html").read_text()


def test_same_arrays_give_the_same_bytes(arrays: Arrays, folder: Path, tmp_path: Path) -> None:
    write_conclusion(STUDY, arrays, tmp_path)
    assert {each.name for each in tmp_path.iterdir()} == set(list_files(STUDY))
    for name in list_files(STUDY):
        assert (tmp_path / name).read_bytes() == (folder / name).read_bytes()


@pytest.mark.parametrize(
    ("sample", "flights", "key", "count", "verdict", "confidence"),
    [
        ("agreement", NOISELESS, AGREEMENT, 6, "", RANGE),
        ("steady_agreement", STEADY_LOOPS, STEADY_AGREEMENT, 11, "holds", 0.95),
    ],
)
def test_agreement_is_of_the_sample_without_noise(
    arrays: Arrays,
    sample: str,
    flights: str,
    key: str,
    count: int,
    verdict: str,
    confidence: float,
) -> None:
    """Co-simulated errors that are 1 % larger than linear ones: 1/101 apart. Six triads decide
    nothing."""
    study = replace(STUDY, **{sample: count})
    chosen = [study.is_in_sample(triad, count) for triad in range(study.triads)]
    flown = dict(arrays)
    for method in METHODS:
        for number in range(len(study.missions)):
            error = select_errors(arrays, method, number)
            sample = np.where(np.array(chosen)[:, None, None], 1.01, np.nan)
            flown[f"{method}/{number}/{flights}"] = sample * (error.error - error.noise)
    found = conclusion.score_agreement(study, flown)
    assert {(s.calibration, s.mission_class) for s in found} == {
        (method, name) for method in METHODS for name in ("all", "car", "static-table")
    }
    for s in found:
        assert (s.value, s.low, s.high) == pytest.approx((1 / 101,) * 3)
        assert (s.score, s.n, s.verdict, s.confidence) == (key, count, verdict, confidence)
    assert conclusion.score_agreement(STUDY, arrays) == []


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"bench": {"runs": 1}}, "bench: found 1 power-on of each test, expected 2 or more"),
        ({"drift": {"coolest": -5.0, "warmest": 5.0}}, "-5 to 5 K of warming, expected 0 or more"),
    ],
)
def test_settings_that_do_not_fit_are_refused_before_the_work(
    settings: dict[str, Any], message: str
) -> None:
    with pytest.raises(HrgError, match=message):
        prepare(replace(STUDY, settings=settings))
