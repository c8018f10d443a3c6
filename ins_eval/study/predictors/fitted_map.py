"""Predictor (4): this gyro's fitted map, through the linear error model of this mission.

The expected error comes from the bias and scale-factor maps that the bench fitted, and from their
change as the gyros warm (Eq. 4). The spread comes from the bench's uncertainty, the drift of maps
between bench and flight, noise and accelerometers (Eqs. 6 to 8).
"""

from ins_eval.mission_model.gyro_map import start_maps
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.study.predictors.bench_figures import BenchFigures
from ins_eval.study.predictors.parts.drawn_errors import draw_at_angles, draw_at_any_angle
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.prediction import SampledPrediction
from pyhrg.common.arrays import Array


def predict(
    bench: BenchFigures,
    weights: MissionWeights,
    drift: MapDrift,
    other: Array,
    start_angle: Array,
    seed: int,
) -> SampledPrediction:
    """Errors of triads whose gyros' power-on angles are known.

    Args:
        drift: distribution of the maps' drift, from other triads.
        other: (r, k, 2, 2) covariance of the error by noise and accelerometers, m^2.
        start_angle: (r, 3) pattern angles at power-on, rad.
    """
    expected = compute_expected_error(weights, start_maps(bench.maps, start_angle))
    sigma, standard = drift.compute_sigma_with_bench(bench), drift.standard
    return draw_at_angles(weights.maps, expected, sigma, standard, other, start_angle, seed)


def predict_any_angle(
    bench: BenchFigures,
    weights: MissionWeights,
    drift: MapDrift,
    other: Array,
    seed: int,
) -> SampledPrediction:
    """Errors of triads whose gyros' power-on angles are unknown; arguments as `predict`."""
    sigma = drift.compute_sigma_with_bench(bench)
    return draw_at_any_angle(weights.maps, bench.maps, sigma, drift.standard, other, seed)
