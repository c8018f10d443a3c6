"""docs/literature.md: what is computed, and the words that are held to it."""

from pathlib import Path

import pytest

from tests.agreement.literature import document

ROOT = Path(__file__).parents[3]
Values = dict[str, float]


@pytest.fixture(scope="module")
def values() -> Values:
    return document.compute_figures()


def test_fourth_harmonics_go_by_reversal_and_by_force(values: Values) -> None:
    """595 and 1000 are published; what is left here is of second order, or the mean."""
    assert values["reversed_ratio"] > 50
    assert values["swept_ratio"] == pytest.approx(values["reversed_ratio"], rel=0.05)
    assert values["pumped_ratio"] > 10 * values["swept_ratio"]
    assert values["cancelled_ratio"] > 1000


def test_gain_asymmetry_is_its_deviation(values: Values) -> None:
    """A quarter of g; the scale factor loses a quarter of its square."""
    assert values["deviation_before_deg"] == pytest.approx(0.6, rel=0.01)
    assert values["deviation_after_deg"] < 0.05
    expected = values["scale_factor_expected_ppm"]
    assert values["scale_factor_slow_ppm"] == pytest.approx(expected, rel=0.01)
    assert values["nonlinearity_ppm"] < 0.1 * 646.57


def test_channels_tell_more_than_the_frequency(values: Values) -> None:
    assert values["channels_ratio"] > 2 * values["frequency_ratio"] > 2


def test_earth_is_seen_by_virtual_rotation_alone(values: Values) -> None:
    assert abs(values["earth_locked"]) < 1e-3
    assert values["earth_rotated"] == pytest.approx(1, abs=0.01)


def test_trimmed_harmonics_multiply(values: Values) -> None:
    """(1 - 0.928)(1 - 0.755) by the sway, (1 - 0.893)^2 by the heave."""
    assert 1 / values["trimmed_lateralLoss"] == pytest.approx(0.072 * 0.245, rel=1e-3)
    assert 1 / values["trimmed_axialLoss"] == pytest.approx(0.107**2, rel=1e-3)


def test_eccentricity_hardly_biases_opposed_electrodes(values: Values) -> None:
    assert values["gap_eccentricity_deg_h"] < 1e-3 * values["gap_fourthHarmonic_deg_h"]


def test_document_is_what_the_code_computes(values: Values) -> None:
    """Else run `python -m tests.agreement.literature > docs/literature.md`."""
    page = (ROOT / "docs" / "literature.md").read_text(encoding="utf-8")
    assert page == document.fill_document(values)
