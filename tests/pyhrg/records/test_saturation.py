"""Saturated stretches are left out; what may stand still is not."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records import Log, read_log, write_log
from tests.pyhrg.records.made_up import made_up_log

RESPONSES = (
    *("gyro_angle", "wave_angle", "amplitude"),
    *("amplitude_force", "quadrature_force", "frequency_offset"),
)


def read_back(log: Log, folder: Path) -> Log:
    write_log(log, folder / "log.csv")
    return read_log(folder / "log.csv")


def held(log: Log, field: str, first: int, last: int) -> Log:
    """A channel that repeats one value from a row of the array to before another."""
    values = getattr(log, field).copy()
    values[first:last] = values[first]
    return replace(log, **{field: values})


@pytest.mark.parametrize("field", RESPONSES)
def test_stretch_that_stands_still_is_left_out(tmp_path: Path, field: str) -> None:
    log = read_back(held(made_up_log(), field, 200, 260), tmp_path)
    assert len(log.exclusions) == 1
    assert log.exclusions[0].startswith("rows 202-261: ")
    assert log.exclusions[0].endswith("stands still: saturated, left out")
    assert log.stretches(field) == [slice(0, 200), slice(260, 600)]


def test_clipped_channel_is_left_out_wherever_it_clips(tmp_path: Path) -> None:
    """A force that swings into its limit ten times."""
    quiet = made_up_log()
    swing = 2e-3 * np.sin(np.arange(600) * np.pi / 30) + quiet.quadrature_force
    log = read_back(replace(quiet, quadrature_force=np.minimum(swing, 5e-4)), tmp_path)
    assert np.sum(np.isnan(log.quadrature_force)) == np.sum(swing >= 5e-4)


def test_angle_that_stands_while_the_table_turns_is_left_out(tmp_path: Path) -> None:
    """Three rows, and most of the turn, noise or not."""
    for noise in (0.0, 1.0):
        turning = made_up_log(table_rate=5 * DEG, noise=noise)
        for first, last in ((400, 403), (310, 590)):
            log = read_back(held(turning, "gyro_angle", first, last), tmp_path)
            assert list(np.flatnonzero(np.isnan(log.gyro_angle))) == list(range(first, last))


@pytest.mark.parametrize("seed", range(20))
def test_ordinary_log_is_whole(tmp_path: Path, seed: int) -> None:
    assert read_back(made_up_log(table_rate=1 * DEG, seed=seed), tmp_path).exclusions == ()


def test_gyro_without_noise_may_stand_still(tmp_path: Path) -> None:
    """Its loops settle and then repeat to the last digit, in several positions."""
    log = made_up_log(noise=0.0)
    settling = np.exp(-6.0 * (np.arange(600) % 150))
    still = replace(log, amplitude=1 + 1e-3 * settling, gyro_angle=np.full(600, 0.1))
    still = replace(still, wave_angle=np.full(600, 0.1), axis_up=np.zeros(600))
    assert read_back(still, tmp_path).exclusions == ()


@pytest.mark.parametrize("quantum", [1 * ARCSEC, 100 * ARCSEC])
def test_quantised_angle_may_wait_for_its_next_quantum(tmp_path: Path, quantum: float) -> None:
    """Level (slow) after a while axis up (fast)."""
    log = made_up_log()
    slow = np.cumsum(np.where(np.arange(600) < 300, 10.0, 0.1)) * ARCSEC
    gyro = np.round((slow + log.gyro_angle * 1e-3) / quantum) * quantum
    level = np.where(np.arange(600) < 300, 1.0, 0.0)
    log = replace(log, gyro_angle=gyro, wave_angle=-0.277 * slow, axis_up=level)
    assert read_back(log, tmp_path).exclusions == ()


def test_forces_may_be_off(tmp_path: Path) -> None:
    off = np.arange(600) > 400
    log = made_up_log()
    log = replace(
        log,
        drive_on=np.where(off, 0.0, 1.0),
        amplitude_force=np.where(off, 0.0, log.amplitude_force),
        quadrature_force=np.where(off, 0.0, log.quadrature_force),
    )
    assert read_back(log, tmp_path).exclusions == ()
