"""A mission and triads that exist on paper only, with stated seeds."""

import numpy as np

from ins_eval.mission_model import pattern_drift, signals
from ins_eval.mission_model.alignment_at_rest import AlignmentAtRest
from ins_eval.mission_model.gyro_map import TERMS, evaluate_terms, start_maps
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.mission_model.signals import COUNT
from ins_eval.study.gyros.bench_plan import WARM_RISE
from ins_eval.study.predictors import prediction_columns
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR, MICRO_G
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

SPREAD = np.repeat([0.1 * DEG_PER_H, 20e-6], TERMS)
"""Of a map's coefficients between devices: biases, scale factors."""
WIDTH = np.log(3)
"""Gyros are larger or smaller by up to this factor, log-uniform."""
SHARES = (0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001)
DRIFT = np.concatenate([share * SPREAD for share in SHARES]) / SPREAD[0]
"""Of a map between bench and flight, for each of `signals.SIGNALS`; units: the bias map's rms."""
GAIN = 1e-3
"""Of a map's coefficients per K, as a share of `SPREAD`."""
FIT = 0.03 * SPREAD
"""Uncertainty of the bench's fit."""
EXACT = 0 * FIT
WALK = 1e-4 * DEG_PER_SQRT_H
ACCELEROMETER_BIAS = 10 * MICRO_G
MOUNTING = 10 * ARCSEC
SHEETS = (ACCELEROMETER_BIAS, MOUNTING)
"""What predictors take from data sheets."""


def mission(seed: int, times: int = 1) -> MissionWeights:
    """Weights of the size of an hour's, about 100 m a 0.01 deg/h."""
    random = np.random.default_rng(seed)
    size = np.repeat([1e4 / DEG_PER_H, 1e7], TERMS)[:, None]
    noise = random.normal(size=(len(COEFFICIENT_NAMES), 3, 2 * times, 2 * times))
    return MissionWeights(
        name="paper",
        time=HOUR * np.arange(1.0, times + 1),
        maps=np.tile(size, (len(signals.SIGNALS), 1)) * random.normal(size=(times, 2, COUNT, 3)),
        drift=np.zeros((times, 2, pattern_drift.COUNT, 3)),
        accelerometers=random.normal(size=(times, 2, 3)) / MICRO_G,
        mounting=random.normal(size=(times, 2, 2, 3)) * 10 / ARCSEC,
        noise=(noise @ np.swapaxes(noise, -1, -2)) * (100 / WALK) ** 2,
        alignment=AlignmentAtRest(
            latitude=0.7,
            height=0.0,
            mat_nb=np.eye(3),
            rates=np.zeros((COUNT, 3)),
            attitude=np.zeros((times, 2, 3)),
        ),
    )


def triads(seed: int, count: int, spread: Array = SPREAD, fit: Array = FIT) -> TriadBlock:
    """Whose bench errs by `fit`; whose maps drift, warm and make noise as stated above. What the
    bench expects of their warming is true, but for the drift."""
    random = np.random.default_rng(seed)
    shape, c = (count, 2 * TERMS, 3), 2 * TERMS
    factor = np.exp(random.uniform(-WIDTH, WIDTH, size=(count, 1, 3)))
    bench_map = factor * spread[:, None] * random.normal(size=shape)
    start_angle = np.pi * random.random((count, 3))
    known = bench_map + fit[:, None] * random.normal(size=shape)
    size = np.sqrt(np.mean(known[:, 1:TERMS] ** 2, axis=1, keepdims=True) + fit[1] ** 2)
    gain = GAIN * spread[:, None] * random.normal(size=shape)
    rise = random.uniform(2.0, 15.0, size=(count, 3))
    true = np.zeros((count, COUNT, 3))
    true[:, :c], true[:, c : 2 * c] = bench_map, gain * rise[:, None]
    drifted = true + DRIFT[:, None] * size * random.normal(size=true.shape)
    variance = np.broadcast_to(fit[:, None] ** 2, shape)
    told = gain + np.sqrt(variance) / WARM_RISE * random.normal(size=shape)
    stability = np.sqrt(np.sum(bench_map[:, 1:TERMS] ** 2, axis=1) / 2)
    noise = np.zeros((count, len(COEFFICIENT_NAMES), 3))
    noise[:, 1] = WALK
    return TriadBlock(
        fixed_bias=np.einsum("rat,rta->ra", evaluate_terms(start_angle), known[:, :TERMS]),
        fixed_stability=0.01 * stability[::-1],
        fixed_repeatability=0.001 * stability[::-1],
        circumference_stability=stability,
        instability=np.zeros((count, 3)),
        random_walk=noise[:, 1],
        fitted_map=known,
        map_per_kelvin=told,
        map_variance=variance,
        start_angle=start_angle,
        rise=rise,
        in_flight=start_maps(drifted, start_angle),
        turning=np.zeros((count, len(pattern_drift.TURNING_TERMS), 3)),
        noise=noise,
        accelerometers=ACCELEROMETER_BIAS * random.normal(size=(count, 3)),
        seeds=random.integers(2**63, size=(count, 2), dtype=np.uint64),
        mounting=MOUNTING * random.normal(size=(count, 2, 3)),
    )


def class_ratios(training: TriadBlock, weights: MissionWeights) -> dict[str, Array]:
    """Of a class that is this mission."""
    model = prediction_columns.train(training, *SHEETS)
    end = prediction_columns.select_time(weights, -1)
    return prediction_columns.compute_class_ratios(end, training, model, seed=1)
