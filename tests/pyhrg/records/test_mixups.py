"""Radians under a deg header and their like are told from what a bench really does."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import DEG, HOUR
from pyhrg.records import Log, LogError, read_log, write_log
from tests.pyhrg.records.made_up import LATITUDE, K, made_up_log


def read_back(log: Log, folder: Path) -> Log:
    write_log(log, folder / "log.csv")
    return read_log(folder / "log.csv", latitude_deg=LATITUDE / DEG)


def scaled(log: Log, factor: float, *fields: str) -> Log:
    return replace(log, **{field: getattr(log, field) * factor for field in fields})


def virtually_rotated() -> Log:
    log = made_up_log()
    rotation = np.where(np.arange(600) > 100, 1 * DEG, 0.0)
    wave = log.wave_angle + K * np.cumsum(rotation)
    return replace(log, virtual_rotation=rotation, wave_angle=wave)


def ringing_down() -> Log:
    """Drive off: the pattern, and the output with it, drifts much faster than Earth turns."""
    log = made_up_log()
    gyro = log.gyro_angle + 1e-6 * np.arange(600) ** 2
    return replace(log, drive_on=np.zeros(600), gyro_angle=gyro, wave_angle=0.5 - K * gyro)


def level() -> Log:
    log = made_up_log()
    gyro = 1e-3 * log.gyro_angle
    return replace(log, axis_up=np.zeros(600), gyro_angle=gyro, wave_angle=0.5 - K * gyro)


def locked() -> Log:
    """In its dead zone the gyro stays where it is while the table creeps."""
    log = made_up_log(noise=1e-3)
    creeping = -log.gyro_angle + log.gyro_angle[0]
    still = 1e-9 * np.random.default_rng(3).normal(size=600)
    return replace(log, table_angle=creeping, gyro_angle=still, wave_angle=0.5 - K * still)


def held() -> Log:
    """A loop holds the pattern in place; what is left of its motion is noise."""
    wave = 0.5 + 1e-4 * np.random.default_rng(4).normal(size=600)
    return replace(made_up_log(), wave_angle=wave)


HONEST: list[Callable[[], Log]] = [
    *(made_up_log, virtually_rotated, ringing_down, level, locked, held),
    lambda: made_up_log(table_rate=0.01 * DEG),
    lambda: made_up_log(table_rate=-100 * DEG),
]


@pytest.mark.parametrize("log", HONEST)
def test_what_a_bench_does_passes(tmp_path: Path, log: Callable[[], Log]) -> None:
    assert read_back(log(), tmp_path).exclusions == ()


@pytest.mark.parametrize("rate", [-100.0, -2.0, 2.0, 100.0])
@pytest.mark.parametrize("field", ["gyro_angle", "table_angle"])
@pytest.mark.parametrize("factor", [DEG, 1 / DEG, HOUR])
def test_gyro_is_held_to_the_table(tmp_path: Path, rate: float, field: str, factor: float) -> None:
    log = scaled(made_up_log(table_rate=rate * DEG), factor, field)
    with pytest.raises(LogError, match=r"gyro_angle_deg: turns .* times as far as table_angle"):
        read_back(log, tmp_path)


@pytest.mark.parametrize("make", [made_up_log, virtually_rotated, ringing_down])
@pytest.mark.parametrize("field", ["gyro_angle", "wave_angle"])
def test_wave_is_held_to_the_gyro(tmp_path: Path, make: Callable[[], Log], field: str) -> None:
    """Where it rotates virtually, it is that rotation which the wave follows."""
    if make is virtually_rotated and field == "gyro_angle":
        field = "virtual_rotation"
    with pytest.raises(LogError, match=r"log.csv: column wave_angle_deg: turns .*Bryan factor"):
        read_back(scaled(make(), DEG, field), tmp_path)


@pytest.mark.parametrize("factor", [HOUR, 1 / HOUR])
def test_an_angle_of_rates_per_hour_for_per_second_is_told(tmp_path: Path, factor: float) -> None:
    """By the pattern, and by Earth's rate where no pattern was logged."""
    log = scaled(made_up_log(), factor, "gyro_angle")
    with pytest.raises(LogError, match="is a rate per hour given where one per second is meant"):
        read_back(log, tmp_path)
    alone = replace(log, wave_angle=np.full(600, np.nan))
    with pytest.raises(LogError, match=r"times as far as Earth's rate.*: is a rate per hour"):
        read_back(alone, tmp_path)


@pytest.mark.parametrize("make", [made_up_log, virtually_rotated])
def test_earths_rate_tells_where_all_angles_are_in_radians(
    tmp_path: Path, make: Callable[[], Log]
) -> None:
    angles = "table_angle", "gyro_angle", "wave_angle", "virtual_rotation"
    log = scaled(make(), DEG, *angles)
    with pytest.raises(LogError, match=r"turns 0\.017\d times as far as Earth's rate asks for"):
        read_back(log, tmp_path)


@pytest.mark.parametrize("rate", [-100.0, -5.0, 5.0, 100.0])
def test_earths_rate_tells_it_beside_the_tables_too(tmp_path: Path, rate: float) -> None:
    """Nothing else contradicts a log that turns throughout; in degrees it passes."""
    whole = made_up_log(table_rate=rate * DEG)
    half = {name: value[300:] for name, value in vars(whole).items() if np.ndim(value)}
    log = replace(whole, **half)
    assert read_back(log, tmp_path).exclusions == ()
    with pytest.raises(LogError, match=r"turns 0\.017\d times as far as Earth's rate asks for"):
        read_back(scaled(log, DEG, "table_angle", "gyro_angle", "wave_angle"), tmp_path)


def test_g_is_told_from_metres(tmp_path: Path) -> None:
    with pytest.raises(LogError, match=r"accel_z_m_s2 and its like: 0.999 in all"):
        read_back(scaled(made_up_log(), 1 / 9.80665, "acceleration_z"), tmp_path)


def test_a_reversed_sign_is_refused(tmp_path: Path) -> None:
    log = made_up_log(table_rate=5 * DEG)
    reversed_log = scaled(log, -1.0, "gyro_angle", "wave_angle")
    with pytest.raises(LogError, match=r"gyro_angle_deg.*is a sign reversed"):
        read_back(reversed_log, tmp_path)


def test_an_output_that_never_changes_is_refused(tmp_path: Path) -> None:
    log = replace(made_up_log(), gyro_angle=np.zeros(600))
    with pytest.raises(LogError, match="gyro_angle_deg: stands still throughout"):
        read_back(log, tmp_path)
