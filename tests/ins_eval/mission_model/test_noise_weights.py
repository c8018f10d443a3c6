"""Covariances of noise against impulses one by one, and against the FMU's own noise."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from ins_eval.mission_model.noise_weights import (
    FMU_FLICKER_LAGS,
    FMU_FLICKER_SCALE,
    compute_error_weights,
    compute_noise_covariances,
    factor_covariances,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import COEFFICIENT_NAMES
from tests.driving import drive

STEP, BEFORE, STEPS = 0.5, 3, 12
KEPT = np.array([5, 12])


def system() -> tuple[Array, Array]:
    generator = np.random.default_rng(1)
    transition = np.eye(4) + 0.1 * generator.standard_normal((STEPS, 4, 4))
    return transition, generator.standard_normal((STEPS, 4, 3))


def rates(kind: str, deviates: Array) -> Array:
    """(STEPS,) of one gyro whose noise of a kind has these deviates, from power-on."""
    if kind == "angle_white_noise":
        return np.diff(deviates) / STEP
    if kind == "angle_random_walk":
        return deviates / np.sqrt(STEP)
    if kind == "rate_random_walk":
        return np.sqrt(STEP) * np.cumsum(deviates)[BEFORE:]
    decays = np.exp(-STEP / FMU_FLICKER_LAGS)
    lags, total = np.zeros(len(decays)), []
    for deviate in deviates:
        lags = decays * lags + (1 - decays) * np.sqrt(FMU_FLICKER_LAGS / STEP) * deviate
        total.append(FMU_FLICKER_SCALE * lags.sum())
    return np.array(total)[BEFORE:]


@pytest.mark.parametrize("kind", COEFFICIENT_NAMES)
def test_covariance_is_that_of_every_deviate(kind: str) -> None:
    transition, per_rate = system()
    found = compute_noise_covariances(
        compute_error_weights(transition, per_rate, KEPT), STEP, BEFORE
    )
    count = {"angle_white_noise": STEPS + 1, "angle_random_walk": STEPS}
    total = np.zeros((4, 4))
    for impulse in np.eye(count.get(kind, STEPS + BEFORE)):
        x, told = np.zeros(4), []
        for k, rate in enumerate(rates(kind, impulse)):
            x = transition[k] @ x + per_rate[k, :, 1] * rate
            if k + 1 in KEPT:
                told += [x[0], x[1]]
        total += np.outer(told, told)
    assert found[COEFFICIENT_NAMES.index(kind), 1] == pytest.approx(total, rel=1e-9, abs=1e-9)


def test_factors_square_to_a_singular_covariance() -> None:
    root = np.random.default_rng(2).standard_normal((5, 2))
    covariance = root @ root.T
    found = factor_covariances(covariance)
    assert found @ found.T == pytest.approx(covariance, abs=1e-9)


def test_noise_is_the_fmus(slow_fmu: GyroFmu) -> None:
    """Angle after 20 min at rest, its first 20 s left out: 99.9 % interval of its variance."""
    strengths = (0.5 * ARCSEC, 3e-4 * DEG_PER_SQRT_H, 2e-3 * DEG_PER_H, 8e-3 * DEG_PER_H)
    white, walk, flicker, per_hour = strengths
    noise = np.array([white, walk, flicker, per_hour / np.sqrt(HOUR)])
    device = replace(
        Device(),
        angle_white_noise=noise[0],
        angle_random_walk=noise[1],
        bias_instability=noise[2],
        rate_random_walk=noise[3],
    )
    runs, steps, before = 60, 1200, 20
    ends = []
    for seed in range(runs):
        with slow_fmu.power_on(device.fmu_parameters(), seed, 0.3) as gyro:
            angles = drive(gyro, np.zeros(steps + before), 1.0)
        ends.append(angles[-1] - angles[before - 1])
    transition = np.tile(np.eye(2), (steps, 1, 1))
    per_rate = np.zeros((steps, 2, 3))
    per_rate[:, 0, 0] = 1.0
    weights = compute_error_weights(transition, per_rate, np.array([steps]))
    expected = noise**2 @ compute_noise_covariances(weights, 1.0, before)[:, 0, 0, 0]
    low, high = stats.chi2.ppf([0.0005, 0.9995], runs) / runs
    assert low < np.mean(np.square(ends)) / expected < high
