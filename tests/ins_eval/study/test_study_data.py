"""A results folder read, and what is said of one that is none."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ins_eval.study.study_data import check_study_data, read_study_data
from ins_eval.study.tables import columns as c
from pyhrg.common.errors import HrgError
from tests.ins_eval.study.report.synthetic import synthetic


def test_a_folder_gives_back_what_was_written(tmp_path: Path) -> None:
    made = synthetic(8)
    made.table.to_parquet(tmp_path / "study.parquet")
    scores = [
        {k: None if isinstance(v, float) and np.isnan(v) else v for k, v in asdict(s).items()}
        for s in made.scores
    ]
    document = {**made.about, "scores": scores}
    (tmp_path / "study.json").write_text(json.dumps(document))
    found = read_study_data(tmp_path)
    assert found.scores == made.scores
    assert found.about == made.about
    np.testing.assert_array_equal(found.table[c.FLOWN_RADIAL], made.table[c.FLOWN_RADIAL])


def test_a_folder_without_results_is_named(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"found no study\.parquet, expected .*hrg validate"):
        read_study_data(tmp_path)


def test_a_missing_column_is_named() -> None:
    made = synthetic(4)
    table = made.table.drop(columns=[c.FLOWN_EAST])
    with pytest.raises(HrgError, match="found no column flown_east_m, expected it"):
        check_study_data(table, {"scores": []})


def test_a_column_of_another_kind_is_named() -> None:
    made = synthetic(4)
    table = made.table.assign(**{c.HOURS: "two"})
    with pytest.raises(HrgError, match=r"column hours: found .*, expected number"):
        check_study_data(table, {"scores": []})


def test_no_rows_are_refused() -> None:
    with pytest.raises(HrgError, match="found no rows"):
        check_study_data(synthetic(4).table.iloc[:0], {"scores": []})


@pytest.mark.parametrize(
    ("document", "message"),
    [
        ({}, "scores: found nothing, expected a list"),
        ({"scores": {}}, "scores: found dict, expected a list"),
        ({"scores": [{"colour": 1}]}, r"scores\[0\]: found colour, expected only"),
        ({"scores": [{"score": "spearman"}]}, r"scores\[0\]: .*missing"),
        ({"scores": ["spearman"]}, r"scores\[0\]: found 'spearman', expected an object"),
    ],
)
def test_scores_that_are_none_are_named(document: Any, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        check_study_data(synthetic(4).table, document)


@pytest.mark.parametrize("level", [None, "90", 0, 100])
def test_level_of_intervals_that_is_none_is_named(level: Any) -> None:
    document = {"scores": []} if level is None else {"scores": [], "interval_percent": level}
    message = f"study.json: interval_percent: found {level!r}, expected a number between 0 and 100"
    with pytest.raises(HrgError, match=f"^{message}$"):
        check_study_data(synthetic(4).table, document)


def test_an_unknown_score_is_named() -> None:
    made = synthetic(4)
    entry = asdict(made.scores[0]) | {"score": "beauty"}
    with pytest.raises(HrgError, match=r"scores\[0\]: found score beauty, expected one of r2"):
        check_study_data(made.table, {"scores": [entry]})


def test_an_unknown_predictor_is_named() -> None:
    made = synthetic(4)
    entry = asdict(made.scores[0]) | {"predictor": "tea_leaves"}
    with pytest.raises(HrgError, match=r"scores\[0\]: found predictor tea_leaves, expected"):
        check_study_data(made.table, {"scores": [entry]})


@pytest.mark.parametrize(
    ("field", "value"),
    [("value", "1.5"), ("value", 10**400), ("n", None), ("seed", "1"), ("shuffled", 1)],
)
def test_a_field_of_another_type_is_named(field: str, value: object) -> None:
    made = synthetic(4)
    entry = asdict(made.scores[0]) | {field: value}
    with pytest.raises(HrgError, match=rf"scores\[0\]: (found what is no score|{field}:)"):
        check_study_data(made.table, {"scores": [entry]})
