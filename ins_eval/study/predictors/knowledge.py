"""What predictors may know of the gyros of many triads before they fly."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.signals import COUNT
from ins_eval.mission_model.triads import Triads
from ins_eval.study.gyros.bench_plan import WARMER

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BenchKnowledge:
    """What a bench tells of r triads, gyro by gyro along body axes.

    fixed_stability, circumference_stability: (r, 3) rad/s;
    maps: (r, COUNT, 3) coefficients in flight as the bench expects them, from pattern angle 0: the
    fitted map, and what it gains as the gyro warms; the thermometer, the frequency, tells by how
    much. The bench sees no part of the rest;
    variance: (r, COUNT, 3) of their errors;
    noise: (r, KINDS, 3) strengths of `noise_weights.KINDS`, zero where the bench sees none.
    """

    fixed_stability: Array
    circumference_stability: Array
    maps: Array
    variance: Array
    noise: Array


def bench_knowledge(triads: Triads) -> BenchKnowledge:
    """Of a block, without anything that is true of its flights."""
    unseen = np.zeros_like(triads.walk)
    return BenchKnowledge(
        fixed_stability=triads.fixed_stability,
        circumference_stability=triads.circumference_stability,
        maps=_in_flight(triads.known, triads.rise[:, None] * triads.gain),
        variance=_in_flight(
            triads.variance, (triads.rise[:, None] / WARMER) ** 2 * triads.variance
        ),
        noise=np.stack([unseen, triads.walk, triads.instability, unseen], axis=1),
    )


def _in_flight(steady: Array, warming: Array) -> Array:
    """(r, COUNT, 3)"""
    told = np.concatenate([steady, warming], axis=1)
    rest = ((0, 0), (0, COUNT - told.shape[1]), (0, 0))
    return np.pad(told, rest)
