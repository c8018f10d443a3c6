"""A block of triads as arrays: what flies, and what the bench measured of it."""

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class TriadBlock:
    """r triads of three gyros, along forward, right, down; SI.

    What the bench measured of each gyro after calibration (`study.gyros.measured_gyro`):
    fixed_stability, fixed_repeatability, circumference_stability, instability: (r, 3) rad/s;
    random_walk: (r, 3) rad/sqrt(s);
    fitted_map: (r, 2 TERMS, 3) coefficients of its map over the pattern angle itself;
    map_per_kelvin: (r, 2 TERMS, 3) their change per kelvin;
    map_variance: (r, 2 TERMS, 3) variance of their errors in another power-on.

    What flies:
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
