"""Bench figures, a mission and a finished study give an error with its interval."""

import argparse
import json
from pathlib import Path

import pytest

from ins_eval.cli import predict
from ins_eval.study.summary.predict_error import predict_error
from pyhrg.common.errors import HrgError
from tests.ins_eval.study.report.synthetic import synthetic


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path: Path = tmp_path_factory.mktemp("study")
    made = synthetic(8)
    made.table.to_parquet(path / "study.parquet")
    scores = [score.describe() for score in made.scores]
    (path / "study.json").write_text(json.dumps({**made.about, "scores": scores}))
    return path


def test_error_is_the_rule_times_the_constant_of_the_class(folder: Path) -> None:
    """0.01 deg/h in 2 h is 2 nmi by the rule; the made-up constants are 20 and 1.18, the ends of
    intervals a factor of 8 away."""
    fixed, circumference = predict_error(folder, "ship", fixed_deg_h=0.01, circumference_deg_h=0.02)
    assert (fixed.rule, circumference.rule) == pytest.approx((2 * 1852, 4 * 1852))
    assert (fixed.median, circumference.median) == pytest.approx((40 * 1852, 4.72 * 1852))
    assert (circumference.low, circumference.high) == pytest.approx((0.59 * 1852, 37.76 * 1852))
    assert str(circumference).startswith(
        "full circumference, 0.02 deg/h: 4.7 nmi (8.7 km) after 2 h"
    )


def test_figures_beyond_the_study_are_said_to_be(folder: Path) -> None:
    within, beyond = (
        predict_error(folder, "ship", circumference_deg_h=value)[0] for value in (0.1, 10.0)
    )
    assert within.smallest < 0.1 < within.largest < 10
    assert "beyond" not in str(within)
    assert "beyond the study's triads, which have 0.0" in str(beyond)


def test_command_prints_a_line_for_each_figure(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    parser = argparse.ArgumentParser()
    predict.add_options(parser)
    predict.run(parser.parse_args(["ship", "--fixed", "0.001", "--study", str(folder)]))
    (line,) = capsys.readouterr().out.splitlines()
    assert line.startswith("fixed position, 0.001 deg/h: ")


def test_a_program_reads_the_same_figures(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    parser = argparse.ArgumentParser()
    predict.add_options(parser)
    given = ["ship", "--circumference", "0.02", "--json", "--study", str(folder)]
    predict.run(parser.parse_args(given))
    (read,) = json.loads(capsys.readouterr().out)
    (error,) = predict_error(folder, "ship", circumference_deg_h=0.02)
    assert (read["stability_deg_h"], read["median_m"]) == (error.stability, error.median)
    assert (read["test"], read["hours"]) == ("full circumference", 2)
    assert len(read) == 12


@pytest.mark.parametrize(
    ("mission", "figures", "message"),
    [
        ("ship", {}, "found no bench figure, expected fixed_deg_h or circumference_deg_h"),
        ("ship", {"fixed_deg_h": 0.0}, "fixed_deg_h: found 0, expected a number"),
        ("boat", {"fixed_deg_h": 0.1}, "mission: found no 'boat', mean calibrated, in the study"),
    ],
)
def test_what_is_wrong_is_named(
    folder: Path, mission: str, figures: dict[str, float], message: str
) -> None:
    with pytest.raises(HrgError, match=message):
        predict_error(folder, mission, **figures)
