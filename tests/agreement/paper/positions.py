"""The 8N-position test (section 4.1): spacing of positions, tilt of the input axis, 100 s means."""

import math
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import full_circumference, position_plans
from pyhrg.bench.bias.position.position_plans import summarize_plans
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.readings.segments import SEGMENT, read_segments
from pyhrg.common.arrays import Array
from pyhrg.common.site import EARTH_RATE, Site
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.device import Device
from tests.agreement.paper.gyros import K, load_fmu

SITE = Site()
ANISOTROPY = 4 * K * 1 * DEG_PER_H
"""Damping anisotropy of a gyro with a bias of 1 deg/h, 1/s."""
TILT = 10 * ARCSEC
PRINTED_WAVE = 0.0032 * DEG_PER_H
"""Fluctuation that the paper expects of a tilt of 10 arcsec, rad/s."""
TABLE_STEPS = {"45": 45.0, "11p25": 11.25 / K, "22p5": 22.5 / K}
"""Plans of 8 positions by name: step of the table, deg; of the pattern 12.46, 11.25, 22.5."""
STARTS = np.arange(0.0, 90.0, 0.5) * DEG


def figures() -> dict[str, float]:
    """What plans report, what the tilt does, what a segment's mean leaves out."""
    return {**_aliasing(), **_tilt(), **_tilt_confounded(), **_segments()}


def _aliasing() -> dict[str, float]:
    """Bias stability of a fourth harmonic of amplitude 1, by plan, least and most over starts."""
    device = Device(damping_anisotropy=ANISOTROPY)
    bench = Bench(load_fmu("HRGSlow"), device, step=position_plans.PROCEDURE.step)
    tests = position_plans.record(bench)
    runs = [
        read_segments(test.log, SITE, full_circumference.SETTLE, warm_up=30.0) for test in tests
    ]
    found = {}
    for plan in summarize_plans(runs):
        name = plan.name.replace(" ", "").replace("deg", "").replace(".", "p")
        found[f"least_{name}"] = float(plan.stability.min() / DEG_PER_H)
        found[f"most_{name}"] = float(plan.stability.max() / DEG_PER_H)
    return found


def _tilt() -> dict[str, float]:
    """Earth's rate on a tilted axis over a turn of the table: the paper's 0.0032 deg/h."""
    device = replace(Device(), misalignment=TILT)
    bench = Bench(load_fmu("HRGSlow"), device, step=0.1)
    plan = Plan(8, 45 * DEG * K)
    campaign = bench.campaign(bench.run(full_circumference.make_power_ons(bench, plan, 1, 1)))
    rate = full_circumference.read_runs(campaign)[0].rate
    rate_per_angle = SITE.horizontal_rate
    return {
        "tilt_amplitude_deg_h": rate_per_angle * TILT / DEG_PER_H,
        "tilt_peak_to_peak_deg_h": 2 * rate_per_angle * TILT / DEG_PER_H,
        "tilt_bench_peak_to_peak_deg_h": float(np.ptp(rate)) / DEG_PER_H,
        "tilt_equator_peak_to_peak_deg_h": 2 * EARTH_RATE * TILT / DEG_PER_H,
        "tilt_needed_peak_to_peak_arcsec": PRINTED_WAVE / (2 * rate_per_angle) / ARCSEC,
        "tilt_needed_amplitude_arcsec": PRINTED_WAVE / rate_per_angle / ARCSEC,
        "horizontal_rate_over_3600_deg_h": rate_per_angle / DEG_PER_H / 3600,
    }


def _tilt_confounded() -> dict[str, float]:
    """Share of a fourth harmonic's variance over 8 positions that a tilt explains, least and most
    over start angles; table turns after which the two are one turn apart."""
    found = {"beat_turns": 1 / (4 * K - 1), "wave_turn_deg": 360 * K, "table_turns": 1 / K}
    found["periods_a_table_turn"] = 4 * K
    table = TABLE_STEPS["45"] * DEG * np.arange(8.0)
    found["mean_kept_by_45"] = float(abs(np.mean(np.exp(4j * K * table))))
    for name, step in TABLE_STEPS.items():
        table = step * DEG * np.arange(8.0)
        shares = [_explained(table, start) for start in STARTS]
        found[f"tilt_explains_least_{name}"] = min(shares)
        found[f"tilt_explains_most_{name}"] = max(shares)
    return found


def _explained(table: Array, start: float) -> float:
    """Share of the variance of sin 4theta that a constant and once a turn explain."""
    signal = np.sin(4 * (start - K * table))
    columns = np.column_stack([np.ones_like(table), np.cos(table), np.sin(table)])
    left = signal - columns @ np.linalg.lstsq(columns, signal, rcond=None)[0]
    return float(1 - np.var(left) / np.var(signal))


def _segments() -> dict[str, float]:
    """What a mean over 100 s keeps: with the axis up the pattern creeps with Earth's rate."""
    creep = K * SITE.vertical_rate
    return {
        "creep_deg_per_h": creep / DEG * 3600,
        "creep_in_100_s_deg": creep * SEGMENT / DEG,
        "lost_in_100_s": 1 - float(np.sinc(4 * creep * SEGMENT / (2 * math.pi))),
        "random_walk_in_100_s_deg_h": 1e-4 * math.sqrt(3600 / SEGMENT),
    }
