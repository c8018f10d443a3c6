"""Table 2 as a device: which gyro, tested how, shows the paper's figures (section 4.1).

Each case is five times the paper's seven power-ons, held to the paper's figures by tests of two
samples: Welch's for stabilities, F for standard deviations.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, read_segments
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.device.device import AngleMap, Device
from pyhrg.device.ready_devices import TABLE2
from tests.agreement.paper.gyros import K, load_fmu
from tests.agreement.paper.table2 import NEW, ORIGINAL, Figures

POWER_ONS = 5 * RUNS
PLAN = Plan(8, 11.25 * DEG)
SHORT = 10.0
"""Averaging time of the original method where its deviations repeat as the paper's do, s."""
PURE = replace(
    TABLE2,
    damping_anisotropy=4 * K * 0.1384 * DEG_PER_H,
    bias_map=AngleMap(),
    power_on_angle=0.84 * DEG,
    power_on_scatter=0.5 * DEG,
)
"""A fourth harmonic alone, which near its zero crossing is as steep as it gets."""


@dataclass(frozen=True)
class Case:
    """How the original method was carried out, and on which gyro.

    axis_up: cosine of the input axis to local up; duration: of a run, s; average: of its points, s.
    """

    device: Device
    axis_up: float
    duration: float
    average: float


def change_random_walk(device: Device, angle_random_walk: float) -> Device:
    """A gyro with another random walk, deg/sqrt(h)."""
    return replace(device, angle_random_walk=angle_random_walk * DEG_PER_SQRT_H)


CASES: Mapping[str, Case] = {
    "file": Case(TABLE2, 0.0, 3600.0, SEGMENT),
    "pure_up": Case(change_random_walk(PURE, 4.75e-5), 1.0, 3600.0, SHORT),
    "pure_short": Case(change_random_walk(PURE, 2e-6), 1.0, 415.0, SHORT),
    "pure_east": Case(change_random_walk(PURE, 4.5e-5), 0.0, 3600.0, SHORT),
    "flat_up": Case(change_random_walk(TABLE2, 4.6e-5), 1.0, 3600.0, SHORT),
}
"""The device file under the bench's own tests; then what a pure fourth harmonic can do, and what
one with an eighth can."""


def figures() -> dict[str, float]:
    """Figures of the original method and of the new one for each case, with their chances."""
    new = {device: run_new_method(device) for device in (TABLE2, PURE)}
    found: dict[str, float] = {}
    for name, case in CASES.items():
        fresh = new[PURE if name.startswith("pure") else TABLE2]
        for method, test, paper in (
            ("original", run_original_method(case), ORIGINAL),
            ("new", fresh, NEW),
        ):
            found |= {f"{name}_{method}_{k}": v for k, v in compare_with_paper(test, paper).items()}
        earth = case.device.site.vertical_rate / DEG_PER_H
        found[f"{name}_original_mean"] += earth * case.axis_up
        found[f"{name}_new_mean"] += earth
    return found


def run_original_method(case: Case) -> Figures:
    """The pattern left where it is powered on, deg/h."""
    bench = Bench(load_fmu("HRGSlow"), case.device, step=0.1)
    course = bench.programme().attitude(case.axis_up).rest(WARM_UP + case.duration)
    power_ons = [PowerOn(f"original_{n}", fixed_position.KIND, course) for n in range(POWER_ONS)]
    return _figures(bench, power_ons, case.average, settle=0.0)


def run_new_method(device: Device) -> Figures:
    """8 positions, 11.25 deg of pattern apart, three 100 s means each, deg/h."""
    bench = Bench(load_fmu("HRGSlow"), device, step=0.1)
    power_ons = full_circumference.make_power_ons(bench, PLAN, POWER_ONS)
    return _figures(bench, power_ons, SEGMENT, full_circumference.SETTLE)


def _figures(bench: Bench, power_ons: list[PowerOn], average: float, settle: float) -> Figures:
    rates = [
        read_segments(test.log, bench.device.site, settle, average, warm_up=WARM_UP).rate
        / DEG_PER_H
        for test in bench.run(power_ons)
    ]
    return Figures(
        np.array([np.mean(rate) for rate in rates]),
        np.array([np.std(rate, ddof=1) for rate in rates]),
    )


def compare_with_paper(test: Figures, paper: Figures) -> dict[str, float]:
    """Figures of a test, and the chance that it and the paper's differ as much as they do."""
    welch = stats.ttest_ind(test.deviations, paper.deviations, equal_var=False)
    return {
        "mean": float(np.mean(test.means)),
        "stability": test.stability,
        "stability_chance": float(welch.pvalue),
        "repeatability": test.repeatability,
        "repeatability_chance": _variance_chance(test.means, paper.means),
        "scatter": test.scatter,
        "scatter_chance": _variance_chance(test.deviations, paper.deviations),
    }


def _variance_chance(ours: Array, papers: Array) -> float:
    """Two-sided F test of two variances."""
    ratio = np.var(papers, ddof=1) / np.var(ours, ddof=1)
    below = stats.f.cdf(ratio, len(papers) - 1, len(ours) - 1)
    return float(2 * min(below, 1 - below))
