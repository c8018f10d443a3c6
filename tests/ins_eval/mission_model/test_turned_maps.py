"""Turned maps against the terms that they are coefficients of."""

import numpy as np

from ins_eval.mission_model.gyro_map import (
    TERMS,
    evaluate_terms,
    start_maps,
    turn_weights,
    undo_start,
)

RANDOM = np.random.default_rng(1)
MAPS = RANDOM.normal(size=(5, 2 * TERMS, 3))
ANGLES = RANDOM.uniform(0, 7, size=(5, 3))


def test_started_as_each_map_is() -> None:
    turned, turn = start_maps(MAPS, ANGLES), RANDOM.uniform(0, 7, size=20)
    for r, axis in np.ndindex(5, 3):
        at_turn, at_angle = (evaluate_terms(turn + start) for start in (0.0, ANGLES[r, axis]))
        for part in (slice(0, TERMS), slice(TERMS, None)):
            expected = at_angle @ MAPS[r, part, axis]
            np.testing.assert_allclose(at_turn @ turned[r, part, axis], expected, atol=1e-12)


def test_unstarted_takes_it_back() -> None:
    np.testing.assert_allclose(undo_start(start_maps(MAPS, ANGLES), ANGLES), MAPS, atol=1e-12)


def test_turning_weights_is_turning_maps() -> None:
    weights = RANDOM.normal(size=(4, 2, 2 * TERMS, 3))
    by_maps = np.einsum("kica,rca->rki", weights, start_maps(MAPS, ANGLES))
    by_weights = np.einsum("rkica,rca->rki", turn_weights(weights, ANGLES), MAPS)
    np.testing.assert_allclose(by_weights, by_maps, atol=1e-12)
