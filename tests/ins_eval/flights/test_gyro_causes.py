"""The budget of gyros of a device: each line is what a flight without its keys lacks."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ins_eval.error_model.decomposition import sensor_error, sum_over_steps
from ins_eval.flights.flight import (
    Runs,
    Truth,
    count_still_increments,
    fly_runs,
    sample_truth,
    spawn_seeds,
)
from ins_eval.flights.gyro_causes import (
    HELD_FORCES,
    MISALIGNMENT,
    OWN_FMU,
    TOGETHER,
    replay_causes,
)
from ins_eval.flights.linear import COLUMNS, compute_error_budget
from ins_eval.flights.plan import Plan
from ins_eval.flights.sources import put_into_fmu
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.stated_gyros import StatedGyros
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.device.causes import list_causes
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.fmu_build.test_class_file import build
from tests.ins_eval.flights.test_linear import errors_at_the_end

DEVICE = Device(
    damping_anisotropy=7.5e-7,
    damping_axis=85 * DEG,
    pickoff_gain_mismatch=4e-5,
    drive_nonorthogonality=4e-5,
    angle_random_walk=3e-8,
)
"""As `typical`, of three mechanisms."""
KEYS = ["damping_anisotropy_per_s", "pickoff_gain_mismatch", "drive_nonorthogonality"]
FROM_TRUTH = Plan(0.05, 900 * 20, 200, alignment=None, seed=3)
ALIGNED = replace(FROM_TRUTH, alignment=120.0)


def fly(plan: Plan, imu: Imu, mission: str) -> tuple[Runs, Truth]:
    still = count_still_increments(plan.alignment, plan.interval)[1] * plan.interval
    truth = sample_truth(plan, load_trajectory(mission, plan.duration, still))
    return fly_runs(plan, truth, imu), truth


@pytest.mark.parametrize(
    ("mission", "own_axes", "plan", "tolerance"),
    [
        ("weaving", True, FROM_TRUTH, 1e-3),
        ("weaving", False, FROM_TRUTH, 1e-3),
        ("car", True, ALIGNED, 0.01),
    ],
)
def test_a_line_is_what_a_flight_without_its_key_lacks(
    mission: str, own_axes: bool, plan: Plan, tolerance: float
) -> None:
    """Tolerance: of the final error; 0.03 % are found, with an alignment 0.2 %. What the fine
    alignment makes of the gyros beyond their means is no line of theirs."""
    gyros = FmuGyros(DEVICE, own_axes, calibrated=plan.alignment is not None)
    imu = Imu(gyros=gyros, interval=plan.interval)
    flown, truth = fly(plan, imu, mission)
    table = compute_error_budget(plan, truth, imu, flown.first).table
    error = errors_at_the_end(flown, truth)[0]
    causes = list_causes(gyros.stated_devices)
    assert [cause.keys[0] for cause in causes] == KEYS
    for cause in causes:
        changed = replace(imu, gyros=gyros.change(cause.remove))
        without = errors_at_the_end(fly(plan, changed, mission)[0], truth)[0]
        line = table[table["effect"] == str(cause)][list(COLUMNS[2:])].sum().to_numpy()
        assert np.hypot(*line) > tolerance * np.hypot(*error)
        assert np.hypot(*(error - without - line)) < tolerance * np.hypot(*error)


def test_a_line_stays_when_another_key_is_zeroed() -> None:
    """The pick-offs' line without the damping anisotropy, whose harmonic is the same."""
    imu = Imu(gyros=FmuGyros(DEVICE, calibrated=False), interval=FROM_TRUTH.interval)
    damping = list_causes([DEVICE])[0]
    less = replace(imu.gyros, device=damping.remove(DEVICE))
    found = []
    for each in (imu, replace(imu, gyros=less)):
        flown, truth = fly(FROM_TRUTH, each, "weaving")
        table = compute_error_budget(FROM_TRUTH, truth, each, flown.first).table
        rows = table[table["effect"] == "pick-off gain mismatch (pickoff_gain_mismatch)"]
        found.append(rows[list(COLUMNS[2:])].to_numpy())
    np.testing.assert_allclose(found[1], found[0], atol=1e-3 * float(np.max(np.abs(found[0]))))


def test_what_no_key_states() -> None:
    """Misaligned gyros without another error: the closed forms; the sum is the FMU's."""
    gyros = FmuGyros(Device(), calibrated=False)
    imu = Imu(gyros=gyros, interval=0.05, mounting_deviation=20 * ARCSEC)
    truth = sample_truth(FROM_TRUTH, load_trajectory("weaving", 900.0))
    (seed,) = spawn_seeds(FROM_TRUTH.seed, 1)
    parts = replay_causes(imu, gyros, truth.increments, seed, 0.0, 0.5)
    assert parts.keys() == {HELD_FORCES, MISALIGNMENT}
    steps = 0.0, 0.5, 1800
    turned = sum_over_steps(truth.increments, *steps).rotation
    device = gyros.device
    held = theory.hold_scale_factor_error(device.control_period, 0.0, device.decay_time)
    size = abs(held) * np.max(np.abs(turned))
    np.testing.assert_allclose(parts[HELD_FORCES].rotation, held * turned, atol=0.01 * size)
    error = sensor_error(imu.measure(truth.increments, seed).increments, truth.increments)
    whole = sum(part.rotation for part in parts.values())
    np.testing.assert_allclose(sum_over_steps(error, *steps).rotation, whole, atol=0.02 * size)


def test_errors_that_need_each_other_are_together() -> None:
    """A split and a cubic softening, of which one phase error makes biases: it is in the split's
    line, so that the bias by the softening is in both."""
    device = Device(frequency_split=0.01, phase_error=1e-3, electrostatic_cubic=0.1)
    gyros = FmuGyros(device, own_axes=False, calibrated=False)
    truth = sample_truth(FROM_TRUTH, load_trajectory("weaving", 900.0))
    imu = Imu(gyros=gyros, interval=FROM_TRUTH.interval)
    parts = replay_causes(imu, gyros, truth.increments, 1, 0.0, 0.5)
    split = "frequency split and phase errors (frequency_split_Hz, phase_error_rad)"
    cubic = "electrostatic cubic (electrostatic_cubic_Hz)"
    assert [*parts] == [split, cubic, HELD_FORCES, TOGETHER]
    twice = parts[cubic].rotation
    size = float(np.max(np.abs(twice)))
    np.testing.assert_allclose(parts[TOGETHER].rotation, -twice, atol=0.02 * size)


def test_what_an_own_class_adds_is_a_line(tmp_path: Path) -> None:
    """A class whose gyros feel 1e-7 rad/s more about their axes, which the device does not state:
    its line is the difference of two flights, and the device's lines stay."""
    bias = 1e-7
    device = replace(DEVICE, angle_random_walk=0.0)
    plan = replace(FROM_TRUTH, count=300 * 20)
    imu = Imu(gyros=FmuGyros(device, calibrated=False), interval=plan.interval)
    own = put_into_fmu(imu, build(tmp_path, bias))
    tables, errors = [], []
    for each in (imu, own):
        flown, truth = fly(plan, each, "weaving")
        tables.append(compute_error_budget(plan, truth, each, flown.first).table)
        errors.append(errors_at_the_end(flown, truth)[0])
    columns = list(COLUMNS[2:])
    line = tables[1][tables[1]["effect"] == OWN_FMU][columns].sum().to_numpy()
    assert np.hypot(*line) > 0.1 * np.hypot(*errors[0])
    assert np.hypot(*(errors[1] - errors[0] - line)) < 1e-2 * np.hypot(*line)
    for cause in list_causes([device]):
        lines = [t[t["effect"] == str(cause)][columns].to_numpy() for t in tables]
        np.testing.assert_array_equal(*lines)


def test_an_own_fmu_wants_gyros_of_a_device_and_sampled_loops(
    tmp_path: Path, slow_fmu: GyroFmu
) -> None:
    with pytest.raises(HrgError, match=r"stated errors, expected \[gyros\] device"):
        put_into_fmu(Imu(gyros=StatedGyros()), tmp_path / "any.fmu")
    slow = slow_fmu.folder.parent / "HRGSlow.fmu"
    with pytest.raises(HrgError, match="no sampled control loops"):
        put_into_fmu(Imu(gyros=FmuGyros(DEVICE)), slow)
