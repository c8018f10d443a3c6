"""Weights of the pattern's drift against rates that are written out."""

from dataclasses import replace

import numpy as np

from ins_eval.error_model.motion import PARTS, Motion, sample_motion
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS, evaluate_terms
from ins_eval.mission_model.missions import STILL, StudyMission
from ins_eval.mission_model.pattern_drift import (
    TURNING_TERMS,
    TurningIntegrals,
    compute_drift_products,
    integrate_turning_terms,
    list_drift_effects,
)
from ins_eval.mission_model.signals import COUNT

K, STEP, ROWS = 0.277, 1.0, 600


def _motion(mission: StudyMission) -> Motion:
    return sample_motion(mission.trajectory(), -STILL, STEP, ROWS)


def test_rate_of_a_pattern_that_drifts(short: StudyMission) -> None:
    """A map whose pattern drifts by its bias, integrated by Euler: b(th) less b(th0), to 3 %."""
    random = np.random.default_rng(1)
    left, bias = 1e-7 * random.normal(size=(TERMS, 3)), 1e-5 * random.normal(size=(3, 3))
    in_flight = np.zeros((1, COUNT, 3))
    in_flight[0, :TERMS] = left
    motion = _motion(short)
    effects = list_drift_effects(integrate_turning_terms(short.trajectory(), -STILL, ROWS - STILL))
    products = compute_drift_products(in_flight, bias[None])[0]
    found = sum(p * e.regressor(motion) for p, e in zip(products, effects, strict=True))
    ideal, step = -K * motion.turned, STEP / PARTS
    for axis in range(3):
        turning = evaluate_terms(ideal[:, axis])[:, list(TURNING_TERMS)] @ bias[:, axis]
        drifted = ideal[:, axis] - K * step * (np.cumsum(turning) - turning / 2)
        change = (evaluate_terms(drifted) - evaluate_terms(ideal[:, axis])) @ left[:, axis]
        assert np.max(np.abs(found[:, axis] - change)) < 0.03 * np.max(np.abs(change))


def test_angle_that_is_read_moves_with_the_pattern(short: StudyMission) -> None:
    """A scale factor's map at 20 deg/s: rate of change of e(th + d th) - e(th), to 3 %."""
    random = np.random.default_rng(1)
    scale, bias = 1e-5 * random.normal(size=(TERMS, 3)), 1e-5 * random.normal(size=(3, 3))
    in_flight = np.zeros((1, COUNT, 3))
    in_flight[0, TERMS : 2 * TERMS] = scale
    still = _motion(short)
    since = STEP / PARTS * np.arange(float(len(still.rate)))
    rate = np.deg2rad(20.0)
    turned = rate * np.repeat(since[:, None], 3, axis=1)
    motion = replace(still, rate=np.full_like(still.rate, rate), turned=turned)
    waves = evaluate_terms(-K * turned)[..., list(TURNING_TERMS)]
    integrals = STEP / PARTS * (np.cumsum(waves, axis=0) - waves / 2 - waves[0] / 2)
    by = TurningIntegrals(motion.start + since, np.moveaxis(integrals, 1, 2))
    effects = list_drift_effects(by)
    products = compute_drift_products(in_flight, bias[None])[0]
    found = sum(p * e.regressor(motion) for p, e in zip(products, effects, strict=True))
    ideal, step = -K * motion.turned, STEP / PARTS
    for axis in range(3):
        turning = evaluate_terms(ideal[:, axis])[:, list(TURNING_TERMS)] @ bias[:, axis]
        drifted = ideal[:, axis] - K * step * (np.cumsum(turning) - turning / 2)
        error = _angle_error(scale[:, axis], drifted) - _angle_error(scale[:, axis], ideal[:, axis])
        change = np.gradient(error, step)[1:-1]
        assert np.max(np.abs(found[1:-1, axis] - change)) < 0.03 * np.max(np.abs(change))


def _angle_error(scale: np.ndarray, angle: np.ndarray) -> np.ndarray:
    total = np.zeros_like(angle)
    for place, h in enumerate(HARMONICS):
        cos, sin = scale[1 + 2 * place : 3 + 2 * place]
        total += (sin * np.cos(h * angle) - cos * np.sin(h * angle)) / (h * K)
    return total


def test_what_warms_drifts_as_it_is_warm() -> None:
    """Bias at power-on and what it gains count alike; a mean has no slope."""
    one, other = np.zeros((2, 1, COUNT, 3))
    one[0, 3], other[0, 2 * TERMS + 3] = 1.0, 1.0
    bias = np.ones((1, len(TURNING_TERMS), 3))
    np.testing.assert_array_equal(
        compute_drift_products(one, bias), compute_drift_products(other, bias)
    )
    mean = np.zeros((1, COUNT, 3))
    mean[0, 0] = 1.0
    assert not compute_drift_products(mean, bias).any()
