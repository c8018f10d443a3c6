"""A mission and triads that exist on paper only, with stated seeds."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.noise_weights import KINDS
from ins_eval.study.predictors.turned_maps import started
from ins_eval.study.standing import Standing
from ins_eval.study.triads import Triads
from pyhrg.units import DEG_PER_H, DEG_PER_SQRT_H, HOUR, MICRO_G

Array = NDArray[np.float64]

SPREAD = np.repeat([0.1 * DEG_PER_H, 20e-6], TERMS)
"""Of a map's coefficients between devices: biases, scale factors."""
WIDTH = np.log(3)
"""Gyros are larger or smaller by up to this factor, log-uniform."""
DRIFT = np.concatenate([0.1 * SPREAD, 0.05 * SPREAD, 0.02 * SPREAD]) / SPREAD[0]
"""Of a map between bench and flight, of its warming and its square; units: the bias map's rms."""
FIT = 0.03 * SPREAD
"""Uncertainty of the bench's fit."""
EXACT = 0 * FIT
WALK = 1e-4 * DEG_PER_SQRT_H
ACCELEROMETER_BIAS = 10 * MICRO_G


def mission(seed: int, times: int = 1) -> MissionWeights:
    """Weights of the size of an hour's, about 100 m a 0.01 deg/h."""
    random = np.random.default_rng(seed)
    size = np.repeat([1e4 / DEG_PER_H, 1e7], TERMS)[:, None]
    noise = random.normal(size=(len(KINDS), 3, 2 * times, 2 * times))
    return MissionWeights(
        name="paper",
        time=HOUR * np.arange(1.0, times + 1),
        gyros=size * random.normal(size=(times, 2, 2 * TERMS, 3)),
        warming=size * random.normal(size=(times, 2, 2 * TERMS, 3)),
        curving=size * random.normal(size=(times, 2, 2 * TERMS, 3)),
        accelerometers=random.normal(size=(times, 2, 3)) / MICRO_G,
        noise=(noise @ np.swapaxes(noise, -1, -2)) * (100 / WALK) ** 2,
        standing=Standing(
            latitude=0.7,
            height=0.0,
            mat_nb=np.eye(3),
            started=np.zeros((2 * TERMS, 3)),
            warming=np.zeros((2 * TERMS, 3)),
            curving=np.zeros((2 * TERMS, 3)),
            attitude=np.zeros((times, 2, 3)),
        ),
    )


def triads(seed: int, count: int, spread: Array = SPREAD, fit: Array = FIT) -> Triads:
    """Whose bench errs by `fit`; whose maps drift, warm and make noise as stated above."""
    random = np.random.default_rng(seed)
    shape, c = (count, 2 * TERMS, 3), 2 * TERMS
    factor = np.exp(random.uniform(-WIDTH, WIDTH, size=(count, 1, 3)))
    bench_map = factor * spread[:, None] * random.normal(size=shape)
    start_angle = np.pi * random.random((count, 3))
    known = bench_map + fit[:, None] * random.normal(size=shape)
    size = np.sqrt(np.mean(known[:, 1:TERMS] ** 2, axis=1, keepdims=True) + fit[1] ** 2)
    drifted = bench_map + DRIFT[:c, None] * size * random.normal(size=shape)
    warming = DRIFT[c : 2 * c, None] * size * random.normal(size=shape)
    curving = DRIFT[2 * c :, None] * size * random.normal(size=shape)
    stability = np.sqrt(np.sum(bench_map[:, 1:TERMS] ** 2, axis=1) / 2)
    noise = np.zeros((count, len(KINDS), 3))
    noise[:, 1] = WALK
    return Triads(
        fixed_stability=0.01 * stability[::-1],
        circumference_stability=stability,
        instability=np.zeros((count, 3)),
        walk=noise[:, 1],
        known=known,
        covariance=np.broadcast_to(np.diag(fit**2)[..., None], (count, c, c, 3)),
        true=bench_map,
        start_angle=start_angle,
        started=started(drifted, start_angle),
        warming=started(warming, start_angle),
        curving=started(curving, start_angle),
        noise=noise,
        accelerometers=ACCELEROMETER_BIAS * random.normal(size=(count, 3)),
        seeds=random.integers(2**63, size=(count, 2), dtype=np.uint64),
    )
