"""Logs in PSINS' text format."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.flights import sources
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG
from tests.recordings import find_recording

HEADER = """% PSINS-format SIMU log file.

1.0 2.0 -90.6 0 0 0
34.246048 108.909664 380.0 5.0 10.0 9.8
0.1 0.2 0.3 100.0 200.0 300.0
"""
ROWS = "1 2 3 4 5 6\n" * 20


@pytest.fixture
def ring_laser() -> Path:
    """A recorded log; `HRG_REAL` says where such are."""
    return find_recording("lasergyro.imu.gz")


def write(folder: Path, text: str) -> Path:
    path = folder / "log.imu"
    path.write_text(text)
    return path


def test_counts_become_forward_right_down(tmp_path: Path) -> None:
    log = sources.read_record(write(tmp_path, HEADER + ROWS))
    first = log.increments.between(0, 1)
    np.testing.assert_allclose(first.rotation, [[0.4 * ARCSEC, 0.1 * ARCSEC, -0.9 * ARCSEC]])
    np.testing.assert_allclose(first.velocity, 9.8e-6 * np.array([[1000.0, 400.0, -1800.0]]))
    assert (len(log.increments), log.increments.interval, log.increments.start) == (20, 0.01, 5.0)


def test_yaw_is_turned_into_heading(tmp_path: Path) -> None:
    log = sources.read_record(write(tmp_path, HEADER + ROWS))
    assert log.position == pytest.approx([34.246048 * DEG, 108.909664 * DEG, 380.0])
    assert log.attitude == pytest.approx([2 * DEG, 1 * DEG, 90.6 * DEG])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ("1 2 3 4 5\n", r"log\.imu: row 26: found 5 fields, expected 6"),
        ("1 2 x 4 5 6\n", r"row 26, g_z: found 'x', expected a number"),
        ("1 2 3 nan 5 6\n", r"row 26, a_x: found nan, expected a finite number"),
        ("1 2 3 4 5 -inf\n", r"row 26, a_z: found -inf, expected a finite number"),
        ("\n1 2 3 4 5 6\n", r"row 26: found 0 fields, expected 6"),
    ],
)
def test_a_wrong_row_is_named(tmp_path: Path, wrong: str, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        sources.read_record(write(tmp_path, HEADER + ROWS + wrong))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("34.246048", "94.2", r"row 4, latitude0\(deg\): found 94.2, expected -90 to 90"),
        (" 10.0 ", " 0 ", r"row 4, sampling-interval\(ms\): found 0, expected 0.1 to 1000"),
        ("0.3 ", "-1 ", "row 5, gf_z: found -1, expected 1e-06 to 1e"),
        (" 9.8\n", "\n", "row 4: found 5 fields, expected 6: latitude0"),
    ],
)
def test_a_wrong_header_is_named(tmp_path: Path, old: str, new: str, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        sources.read_record(write(tmp_path, HEADER.replace(old, new) + ROWS))


def test_a_z_axis_that_points_down_is_named(tmp_path: Path) -> None:
    """One g along z, the wrong way round: 1e4 counts of 1e-6 g s in 10 ms; 300 in the header."""
    header = HEADER.replace("300.0", "1.0")
    sources.read_record(write(tmp_path, header + "0 0 0 0 0 10000\n" * 20))
    path = write(tmp_path, header + "0 0 0 0 0 -10000\n" * 20)
    with pytest.raises(HrgError, match=r"column a_x .*is z down where up is meant"):
        sources.read_record(path)
    assert sources.read_record(path, trusted=True).increments.velocity[0, 2] > 0


def test_too_few_rows_and_a_cut_file_are_named(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="found 1 rows of values, expected at least 10"):
        sources.read_record(write(tmp_path, HEADER + "1 2 3 4 5 6\n"))
    cut = tmp_path / "cut.imu.gz"
    cut.write_bytes(gzip.compress((HEADER + ROWS).encode())[:-20])
    with pytest.raises(HrgError, match=r"cut\.imu\.gz: found what is no whole gzipped data"):
        sources.read_record(cut)


def test_the_ring_laser_feels_gravity_and_earth(ring_laser: Path) -> None:
    """Gravity to 0.1 % and Earth's rate to 5 % over the whole record, by norm and sign."""
    log = sources.read_record(ring_laser)
    assert log.position is not None
    latitude, _, height = log.position
    force = log.increments.velocity.sum(axis=0) / log.increments.duration
    rate = log.increments.rotation.sum(axis=0) / log.increments.duration
    assert log.increments.duration == pytest.approx(1847.2, abs=0.1)
    assert force[2] == pytest.approx(-earth.gravity(latitude, height), rel=1e-3)
    assert np.linalg.norm(rate) == pytest.approx(earth.RATE, rel=0.05)
    assert rate[2] == pytest.approx(-earth.RATE * np.sin(latitude), rel=0.05)
