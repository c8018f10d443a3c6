"""Position errors of many triads in one mission, by the linear error model, in parts."""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.noise_weights import KINDS, factors
from ins_eval.mission_model.pattern_drift import drift_products
from ins_eval.mission_model.signals import ENVIRONMENT, STEADY, WARMING, coefficients_of
from ins_eval.mission_model.standing import beyond_first_order
from ins_eval.mission_model.triads import Triads

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Flown:
    """Error north and east, m, of r triads at k times, each (r, k, 2); its parts add up.

    map: of the gyros' maps as at power-on; warming: of what the maps gain as they warm;
    environment: of what they gain with specific force, while the case heats, and turning fast;
    drift: of the patterns' own drift (`pattern_drift`); accelerometers; noise: of the gyros;
    alignment: what aligning does beyond first order.
    """

    map: Array
    warming: Array
    environment: Array
    drift: Array
    accelerometers: Array
    noise: Array
    alignment: Array

    @property
    def error(self) -> Array:
        """All together."""
        return np.asarray(sum(getattr(self, field.name) for field in fields(self)))

    @property
    def radial(self) -> Array:
        """(r, k) m."""
        return np.asarray(np.hypot(*np.moveaxis(self.error, -1, 0)))


def flown(triads: Triads, weights: MissionWeights, mission: int) -> Flown:
    """Fly a block of triads through a mission.

    Args:
        triads: the block.
        weights: of the mission.
        mission: its number in the study: of each triad's noise in it.
    """

    def part(of: slice) -> Array:
        chosen = coefficients_of(of)
        return map_errors(weights.maps[:, :, chosen], triads.in_flight[:, chosen])

    return Flown(
        map=part(STEADY),
        warming=part(WARMING),
        environment=part(ENVIRONMENT),
        drift=map_errors(weights.drift, drift_products(triads.in_flight, triads.turning)),
        accelerometers=accelerometer_errors(weights, triads.accelerometers),
        noise=noise_errors(weights, triads.noise, triads.seeds, mission),
        alignment=alignment_errors(weights, triads),
    )


def map_errors(weights: Array, coefficients: Array) -> Array:
    """(r, k, 2) m of coefficients (r, c, 3) with weights (k, 2, c, 3)."""
    k, r = len(weights), len(coefficients)
    return (coefficients.reshape(r, -1) @ weights.reshape(2 * k, -1).T).reshape(r, k, 2)


def accelerometer_errors(weights: MissionWeights, biases: Array) -> Array:
    """What accelerometer biases (r, 3), m/s^2, do: (r, k, 2) m."""
    return np.asarray(np.einsum("kia,ra->rki", weights.accelerometers, biases))


def alignment_errors(weights: MissionWeights, triads: Triads) -> Array:
    """(r, k, 2) m that alignment does beyond first order; noise, averaged over it, left out."""
    rate = np.einsum("ca,rca->ra", weights.standing.rates, triads.in_flight)
    return beyond_first_order(weights.standing, rate, triads.accelerometers)


def noise_errors(
    weights: MissionWeights, strengths: Array, seeds: NDArray[np.uint64], mission: int
) -> Array:
    """A draw of what noise does: (r, k, 2) m.

    Args:
        weights: of the mission.
        strengths: (r, KINDS, 3) of each gyro's noise, in the units of `KINDS`.
        seeds: (r, 2) entropy of each triad; with the mission's number it decides the draw.
        mission: number of the mission.
    """
    rows = weights.noise.shape[-1]
    normal = np.empty((len(seeds), len(KINDS), 3, rows))
    for triad, entropy in enumerate(seeds.tolist()):
        sequence = np.random.SeedSequence(entropy, spawn_key=(mission,))
        normal[triad] = np.random.default_rng(sequence).standard_normal(normal.shape[1:])
    normal *= strengths[..., None]
    roots = np.moveaxis(factors(weights.noise), -1, -2).reshape(-1, rows)
    return (normal.reshape(len(seeds), -1) @ roots).reshape(len(seeds), -1, 2)
