"""Rows that are compared, and the temperature that is replayed."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import (
    CHANNELS,
    COARSE_SETTLING_STEPS,
    ObservedTest,
    observe_test,
)
from pyhrg.records import Log
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log


def observe(log: Log, device: Device | None = None) -> ObservedTest:
    return observe_test(Test("test", "static", "fit", log), device or Device())


def nan_at(values: Array, rows: slice) -> Array:
    changed = values.copy()
    changed[rows] = np.nan
    return changed


def test_rows_without_an_angle_are_not_compared() -> None:
    log = made_up_log(60)
    rows = observe(replace(log, gyro_angle=nan_at(log.gyro_angle, slice(30, 33)))).rows
    for name in CHANNELS:
        assert np.flatnonzero(~rows[name][25:]).tolist() == [5, 6, 7], name
    rows = observe(replace(log, amplitude=nan_at(log.amplitude, slice(30, 33)))).rows
    assert rows["gyro_angle"].all()
    assert not rows["amplitude"][30:33].any()


@pytest.mark.parametrize(("loop", "settled"), [(6.0, COARSE_SETTLING_STEPS), (1.0, 24), (0.5, 48)])
def test_slow_loops_take_longer(loop: float, settled: int) -> None:
    test = observe(made_up_log(60), Device(quadrature_loop=loop))
    assert np.flatnonzero(test.rows["quadrature_force"])[0] == settled


def test_forces_are_not_compared_without_drive() -> None:
    log = made_up_log(60)
    off = np.where(log.time > 30, 0.0, 1.0)
    rows = observe(replace(log, drive_on=off)).rows
    assert not rows["amplitude_force"][30:].any()
    assert rows["amplitude"][30 + COARSE_SETTLING_STEPS :].all()


def test_the_angle_is_not_compared_while_the_amplitude_changes() -> None:
    log = made_up_log(120)
    lower = np.where(log.time > 60, 0.8, 1.0) * log.amplitude_setpoint
    rows = observe(replace(log, amplitude_setpoint=lower)).rows["gyro_angle"]
    assert np.flatnonzero(~rows).tolist() == list(range(60, 60 + COARSE_SETTLING_STEPS))
    off = np.where((log.time > 40) & (log.time <= 60), 0.0, 1.0)
    rows = observe(replace(log, drive_on=off)).rows["gyro_angle"]
    assert np.flatnonzero(~rows).tolist() == list(range(60, 60 + COARSE_SETTLING_STEPS))


def test_an_amplitude_that_may_show_the_next_push_is_not_compared() -> None:
    log = made_up_log(120)
    lower = np.where(log.time > 60, 0.8, 1.0) * log.amplitude_setpoint
    rows = observe(replace(log, amplitude_setpoint=lower)).rows
    left_out = np.flatnonzero(~rows["amplitude"][30:]) + 30
    assert left_out.tolist() == list(range(59, 60 + COARSE_SETTLING_STEPS))
    assert rows["amplitude_force"][59]


def test_the_noise_of_a_thermometer_is_averaged() -> None:
    log = made_up_log(600)
    assert np.ptp(observe(log).inputs.temperatures) == 0
    warmed = replace(log, temperature=log.temperature + 1e-4 * log.time)
    assert np.ptp(observe(warmed).inputs.temperatures) > 0.05


def test_motion_of_the_table_makes_rows_transient() -> None:
    still, turning = (observe(made_up_log(60, rate)).transient[5:] for rate in (0.0, 5 * DEG))
    assert not still.any()
    assert turning.any()
    assert not turning.all()


def test_loops_settle_anew_when_the_gyro_is_turned_over() -> None:
    """A slowly changing specific force, as on a vehicle, excludes no rows."""
    log = made_up_log(120)
    over = np.where(log.time > 60, 9.8, 0.0)
    rows = observe(replace(log, acceleration_x=over)).rows
    assert np.flatnonzero(~rows["amplitude_force"][30:]).tolist() == list(range(30, 50))
    assert rows["gyro_angle"].all()
    swaying = 3.0 * np.sin(log.time / 10)
    assert observe(replace(log, acceleration_x=swaying)).rows["amplitude_force"][30:].all()
