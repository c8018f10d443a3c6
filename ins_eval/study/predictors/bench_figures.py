"""Figures that predictors may use of many triads before they fly: those that a bench measures."""

from dataclasses import dataclass

import numpy as np

from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.mission_model.signals import COUNT
from ins_eval.study.gyros.bench_plan import WARM_RISE
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class BenchFigures:
    """Figures of r triads, for the gyro along each body axis.

    Attributes:
        fixed_bias, fixed_stability, fixed_repeatability, circumference_stability: (r, 3) rad/s.
        maps: (r, COUNT, 3) coefficients in flight that the bench expects, over the pattern angle
            itself: the fitted map, and its change as the gyro warms. The resonance frequency is the
            thermometer that gives the rise of temperature. Coefficients of the other signals are
            zero.
        variance: (r, COUNT, 3) variance of their errors.
        noise: (r, 4, 3) noise coefficients, SI (`COEFFICIENT_NAMES`); zero where the bench has
            none.
    """

    fixed_bias: Array
    fixed_stability: Array
    fixed_repeatability: Array
    circumference_stability: Array
    maps: Array
    variance: Array
    noise: Array


def collect_bench_figures(triads: TriadBlock) -> BenchFigures:
    """The bench's figures of a block; nothing that is true of its flights alone."""
    unmeasured = np.zeros_like(triads.random_walk)
    rise = triads.rise[:, None]
    return BenchFigures(
        fixed_bias=triads.fixed_bias,
        fixed_stability=triads.fixed_stability,
        fixed_repeatability=triads.fixed_repeatability,
        circumference_stability=triads.circumference_stability,
        maps=_pad_coefficients(triads.fitted_map, rise * triads.map_per_kelvin),
        variance=_pad_coefficients(
            triads.map_variance, (rise / WARM_RISE) ** 2 * triads.map_variance
        ),
        noise=np.stack([unmeasured, triads.random_walk, triads.instability, unmeasured], axis=1),
    )


def _pad_coefficients(steady: Array, warming: Array) -> Array:
    """(r, COUNT, 3) coefficients of the first two signals, zero for the others."""
    measured = np.concatenate([steady, warming], axis=1)
    return np.pad(measured, ((0, 0), (0, COUNT - measured.shape[1]), (0, 0)))
