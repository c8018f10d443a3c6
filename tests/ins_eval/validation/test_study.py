"""The experiment: reproducible, and with a negative control."""

from pathlib import Path

import pytest

from ins_eval.validation import report
from ins_eval.validation.mission import Mission
from ins_eval.validation.study import validate
from ins_eval.validation.verdict import verdict
from pyhrg.parameters import TYPICAL
from tests.ins_eval.cases import short_mission


@pytest.fixture(scope="module")
def flight() -> Mission:
    return short_mission(0.5)


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_same_seed_same_bytes_on_any_number_of_workers(fmu_path: Path, tmp_path: Path) -> None:
    flight = short_mission(0.1)
    for workers in (1, 3):
        (tmp_path / str(workers)).mkdir()
        report.write(validate(fmu_path, flight, 6, 4, workers=workers), tmp_path / str(workers))
    assert files(tmp_path / "1") == files(tmp_path / "3")
    assert set(files(tmp_path / "1")) == {
        "validation.json",
        "position_error.csv",
        "validation.png",
    }


def test_verdict_of_the_typical_gyro(fmu_path: Path, flight: Mission) -> None:
    """Ten triads, half an hour, seed 5: the old test is too good by ten and more, the paper's is
    not."""
    result = validate(fmu_path, flight, 10, 5)
    fixed, circumference = report.ratios(result)
    assert fixed.low > 10
    assert fixed.word == "too good"
    assert circumference.word in ("true", "consistent")
    assert verdict(fixed, circumference).startswith("The full-circumference test")


def test_without_anisotropy_both_tests_agree(fmu_path: Path, flight: Mission) -> None:
    """Negative control: same noise, every anisotropy zero; both promises are kept."""
    device = TYPICAL.without_anisotropy()
    result = validate(fmu_path, flight, 8, 5, device=device)
    stability = (result.fixed_position.stability, result.full_circumference.stability)
    assert max(stability) / min(stability) < 1.5
    ratios = report.ratios(result)
    assert verdict(*ratios).startswith("The two tests agree")
    assert all(0.5 < ratio.value < 2.0 for ratio in ratios)
