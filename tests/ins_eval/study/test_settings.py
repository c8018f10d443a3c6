"""Tables of a study file: every field of the dataclasses that they fill, in SI; what is refused."""

from dataclasses import fields
from pathlib import Path

import pytest

from ins_eval.study import study_file
from ins_eval.study.experiment import DEFAULT_SETTINGS, make_distribution
from ins_eval.study.study_file import SETTING_TABLES
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H, HOUR, MICRO_G
from tests.ins_eval.study import cases


def with_table(folder: Path, text: str) -> Path:
    path = cases.study_file(folder)
    path.write_text(f"{path.read_text()}\n{text}\n")
    return path


def test_keys_are_those_of_the_dataclasses() -> None:
    named = {name: [key.field for key in keys] for name, keys in SETTING_TABLES.items()}
    assert named == {name: [f.name for f in fields(own)] for name, own in DEFAULT_SETTINGS.items()}


def test_defaults_are_within_the_ranges_of_their_keys() -> None:
    for name, own in DEFAULT_SETTINGS.items():
        for key in SETTING_TABLES[name]:
            value = getattr(own, key.field)
            assert key.low <= key.from_si(value) <= key.high
            assert isinstance(value, int) == key.whole


def test_tables_reach_what_triads_are_drawn_from(tmp_path: Path) -> None:
    path = with_table(
        tmp_path,
        "[raw]\nsmallest_deg_h = 1\nlargest_deg_h = 2\n[bench]\nruns = 4\n[drift]\nage_days = 10",
    )
    study = study_file.read_study(path)
    drawn = make_distribution(study, "map")
    assert (drawn.population.smallest, drawn.population.largest) == (DEG_PER_H, 2 * DEG_PER_H)
    assert drawn.bench.runs == 4
    assert drawn.bench.positions == DEFAULT_SETTINGS["bench"].positions
    assert drawn.drift.age == 240 * HOUR
    assert drawn.accelerometer_bias == 10 * MICRO_G
    assert make_distribution(study, "mean").population == DEFAULT_SETTINGS["trimmed"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[drift]\nage = 3", "drift.age: found an unknown key, expected drift.age_days"),
        ("[drift]\nage_days = -1", "drift.age_days: found -1, expected 0 to 7300"),
        ("[bench]\nruns = 2.5", "bench.runs: found 2.5, expected a whole number"),
        ("[bench]\npositions = 4", "bench.positions: found 4, expected 16 to 720"),
        (
            "[raw]\nsmallest_deg_h = 1",
            "raw.largest_deg_h: found no such key, expected a number beside",
        ),
        (
            "[raw]\nsmallest_deg_h = 2\nlargest_deg_h = 1",
            "raw.largest_deg_h: found 1, expected smallest_deg_h or more",
        ),
        ("[[raw]]\nx = 1", "raw: found [{'x': 1}], expected a table"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(HrgError) as raised:
        study_file.read_study(with_table(tmp_path, text))
    assert message in str(raised.value)


def test_sample_is_spread_over_the_judged_triads() -> None:
    study = cases.study(triads=112)
    chosen = [triad for triad in range(study.triads) if study.is_in_sample(triad, 7)]
    assert chosen == [56, 64, 72, 80, 88, 96, 104]
    assert not any(study.is_in_sample(triad, 0) for triad in range(study.triads))
