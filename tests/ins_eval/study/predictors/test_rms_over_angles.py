"""Rms over angles against drawn angles."""

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, start_maps
from ins_eval.study.predictors.rms_over_angles import compute_gyro_rms

WEIGHTS = np.random.default_rng(1).normal(size=(1, 2, 2 * TERMS, 3))
MAPS = np.random.default_rng(2).normal(size=(1, 2 * TERMS, 3))
ANGLES = np.random.default_rng(3).uniform(0, 2 * np.pi, size=(40_000, 3))


def _within(found: float, errors: np.ndarray) -> None:
    """Of the mean square over draws, four sigmas."""
    power = np.sum(errors**2, axis=-1)
    assert abs(found**2 - power.mean()) < 4 * power.std() / np.sqrt(len(power))


def test_gyro_on_each_axis_in_turn() -> None:
    gyro = 1
    everywhere = np.repeat(MAPS[:, :, [gyro]], 3, axis=2)
    turned = start_maps(everywhere, np.repeat(ANGLES[:, [0]], 3, axis=1))
    by_axis = np.einsum("kica,rca->rkia", WEIGHTS, turned)[:, 0]
    _within(float(compute_gyro_rms(WEIGHTS, MAPS)[0, 0, gyro]), by_axis.reshape(len(ANGLES), -1))
