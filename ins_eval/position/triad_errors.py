"""Position errors of triads of one gyro model, by part; each gyro has its own power-on angle. The
model's maps are measured on the FMU. An unexplained residual rate bounds what else it could cause.
"""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, start_maps
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import SETTLING, STILL
from ins_eval.mission_model.pattern_drift import compute_drift_products
from ins_eval.mission_model.position_errors import compute_alignment_errors, compute_map_errors
from ins_eval.mission_model.signals import ENVIRONMENT, STEADY, WARMING, slice_coefficients
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import compute_turning_bias, read_flight_coefficients
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

CASE_RISE = 10.0
"""Final rise of the case's temperature above the reference temperature after power-on, K; the
resonator follows. Chosen."""


@dataclass(frozen=True)
class Gyro:
    """A device that warms by `CASE_RISE` in flight.

    Attributes:
        coefficients: (signals.COUNT,) coefficients of its maps over the pattern angle itself.
        noise: (4,) its noise coefficients, SI, in the order of `COEFFICIENT_NAMES`.
    """

    device: Device
    coefficients: Array
    noise: Array

    def compute_flight_coefficients(self, angles: Array) -> tuple[Array, Array]:
        """Coefficients of r triads of such gyros over the turn since power-on.

        angles: (r, 3) power-on angles, rad.

        Returns (r, signals.COUNT, 3) coefficients of the maps, and (r, pattern_drift.TURNING_TERMS,
        3) bias that turns the pattern, rad/s.
        """
        maps = start_maps(np.repeat(self.coefficients[:, None], 3, axis=1), angles)
        turning = [
            [compute_turning_bias(self.device, self.coefficients, angle) for angle in triad]
            for triad in angles.tolist()
        ]
        return maps, np.moveaxis(np.array(turning), 1, -1)

    def make_flights(self, angles: Array) -> tuple[Flight, ...]:
        """Flights of three such gyros, from their power-on angles (3,), rad."""
        return tuple(Flight(self.device, CASE_RISE, angle) for angle in angles.tolist())


def measure_gyro(fmu: GyroFmu, device: Device) -> Gyro:
    """Measure a device's maps on the FMU `HRGSlow`."""
    noise = np.array([getattr(device, name) for name in COEFFICIENT_NAMES])
    return Gyro(device, read_flight_coefficients(fmu, device, CASE_RISE), noise)


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


RANDOM_WALK = COEFFICIENT_NAMES.index("angle_random_walk")


@dataclass(frozen=True)
class ResidualBound:
    """Largest horizontal error at a mission's end, m, of three gyros whose rate errors have the
    same rms.

    Attributes:
        steady: bound for constant rate errors, over all combinations of signs.
        any_course: bound for rate errors that vary in time in any way.
    """

    steady: float
    any_course: float


def bound_residual_error(weights: MissionWeights, rate: float) -> ResidualBound:
    """Bounds for rate errors of this rms, rad/s, from the alignment to the mission's end.

    The position error is the integral of each rate error times a weight. By the Cauchy-Schwarz
    inequality it is at most the duration's root times the rms of the rate error times the root of
    the integral of the squared weight; the latter is the error per unit of angle random walk.
    """
    bias = weights.gyros[-1, :, 0]
    steady = max(float(np.hypot(*(bias @ np.array(signs)))) for signs in product((1, -1), repeat=3))
    duration = STILL - SETTLING + float(weights.time[-1])
    largest = np.linalg.eigvalsh(weights.noise[RANDOM_WALK][:, -2:, -2:])[:, -1]
    any_course = math.sqrt(duration) * float(np.sqrt(np.maximum(largest, 0.0)).sum())
    return ResidualBound(rate * steady, rate * any_course)
