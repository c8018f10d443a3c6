"""Position errors of triads of one gyro model, by part; each gyro has its own power-on angle."""

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.pattern_drift import compute_drift_products
from ins_eval.mission_model.position_errors import compute_alignment_errors, compute_map_errors
from ins_eval.mission_model.signals import ENVIRONMENT, STEADY, WARMING, slice_coefficients
from ins_eval.position.gyro import Gyro
from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

MAP_PARTS = {
    "bias map": slice(0, TERMS),
    "scale-factor map": slice(TERMS, slice_coefficients(STEADY).stop),
    "warming": slice_coefficients(WARMING),
    "specific force, heating, fast turning": slice_coefficients(ENVIRONMENT),
}
"""Coefficients in flight that make each named part of the error budget."""
DRIFT_PART = "pattern's own drift"
"""Name of the part that the drift of the vibration pattern makes (second order)."""
ALIGNMENT_PART = "alignment beyond first order"
"""Name of the part that the alignment makes beyond the linear error model."""


def draw_power_on_angles(triads: int, seed: int) -> Array:
    """(triads, 3) pattern angles at power-on, rad, uniform over half a turn: a period of every
    harmonic of a map."""
    return np.random.default_rng(seed).uniform(0.0, np.pi, (triads, 3))


def compute_error_parts(
    weights: MissionWeights, in_flight: tuple[Array, Array]
) -> dict[str, Array]:
    """Position error north and east without noise, by part: (r, k, 2) m each.

    in_flight: coefficients of r triads, as `Gyro.compute_flight_coefficients` returns them; the
    gyros lie along forward, right and down.
    """
    maps, turning = in_flight
    return {
        **{
            name: compute_map_errors(weights.maps[:, :, part], maps[:, part])
            for name, part in MAP_PARTS.items()
        },
        DRIFT_PART: compute_map_errors(weights.drift, compute_drift_products(maps, turning)),
        ALIGNMENT_PART: compute_alignment_errors(weights, maps),
    }


def compute_noise_rms(weights: MissionWeights, gyro: Gyro) -> dict[str, Array]:
    """Rms horizontal position error of each kind of noise: (k,) m each."""
    variances = np.einsum("najj->naj", weights.noise).sum(axis=1)
    horizontal = variances.reshape(len(COEFFICIENT_NAMES), -1, 2).sum(axis=-1)
    kinds = (name.replace("_", " ") for name in COEFFICIENT_NAMES)
    return dict(zip(kinds, gyro.noise[:, None] * np.sqrt(horizontal), strict=True))
