"""What the bench knows of a gyro: nothing that it did not measure."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import TERMS, GyroMap
from ins_eval.mission_model.pattern_drift import TURNING
from ins_eval.study.gyros.bench_maps import bias_maps, scale_maps
from ins_eval.study.gyros.bench_plan import WARMER, BenchPlan, campaign
from ins_eval.study.gyros.true_maps import soaked
from pyhrg.bench.bias.bias_test import bias_test
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.procedure import tests_of
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]

SHORT, LONG = 1, 25
"""Rows, of 1 s, that tell the noise of readings from the random walk, before flicker shows."""
FLOOR = np.sqrt(2 * np.log(2) / np.pi)
"""Allan deviation of flicker noise over its coefficient (IEEE Std 952)."""


@dataclass(frozen=True)
class Knowledge:
    """Of one gyro, SI.

    fixed_stability, circumference_stability: bias stability at one position and over all, rad/s;
    map: mean over the power-ons; gain: what it gains per K;
    variance: (2 TERMS,) of the errors of the map's coefficients in another power-on: scatter over
    power-ons, pooled over the terms that power-ons move, mean and fourth harmonic, and over the
    others, of the bias and of the scale factor;
    walk: angle random walk, rad/sqrt(s); instability: flicker beyond it at 100 s, rad/s.
    """

    fixed_stability: float
    circumference_stability: float
    map: GyroMap
    gain: GyroMap
    variance: Array
    walk: float
    instability: float


def knowledge(fmu: GyroFmu, device: Device, plan: BenchPlan, seed: int) -> Knowledge:
    """Bench a gyro.

    Args:
        fmu: `HRGSlow`.
        device: calibrated.
        plan: of the bench.
        seed: of the tests' noise, from 0.

    Raises:
        ValueError: a plan of a single power-on, which shows no scatter.
    """
    if plan.runs < 2:
        raise ValueError(f"found {plan.runs} power-on of each test, expected 2 or more")
    warm = campaign(fmu, soaked(device, WARMER), replace(plan, runs=1), seed + 1, fixed=False)
    return known_from(campaign(fmu, device, plan, seed), warm)


def known_from(tests: Campaign, warm: Campaign) -> Knowledge:
    """What a campaign of the three tests tells, and one of the maps' two that is `WARMER`.

    Raises:
        BenchError: one is missing, or not what it must be.
    """
    fixed = fixed_position.runs_of(tests)
    scale = scale_maps(tests)
    bias = bias_maps(tests, scale.mean(axis=0))
    found = GyroMap(bias.mean(axis=0), scale.mean(axis=0))
    walk = _walk(tests)
    return Knowledge(
        fixed_stability=bias_test(fixed).stability,
        circumference_stability=full_circumference.measured(tests).stability,
        map=found,
        gain=_gain(found, warm),
        variance=np.concatenate([_scatter(bias), _scatter(scale)]),
        walk=walk,
        instability=_instability([run.rate for run in fixed], walk),
    )


def _gain(cool: GyroMap, warm: Campaign) -> GyroMap:
    scale = scale_maps(warm).mean(axis=0)
    bias = bias_maps(warm, scale).mean(axis=0)
    return GyroMap((bias - cool.bias) / WARMER, (scale - cool.scale) / WARMER)


def _scatter(values: Array) -> Array:
    """(TERMS,) variance of one more power-on (runs, terms) less their mean, pooled."""
    pooled = np.empty(TERMS)
    moved = np.isin(np.arange(TERMS), TURNING)
    for group in (moved, ~moved):
        pooled[group] = np.var(values[:, group], axis=0, ddof=1).mean() * (1 + 1 / len(values))
    return pooled


def _walk(tests: Campaign) -> float:
    """Angle random walk, rad/sqrt(s): second differences of the angle over `SHORT` and `LONG` rows
    have the variance 6 s^2 + 2 N^2 t, s^2 that of a reading."""
    variances = []
    for rows in (SHORT, LONG):
        logs = [test.log for test in tests_of(tests, fixed_position.KIND)]
        angles = [log.gyro_angle[round(WARM_UP / log.interval) :: rows] for log in logs]
        variances.append(np.mean([np.mean(np.diff(angle, 2) ** 2) for angle in angles]))
    duration = (LONG - SHORT) * logs[0].interval
    return float(np.sqrt(max(0.0, variances[1] - variances[0]) / (2 * duration)))


def _instability(runs: Sequence[Array], walk: float) -> float:
    """Flicker coefficient, rad/s, that the 100 s means show beyond the random walk."""
    variance = float(np.mean([np.mean(np.diff(rates) ** 2) / 2 for rates in runs]))
    return float(np.sqrt(max(0.0, variance - walk**2 / SEGMENT)) / FLOOR)
