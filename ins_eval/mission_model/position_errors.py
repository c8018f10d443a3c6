"""Position errors of many triads in one mission, by the linear error model, in parts; no navigator
runs. What the bench measured of them stands beside what they are. Method:
docs/methods/mission_model.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.error_budget import BODY
from ins_eval.mission_model.alignment_at_rest import compute_second_order_error
from ins_eval.mission_model.gyro_map import turn_weights
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.noise_weights import factor_covariances
from ins_eval.mission_model.pattern_drift import compute_drift_products
from ins_eval.mission_model.signals import ENVIRONMENT, STEADY, WARMING, slice_coefficients
from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import COEFFICIENT_NAMES


@dataclass(frozen=True)
class TriadBlock:
    """r triads of three gyros, along forward, right, down; SI.

    What the bench measured of each gyro after calibration (`study.gyros.measured_gyro`):
    fixed_bias, fixed_stability, fixed_repeatability, circumference_stability, instability: (r, 3)
    rad/s;
    random_walk: (r, 3) rad/sqrt(s);
    fitted_map: (r, 2 TERMS, 3) coefficients of its map over the pattern angle itself;
    map_per_kelvin: (r, 2 TERMS, 3) their change per kelvin;
    map_variance: (r, 2 TERMS, 3) variance of their errors in another power-on.

    What the linear model takes for the flight:
    start_angle: (r, 3) pattern angle at power-on, rad;
    rise: (r, 3) final temperature above that of the calibration, K;
    in_flight: (r, COUNT, 3) coefficients of `signals` over the pattern's turn from that angle;
    turning: (r, TURNING_TERMS, 3) bias that turns the pattern (`pattern_drift`), from that angle,
    rad/s;
    noise: (r, 4, 3) noise coefficients, SI, in the order of `COEFFICIENT_NAMES`;
    accelerometers: (r, 3) biases, m/s^2;
    mounting: (r, 2, 3) angles by which the input axis along each body axis leans towards the next
    body axis, and towards the one after, rad;
    seeds: (r, 2) entropy of each triad's noise in flight.
    """

    fixed_bias: Array
    fixed_stability: Array
    fixed_repeatability: Array
    circumference_stability: Array
    instability: Array
    random_walk: Array
    fitted_map: Array
    map_per_kelvin: Array
    map_variance: Array
    start_angle: Array
    rise: Array
    in_flight: Array
    turning: Array
    noise: Array
    accelerometers: Array
    mounting: Array
    seeds: NDArray[np.uint64]

    def __len__(self) -> int:
        return len(self.start_angle)

    def select(self, rows: Sequence[int] | slice) -> "TriadBlock":
        return TriadBlock(**{f.name: getattr(self, f.name)[rows] for f in fields(self)})


@dataclass(frozen=True)
class PositionErrors:
    """Error north and east, m, of r triads at k times; each part is (r, k, 2), and they add up.

    Attributes:
        map: error by the gyros' maps as they are at power-on.
        warming: error by the change of the maps while the gyros warm.
        environment: error by the maps' sensitivity to specific force, heating of the case and fast
            turning.
        drift: error by the patterns' own drift (`pattern_drift`).
        accelerometers: error by accelerometer biases.
        mounting: error by input axes that lean from where the navigator assumes them.
        noise: error by the gyros' noise.
        alignment: second-order error of the alignment (`alignment_at_rest`).
    """

    map: Array
    warming: Array
    environment: Array
    drift: Array
    accelerometers: Array
    mounting: Array
    noise: Array
    alignment: Array

    @property
    def error(self) -> Array:
        """(r, k, 2) total error, m: the sum of the parts."""
        return np.asarray(sum(getattr(self, field.name) for field in fields(self)))

    @property
    def radial(self) -> Array:
        """(r, k) horizontal error, m."""
        return np.asarray(np.hypot(*np.moveaxis(self.error, -1, 0)))


def compute_linear_position_errors(
    triads: TriadBlock, weights: MissionWeights, mission: int
) -> PositionErrors:
    """Position errors of a block of triads in a mission.

    mission: number of the mission in the study; with a triad's seed it decides the noise.
    """

    def part(signals: slice) -> Array:
        columns = slice_coefficients(signals)
        return compute_map_errors(weights.maps[:, :, columns], triads.in_flight[:, columns])

    return PositionErrors(
        map=part(STEADY),
        warming=part(WARMING),
        environment=part(ENVIRONMENT),
        drift=compute_map_errors(
            weights.drift, compute_drift_products(triads.in_flight, triads.turning)
        ),
        accelerometers=np.asarray(
            np.einsum("kia,ra->rki", weights.accelerometers, triads.accelerometers)
        ),
        mounting=compute_map_errors(weights.mounting, triads.mounting),
        noise=draw_noise_errors(weights, triads.noise, triads.seeds, mission),
        alignment=compute_alignment_errors(weights, triads.in_flight, triads.accelerometers),
    )


def compute_map_errors(weights: Array, coefficients: Array) -> Array:
    """(r, k, 2) position error, m, of coefficients (r, c, 3) with weights (k, 2, c, 3) (Eq. 6)."""
    k, r = len(weights), len(coefficients)
    return (coefficients.reshape(r, -1) @ weights.reshape(2 * k, -1).T).reshape(r, k, 2)


def compute_alignment_errors(
    weights: MissionWeights, maps: Array, accelerometers: Array | None = None
) -> Array:
    """(r, k, 2) second-order error of the alignment, m (Eq. 8), of coefficients in flight
    (r, COUNT, 3) and accelerometer biases (r, 3), m/s^2, none by default. Gyro noise averages out
    over the alignment and is left out."""
    rate = np.einsum("ca,rca->ra", weights.alignment.rates, maps)
    force = np.zeros_like(rate) if accelerometers is None else accelerometers
    return compute_second_order_error(weights.alignment, rate, force)


def compute_expected_error(weights: MissionWeights, maps: Array) -> Array:
    """(r, k, 2) error, m, of known coefficients in flight (r, COUNT, 3) alone, the alignment's
    second order included (study_predictors.md, Eq. 4)."""
    return compute_map_errors(weights.maps, maps) + compute_alignment_errors(weights, maps)


def draw_noise_errors(
    weights: MissionWeights, strengths: Array, seeds: NDArray[np.uint64], mission: int
) -> Array:
    """(r, k, 2) position error, m, of one draw of the gyros' noise (Eq. 11).

    strengths: (r, 4, 3) noise coefficients of each gyro, SI (`COEFFICIENT_NAMES`); seeds: (r, 2)
    entropy of each triad; with the mission's number it decides the draw.
    """
    rows = weights.noise.shape[-1]
    normal = np.empty((len(seeds), len(COEFFICIENT_NAMES), 3, rows))
    for triad, entropy in enumerate(seeds.tolist()):
        sequence = np.random.SeedSequence(entropy, spawn_key=(mission,))
        normal[triad] = np.random.default_rng(sequence).standard_normal(normal.shape[1:])
    normal *= strengths[..., None]
    roots = np.moveaxis(factor_covariances(weights.noise), -1, -2).reshape(-1, rows)
    return (normal.reshape(len(seeds), -1) @ roots).reshape(len(seeds), -1, 2)


def compute_map_worth(weights: MissionWeights, covariance: Array, angle: float) -> Array:
    """(3,) rms horizontal error at the mission's end, m, by one gyro along each body axis.

    covariance: (2 TERMS, 2 TERMS) of its bias map, rad/s, and scale-factor map, over the pattern
    angle, constant in the mission; angle: of the pattern when the mission begins, rad.
    """
    carried = turn_weights(weights.gyros[-1:], np.full(len(BODY), angle))[0]
    power = np.einsum("ica,cd,ida->a", carried, covariance, carried)
    return np.asarray(np.sqrt(np.maximum(power, 0.0)))
