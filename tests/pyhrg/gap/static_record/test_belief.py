"""Beliefs as files: units, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.gap.static_record.belief import read_beliefs


def written(folder: Path, text: str) -> Path:
    path = folder / "belief.toml"
    path.write_text(text)
    return path


def test_units(tmp_path: Path) -> None:
    text = """
[gyros]
angle_random_walk_deg_sqrt_h = 0.001
bias_instability_deg_h = 0.003
rate_random_walk_deg_h_sqrt_h = 0.006
angle_white_noise_arcsec = 3.0
quantum_arcsec = 13.856406460551018
rate_ramp_deg_h_h = -0.1
tolerance_percent = 5
sinusoid_periods_s = [60.0]
[accelerometer_z]
bias_instability_micro_g = 7
"""
    found = read_beliefs(written(tmp_path, text))
    gyros = found["gyros"]
    expected = [5 * ARCSEC, 0.001 * DEG_PER_SQRT_H, 0.003 * DEG_PER_H, 0.0001 * DEG_PER_H]
    np.testing.assert_allclose(gyros.levels, expected)
    assert gyros.ramp == pytest.approx(-0.1 * DEG_PER_H / 3600)
    assert (gyros.tolerance, gyros.periods) == (0.05, (60.0,))
    assert found["accelerometer_z"].levels[2] == pytest.approx(7 * MICRO_G)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "belief.toml: found nothing, expected .gyros."),
        ("[clock]\nx = 1", "found 'clock', expected"),
        ("gyros = 1", "gyros: found 1, expected a table"),
        ("[gyros]\nangle_random_walk = 1", "angle_random_walk: found an unknown key.*_deg_sqrt_h"),
        ("[gyros]\nangle_random_walk_deg_sqrt_h = -1", "found -1, expected .* at least 0"),
        ("[gyros]\nangle_random_walk_deg_sqrt_h = nan", "found nan, expected a finite"),
        ("[gyros]\nangle_random_walk_deg_sqrt_h = '1'", "found '1', expected a number"),
        ("[gyros]\nangle_random_walk_deg_sqrt_h = 0", "found no noise"),
        (
            "[gyros]\nquantum_arcsec = 1\nsinusoid_periods_s = 3",
            "found 3, expected numbers in brackets",
        ),
        (
            "[gyros]\nquantum_arcsec = 1\nsinusoid_periods_s = [0]",
            r"found \[0.0\], expected periods above 0",
        ),
        ("[gyros]\nquantum_arcsec = 1\ntolerance_percent = 0", "found 0, expected 0.1 to 100"),
        ("gyros", "no TOML"),
    ],
)
def test_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        read_beliefs(written(tmp_path, text))
