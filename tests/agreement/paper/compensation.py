"""Section 3.1: what a compensation of the map leaves over the circumference, against the change at
one position, on the FMU."""

import numpy as np

from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drift import Drift, age_gyro
from ins_eval.study.gyros.makers_calibration import calibrate_gyro
from ins_eval.study.gyros.measured_gyro import MeasuredGyro, measure_gyro
from ins_eval.study.gyros.population import RAW
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.ready_devices import TABLE2
from tests.agreement.paper.gyros import load_fmu

GYROS = 9
"""Gyros of the study's population; second and eighth are a 96.1 % interval of the median."""
SEED = 1


def figures() -> dict[str, float]:
    """Stability over the circumference over that at one position."""
    fmu = load_fmu("HRGSlow")
    table2 = measure_gyro(fmu, calibrate_gyro(fmu, TABLE2, "map", SEED), BenchPlan(runs=7), SEED)
    found = {
        "compensated_table2_deg_h": table2.circumference_stability / DEG_PER_H,
        "compensated_table2_ratio": _compare(table2),
    }
    ratios: dict[str, list[float]] = {"raw": [], "compensated": [], "aged": []}
    for seed in range(SEED, SEED + GYROS):
        generator = np.random.default_rng(seed)
        built = RAW.draw(generator)
        new = calibrate_gyro(fmu, built, "map", seed)
        aged = age_gyro(new, Drift().age, generator)
        for name, device in {"raw": built, "compensated": new, "aged": aged}.items():
            ratios[name].append(_compare(measure_gyro(fmu, device, BenchPlan(), seed)))
    for name, values in ratios.items():
        ordered = np.sort(values)
        found[f"{name}_ratio"] = float(np.median(ordered))
        found[f"{name}_ratio_low"], found[f"{name}_ratio_high"] = ordered[[1, -2]].tolist()
    return found


def _compare(measured: MeasuredGyro) -> float:
    return measured.circumference_stability / measured.fixed_stability
