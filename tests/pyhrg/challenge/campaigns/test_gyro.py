"""The true gyro, against recorded campaigns and against itself."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance, TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.device import device_file
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.inputs.inputs import prepare_inputs
from pyhrg.gap.replay.replay import HELD_COLUMNS
from pyhrg.records import Log, campaign
from tests.pyhrg.challenge.short import GYRO, resting, turning

SETTLED = 5
"""Rows until start and table motion are over."""


def course_of_log(log: Log, rates: np.ndarray, gravity: float) -> Course:
    held = {name: getattr(log, name) for name in HELD_COLUMNS}
    level = {
        n: np.round(held[n] / gravity) * gravity for n in HELD_COLUMNS if n.startswith("accel")
    }
    still, on = np.zeros(len(log.time)), np.ones(len(log.time))
    inputs = {**held, **level, "axis_up": log.axis_up, "vibration": still, "bias_voltage": on}
    temperature = np.full(len(log.time) + 1, GYRO.reference_temperature)
    return Course(log.interval, log.interval / 100, rates, temperature, inputs)


@pytest.mark.parametrize(
    "name",
    ["rate_5dps_pos", "rate_100dps_neg", "ring_down", "virtual_rotation_pos", "phase_step"],
)
def test_recorded_campaign_is_reproduced_to_its_noise(
    recorded_campaign: Path, fmu: GyroFmu, name: str
) -> None:
    brought = campaign.read_campaign(recorded_campaign)
    truth = json.loads((recorded_campaign / "truth.json").read_text())["parameters"]
    believed = device_file.from_table({**brought.nominal, **truth}, "dev-01")
    device = replace(believed, site=brought.site)
    log = next(test.log for test in brought.tests if test.id == name)
    inputs = prepare_inputs(log, device)
    course = course_of_log(log, inputs.table.rates, brought.site.gravity)
    quiet = TrueGyro(fmu, device).exact(name, course, inputs.start_angle, np.zeros((1, 1)))
    own = Instruments()
    rows = slice(SETTLED, None)

    def deviation(channel: str) -> float:
        return float(np.std((getattr(log, channel) - getattr(quiet, channel))[rows]))

    assert deviation("amplitude") == pytest.approx(own.amplitude, rel=0.12)
    assert deviation("quadrature_force") == pytest.approx(own.quadrature_force, rel=0.12)
    assert deviation("frequency_offset") == pytest.approx(own.frequency_offset, rel=0.12)
    fast = np.diff(log.gyro_angle - quiet.gyro_angle, 2)[rows] / np.sqrt(6)
    assert np.std(fast) == pytest.approx(device.angle_white_noise, rel=0.15)
    if name != "ring_down":
        force = own.amplitude_force * quiet.amplitude_force[rows].mean()
        assert deviation("amplitude_force") == pytest.approx(force, rel=0.12)


def test_first_commands_hold_from_the_first_period(fmu: GyroFmu) -> None:
    """A = 0.8 from time 0: the first period's growth is 2 w e + w^2 e T + 1/tau, w = 6 rad/s,
    e = -0.2."""
    course = replace(resting(2.0), step=1e-3)
    low = {**course.held, "amplitude_setpoint": np.full(2, 0.8)}
    first = replace(course, interval=2e-3, held=low)
    log = TrueGyro(fmu, GYRO).exact("", first, 0.3, np.zeros((1, 1)))
    began = -0.2 * (2 * 6 + 36 * 1e-3) + 1 / GYRO.decay_time
    assert log.amplitude_force[0] == pytest.approx(began, rel=0.02)


def test_rows_do_not_depend_on_the_blocks_they_are_made_in(
    fmu: GyroFmu, monkeypatch: pytest.MonkeyPatch
) -> None:
    gyro, course = TrueGyro(fmu, GYRO), turning(20.0)
    whole = gyro.exact("", course, 0.3, np.zeros((1, 1)))
    monkeypatch.setattr("pyhrg.fmu.gyro.CHUNK", 3000)
    parts = gyro.exact("", course, 0.3, np.zeros((1, 1)))
    for name in ("gyro_angle", "amplitude", "amplitude_force", "quadrature_force"):
        np.testing.assert_array_equal(getattr(whole, name), getattr(parts, name))


def test_sampled_and_slow_gyro_agree_where_loops_are_at_rest(
    fmu: GyroFmu, slow_fmu: GyroFmu
) -> None:
    course, still = resting(60.0), np.zeros((1, 1))
    sampled = TrueGyro(fmu, GYRO).exact("", course, 0.3, still)
    slow = TrueGyro(slow_fmu, GYRO).exact("", replace(course, step=0.1), 0.3, still)
    rows = slice(SETTLED, None)
    moved = [np.diff(log.gyro_angle)[rows] for log in (sampled, slow)]
    np.testing.assert_allclose(moved[0], moved[1], atol=1e-3 * ARCSEC)
    np.testing.assert_allclose(
        sampled.quadrature_force[rows], slow.quadrature_force[rows], atol=1e-8
    )


def test_an_added_rate_is_seen_in_the_output(fmu: GyroFmu) -> None:
    course, still = resting(60.0), np.zeros((1, 1))
    rate = 1.0 * DEG_PER_H
    disturbance = Disturbance(rate=lambda course, start: np.full((1, 1), rate))
    with_it = TrueGyro(fmu, GYRO, disturbance=disturbance).exact("", course, 0.3, still)
    without = TrueGyro(fmu, GYRO).exact("", course, 0.3, still)
    gained = with_it.gyro_angle - without.gyro_angle
    np.testing.assert_allclose(gained, rate * course.interval * np.arange(1, 61), rtol=1e-3)


def test_noise_is_the_generators_alone(fmu: GyroFmu) -> None:
    gyro, course = TrueGyro(fmu, GYRO), resting(20.0)
    logs = [gyro.log("", course, 0.3, np.random.default_rng(seed))[0] for seed in (1, 1, 2)]
    np.testing.assert_array_equal(logs[0].gyro_angle, logs[1].gyro_angle)
    assert np.any(logs[0].gyro_angle != logs[2].gyro_angle)


def test_noise_of_the_output_angle_is_what_a_quiet_gyro_lacks(fmu: GyroFmu) -> None:
    gyro, course, still = TrueGyro(fmu, GYRO), turning(60.0), np.zeros((1, 1))
    log, noise = gyro.log("", course, 0.3, np.random.default_rng(1))
    quiet = gyro.exact("", course, 0.3, still)
    np.testing.assert_allclose(noise, log.gyro_angle - quiet.gyro_angle, atol=1e-3 * noise.std())
