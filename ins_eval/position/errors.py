"""Position errors of triads of one gyro, each gyro with a power-on angle of its own, in parts."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.flown import map_errors
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.noise_weights import KINDS
from ins_eval.mission_model.pattern_drift import drift_products
from ins_eval.mission_model.signals import ENVIRONMENT, STEADY, WARMING, coefficients_of
from ins_eval.mission_model.standing import beyond_first_order
from ins_eval.position.gyro import Gyro

Array = NDArray[np.float64]

PARTS = {
    "bias map": slice(0, TERMS),
    "scale-factor map": slice(TERMS, coefficients_of(STEADY).stop),
    "warming": coefficients_of(WARMING),
    "specific force, heating, fast turning": coefficients_of(ENVIRONMENT),
}
"""Coefficients in flight, by what is said of them."""
DRIFT, ALIGNMENT = "pattern's own drift", "alignment beyond first order"


def power_on_angles(triads: int, seed: int) -> Array:
    """(r, 3) rad, uniform over the pattern's half turn, a period of every harmonic of a map."""
    return np.random.default_rng(seed).uniform(0.0, np.pi, (triads, 3))


def errors(weights: MissionWeights, in_flight: tuple[Array, Array]) -> dict[str, Array]:
    """Error north and east, m, (r, k, 2) by part; noise apart.

    Args:
        weights: of the mission.
        in_flight: of `Gyro`: three of them along forward, right, down.
    """
    maps, turning = in_flight
    rate = np.einsum("ca,rca->ra", weights.standing.rates, maps)
    return {
        **{name: map_errors(weights.maps[:, :, c], maps[:, c]) for name, c in PARTS.items()},
        DRIFT: map_errors(weights.drift, drift_products(maps, turning)),
        ALIGNMENT: beyond_first_order(weights.standing, rate, np.zeros_like(rate)),
    }


def noise_rms(weights: MissionWeights, gyro: Gyro) -> dict[str, Array]:
    """(k,) rms horizontal error of each kind of noise, m."""
    variances = np.einsum("najj->naj", weights.noise).sum(axis=1)
    horizontal = variances.reshape(len(KINDS), -1, 2).sum(axis=-1)
    return dict(zip(KINDS, gyro.noise[:, None] * np.sqrt(horizontal), strict=True))
