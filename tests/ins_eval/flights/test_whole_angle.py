"""The 1-sigma of an HRG triad holds its flights on a turntable, its pick-off map included."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from benchmarks.nees import TURNTABLE, compute_nees, without_pick_off_map
from ins_eval.error_model.effects import pick_off_map
from ins_eval.error_model.motion import sample_motion, step_mean
from ins_eval.flights.assumed_errors import assume_errors
from ins_eval.flights.flight import Runs, Truth, fly_runs, sample_truth
from ins_eval.flights.plan import Plan
from ins_eval.imu import gyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.bench.bench import Bench
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

RUNS = 24
SLOW = """
start = { latitude_deg = 48, longitude_deg = 11 }
course = [
  { kind = "turntable", turn_deg = 120, rate_deg_s = 2 },
  { kind = "rest", duration_s = 200 },
]
"""
PLAN = Plan(0.02, 40 * 50, 500, alignment=None, seed=5, runs=RUNS)


@pytest.fixture(scope="module")
def truth(tmp_path_factory: pytest.TempPathFactory) -> Truth:
    path = tmp_path_factory.mktemp("missions") / "turntable.toml"
    path.write_text(TURNTABLE)
    return sample_truth(PLAN, load_trajectory(str(path), PLAN.duration))


@pytest.fixture(scope="module")
def imu() -> Imu:
    """With ideal accelerometers."""
    return Imu(gyros=load_imu("typical-hrg").gyros, interval=PLAN.interval)


@pytest.fixture(scope="module")
def flown(truth: Truth, imu: Imu) -> Runs:
    """The makers' calibrations, which take longer than the flights, are the closed form."""

    def know_mean_bias(bench: Bench) -> float:
        return theory.mean_bias(bench.device)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(gyros, "calibrate_mean_bias", know_mean_bias)
        return fly_runs(PLAN, truth, imu)


def test_position_and_attitude_are_within_their_sigma(truth: Truth, imu: Imu, flown: Runs) -> None:
    """24 runs, seed 5: below the 99.9 % quantile. Axes of fixed size scatter less than normal ones,
    so that chi-square's lower bound is none."""
    position, attitude = compute_nees(PLAN, truth, flown, assume_errors(imu))
    assert 0.2 < position < chi2.ppf(0.999, 2 * RUNS) / (2 * RUNS)
    assert 0.2 < attitude < chi2.ppf(0.999, 3 * RUNS) / (3 * RUNS)


def test_without_the_pick_off_map_they_are_not(truth: Truth, imu: Imu, flown: Runs) -> None:
    before = without_pick_off_map(assume_errors(imu))
    assert max(compute_nees(PLAN, truth, flown, before)) > 5


def test_effect_is_the_fmus(fmu: GyroFmu, tmp_path: Path) -> None:
    """A down gyro of unequal and skewed pick-offs on a slow turntable, then at rest: angle and bias
    within 2 % of the largest error; not without the bias by the misaimed force."""
    gain, skew, start, step, count = 1e-4, -2e-4, 0.3, 0.5, 400
    path = tmp_path / "slow.toml"
    path.write_text(SLOW)
    device = Device(decay_time=450.0, pickoff_gain_mismatch=gain, pickoff_nonorthogonality=skew)
    trajectory = load_trajectory(str(path), step * count)
    motion = sample_motion(trajectory, 0.0, step, count)
    turned = trajectory.increments(0.0, step, count).rotation[:, 2:]
    with fmu.power_on(device.fmu_parameters(), seed=0, start_angle=start) as gyro:
        first = gyro.read("gyroAngle")
        ends, _ = gyro.record({"angularRate": turned / step}, {}, step, ["gyroAngle"])
    error = ends[:, 0] - first - np.cumsum(turned)
    held = theory.hold_scale_factor_error(device.control_period, 0.0, device.decay_time)

    def expect(decay_time: float) -> np.ndarray:
        cosine, sine = pick_off_map(4, np.full(3, start), decay_time)
        rate = -gain * cosine.regressor(motion) - skew * sine.regressor(motion)
        steady = theory.mean_bias(device) * step + held * turned[:, 0]
        return np.asarray(np.cumsum(step * step_mean(rate)[:, 2] + steady))

    size = np.max(np.abs(error))
    np.testing.assert_allclose(error, expect(device.decay_time), atol=0.02 * size)
    assert np.max(np.abs(error - expect(np.inf))) > 0.1 * size
