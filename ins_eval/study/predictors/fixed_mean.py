"""Predictor: the mean bias of the fixed-position test as a constant rate (Eq. 3a).

It uses nothing but that test and data sheets, and knows one value of the gyro's map: that at the
angle where the bench held the pattern. It holds where the flight starts at this angle and the
pattern stays near it.
"""

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.study.predictors.bench_figures import BenchFigures
from ins_eval.study.predictors.prediction import NormalPrediction
from pyhrg.common.arrays import Array

CONSTANT_BIAS = 0
"""Index of a constant bias among the coefficients of a map."""


def predict(bench: BenchFigures, weights: MissionWeights, other: Array) -> NormalPrediction:
    """Errors of triads; the spread is by the test's repeatability and by `other`.

    Args:
        other: (r, k, 2, 2) covariance of the error by noise and accelerometers, m^2.
    """
    maps = np.zeros_like(bench.maps)
    maps[:, CONSTANT_BIAS] = bench.fixed_bias
    carried = weights.maps[:, :, CONSTANT_BIAS]
    spread = np.einsum("kia,kja,ra->rkij", carried, carried, bench.fixed_repeatability**2)
    return NormalPrediction(compute_expected_error(weights, maps), other + spread)
