"""Turned maps against `GyroMap`, one by one."""

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, GyroMap
from ins_eval.study.predictors.parts.turned_maps import start_maps, turn_weights, undo_start

RANDOM = np.random.default_rng(1)
MAPS = RANDOM.normal(size=(5, 2 * TERMS, 3))
ANGLES = RANDOM.uniform(0, 7, size=(5, 3))


def test_started_as_each_map_is() -> None:
    turned = start_maps(MAPS, ANGLES)
    for r, axis in np.ndindex(5, 3):
        single = GyroMap.from_coefficients(MAPS[r, :, axis]).start_at(float(ANGLES[r, axis]))
        np.testing.assert_allclose(turned[r, :, axis], single.coefficients, atol=1e-12)


def test_unstarted_takes_it_back() -> None:
    np.testing.assert_allclose(undo_start(start_maps(MAPS, ANGLES), ANGLES), MAPS, atol=1e-12)


def test_turning_weights_is_turning_maps() -> None:
    weights = RANDOM.normal(size=(4, 2, 2 * TERMS, 3))
    by_maps = np.einsum("kica,rca->rki", weights, start_maps(MAPS, ANGLES))
    by_weights = np.einsum("rkica,rca->rki", turn_weights(weights, ANGLES), MAPS)
    np.testing.assert_allclose(by_weights, by_maps, atol=1e-12)
