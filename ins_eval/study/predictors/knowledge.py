"""What predictors may know of the gyros of many triads before they fly."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.triads import Triads

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BenchKnowledge:
    """What a bench tells of r triads, gyro by gyro along body axes.

    fixed_stability, circumference_stability: (r, 3) rad/s;
    maps: (r, 2 TERMS, 3) fitted coefficients of `GyroMap`, calibration taken out;
    covariance: (r, 2 TERMS, 2 TERMS, 3) of their errors;
    noise: (r, KINDS, 3) strengths of `noise_weights.KINDS`, zero where the bench sees none.
    """

    fixed_stability: Array
    circumference_stability: Array
    maps: Array
    covariance: Array
    noise: Array


def bench_knowledge(triads: Triads) -> BenchKnowledge:
    """Of a block, without anything that is true of its flights."""
    unseen = np.zeros_like(triads.walk)
    return BenchKnowledge(
        fixed_stability=triads.fixed_stability,
        circumference_stability=triads.circumference_stability,
        maps=triads.known,
        covariance=triads.covariance,
        noise=np.stack([unseen, triads.walk, triads.instability, unseen], axis=1),
    )
