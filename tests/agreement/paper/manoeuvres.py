"""Sections 2.1 and 4.1: how far manoeuvres turn the patterns, and what the paper's gyro does to a
car's navigation, by FMUs and the nonlinear navigator."""

import numpy as np

import ins_eval
from ins_eval.study.cosimulated import sample_truth
from ins_eval.study.lead import HOURS, bench_lead, fly_lead, plan_lead
from ins_eval.study.predictors.stability_rule import DRIFT_PER_STABILITY
from pyhrg.common.units import DEG_PER_H, HOUR, NAUTICAL_MILE
from tests.agreement.paper.gyros import K, load_fmu

MISSIONS = ("straight-and-level", "ship", "car", "airliner", "aircraft")
STILL = 300.0
"""Time at rest before a mission, s."""
STEP = 0.5
"""Step of the integration of a mission's rates, s: a small part of the fourth harmonic's period."""
FLIGHTS = 6
"""Flights of the paper's gyro; smallest and largest are then a 96.9 % interval of the median."""
SEED = 1


def figures() -> dict[str, float]:
    """Variation of a fourth harmonic along missions; the car's error, promised and flown."""
    return {**_turn_patterns(), **_drive()}


def _turn_patterns() -> dict[str, float]:
    """Deviation of a fourth harmonic along two hours of a mission over that of a whole turn, rms
    over start angles, for the level gyros (rms of both) and the vertical one.

    Over a turn psi(t) of the input, the variance of sin 4(th + k psi), averaged over th, is
    (1 - |mean of exp(4 i k psi)|^2)/2.
    """
    found = {}
    for mission in MISSIONS:
        motion = ins_eval.load_trajectory(mission, 2 * HOUR, STILL)
        rate, _ = motion.rate_and_force(np.arange(0.0, 2 * HOUR, STEP) + STEP / 2)
        mean = np.mean(np.exp(4j * K * STEP * np.cumsum(rate, axis=0)), axis=0)
        share = 1 - np.abs(mean) ** 2
        name = mission.replace("-", "_")
        found[f"level_share_{name}"] = float(np.sqrt(np.mean(share[:2])))
        found[f"vertical_share_{name}"] = float(np.sqrt(share[2]))
    return found | {
        "level_factor_ship": 1 / found["level_share_ship"],
        "level_factor_straight": 1 / found["level_share_straight_and_level"],
    }


def _drive() -> dict[str, float]:
    """The gyro of Table 2, its mean taken out, in a car for an hour: what 0.01 deg/h = 1 nmi/h
    makes of the bench's two figures, and what is flown from many start angles, nmi."""
    slow, fmu = load_fmu("HRGSlow"), load_fmu("HRG")
    fixed, circumference = bench_lead(slow, SEED)
    truth = sample_truth(plan_lead())
    errors, _ = fly_lead(slow, fmu, truth, SEED, range(FLIGHTS), FLIGHTS)
    flown = np.linalg.norm(errors[:, -1], axis=-1) / NAUTICAL_MILE
    promised = DRIFT_PER_STABILITY * HOURS * HOUR / NAUTICAL_MILE
    return {
        "car_flights": float(FLIGHTS),
        "car_bench_fixed_deg_h": fixed / DEG_PER_H,
        "car_bench_circumference_deg_h": circumference / DEG_PER_H,
        "car_promised_fixed_nmi": promised * fixed,
        "car_promised_circumference_nmi": promised * circumference,
        "car_flown_median_nmi": float(np.median(flown)),
        "car_flown_least_nmi": float(flown.min()),
        "car_flown_most_nmi": float(flown.max()),
        "car_fixed_too_good": float(np.median(flown)) / (promised * fixed),
        "car_circumference_too_bad": promised * circumference / float(np.median(flown)),
    }
