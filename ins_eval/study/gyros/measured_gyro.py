"""Results of the bench for one gyro: stabilities, maps, noise."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.pattern_drift import TURNING_TERMS
from ins_eval.study.gyros.bench_maps import fit_bias_maps, fit_scale_maps
from ins_eval.study.gyros.bench_plan import WARM_RISE, BenchPlan, record_campaign
from ins_eval.study.gyros.true_maps import soak_gyro
from pyhrg.bench.bias.bias_test import BiasTest
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.procedure import require_tests
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign

SHORT_ROWS, LONG_ROWS = 1, 25
"""Two spacings of 1 s readings that separate the noise of a reading from the random walk; both are
short enough that flicker noise is negligible. Chosen."""
FLICKER_FLOOR = np.sqrt(2 * np.log(2) / np.pi)
"""Ratio of flicker noise's Allan deviation to its coefficient (IEEE Std 952)."""


@dataclass(frozen=True)
class MeasuredGyro:
    """Results of the bench for one gyro, SI.

    Attributes:
        fixed_bias: mean bias at one position over the power-ons, rad/s.
        fixed_stability: in-run bias stability at that position, rad/s.
        fixed_repeatability: standard deviation between power-ons of the mean bias at that position,
            rad/s.
        circumference_stability: bias stability over all positions, rad/s.
        fitted_map: (2 TERMS,) mean over the power-ons.
        map_per_kelvin: (2 TERMS,) change of the map per kelvin.
        map_variance: (2 TERMS,) variance of the errors of the map's coefficients in another
            power-on. It is the scatter over power-ons, pooled in two groups of terms for bias and
            scale factor each: mean and fourth harmonic, which power-ons change, and the others.
        random_walk: angle random walk, rad/sqrt(s).
        instability: coefficient of the flicker noise at 100 s, rad/s.
    """

    fixed_bias: float
    fixed_stability: float
    fixed_repeatability: float
    circumference_stability: float
    fitted_map: Array
    map_per_kelvin: Array
    map_variance: Array
    random_walk: float
    instability: float


def measure_gyro(fmu: GyroFmu, device: Device, plan: BenchPlan, seed: int) -> MeasuredGyro:
    """The bench's results for a gyro; arguments as `record_tests`."""
    return evaluate_campaigns(*record_tests(fmu, device, plan, seed))


def record_tests(
    fmu: GyroFmu, device: Device, plan: BenchPlan, seed: int
) -> tuple[Campaign, Campaign]:
    """Records of the three tests, and of the two map tests at `WARM_RISE`.

    Args:
        fmu: `HRGSlow`.
        plan: length of the tests; two power-ons or more.
        seed: seed of the tests' noise, from 0.
    """
    soaked, short = soak_gyro(device, WARM_RISE), replace(plan, runs=1)
    warm = record_campaign(fmu, soaked, short, seed + 1, fixed=False)
    return record_campaign(fmu, device, plan, seed), warm


def evaluate_campaigns(tests: Campaign, warm: Campaign) -> MeasuredGyro:
    """Results from the records of the three tests, and of the two map tests at `WARM_RISE`.

    Raises:
        BenchError: a test is missing or incomplete.
    """
    fixed = fixed_position.read_runs(tests)
    at_rest = BiasTest(fixed)
    scale = fit_scale_maps(tests)
    bias = fit_bias_maps(tests, scale.mean(axis=0))
    fitted = np.concatenate([bias.mean(axis=0), scale.mean(axis=0)])
    walk = _estimate_random_walk(tests)
    return MeasuredGyro(
        fixed_bias=at_rest.bias,
        fixed_stability=at_rest.stability,
        fixed_repeatability=at_rest.repeatability,
        circumference_stability=full_circumference.measure_bias(tests).stability,
        fitted_map=fitted,
        map_per_kelvin=_estimate_warming(fitted, warm),
        map_variance=np.concatenate([_pool_scatter(bias), _pool_scatter(scale)]),
        random_walk=walk,
        instability=_estimate_instability([run.rate for run in fixed], walk),
    )


def _estimate_warming(cool: Array, warm: Campaign) -> Array:
    scale = fit_scale_maps(warm).mean(axis=0)
    bias = fit_bias_maps(warm, scale).mean(axis=0)
    return (np.concatenate([bias, scale]) - cool) / WARM_RISE


def _pool_scatter(values: Array) -> Array:
    """(TERMS,) variance of another power-on's coefficients about the mean of these (runs, TERMS),
    pooled over groups of terms."""
    pooled = np.empty(TERMS)
    moved = np.isin(np.arange(TERMS), TURNING_TERMS)
    for group in (moved, ~moved):
        pooled[group] = np.var(values[:, group], axis=0, ddof=1).mean() * (1 + 1 / len(values))
    return pooled


def _estimate_random_walk(tests: Campaign) -> float:
    """Angle random walk N, rad/sqrt(s). Second differences of the angle over a time t have the
    variance 6 s^2 + 2 N^2 t, with s^2 the variance of a reading; t is `SHORT_ROWS` and `LONG_ROWS`
    readings."""
    variances = []
    for rows in (SHORT_ROWS, LONG_ROWS):
        logs = [test.log for test in require_tests(tests, fixed_position.KIND)]
        angles = [log.gyro_angle[round(WARM_UP / log.interval) :: rows] for log in logs]
        variances.append(np.mean([np.mean(np.diff(angle, 2) ** 2) for angle in angles]))
    duration = (LONG_ROWS - SHORT_ROWS) * logs[0].interval
    return float(np.sqrt(max(0.0, variances[1] - variances[0]) / (2 * duration)))


def _estimate_instability(runs: Sequence[Array], walk: float) -> float:
    """Flicker coefficient, rad/s, from the variance of 100 s means beyond that of the random
    walk."""
    variance = float(np.mean([np.mean(np.diff(rates) ** 2) / 2 for rates in runs]))
    return float(np.sqrt(max(0.0, variance - walk**2 / SEGMENT)) / FLICKER_FLOOR)
