"""Eqs. (4) to (7): dead zone, its compensation and cancellation (section 2.4), on the FMU."""

import math

import numpy as np

from pyhrg.common.units import DEG, HOUR
from tests.agreement.paper.gyros import (
    DAMPING,
    DAMPING_AXIS,
    TAU,
    K,
    load_fmu,
    simulate_output_rate,
)
from tests.driving import advance

D, AXIS = 4e-3, 15 * DEG
LIMIT = D / (4 * K)
"""Half width of the dead zone, rad/s."""
INPUT = 0.6 * LIMIT
SETTLED = 5000.0
"""Twenty times 1/D, s."""
GYRO = {DAMPING: D, DAMPING_AXIS: AXIS}
CANCELLATION = "controller.cancellation."
PRINTED = 1e-3 * DEG
"""The paper's dead zone, rad/s (section 3.2)."""


def figures() -> dict[str, float]:
    """Lock-in, Eq. (5), stability of the two angles, Eq. (7), and the printed 0.001 deg/s."""
    return {**_lock_in(), **_stability(), **_cancellation(), **_printed_dead_zone()}


def _lock_in() -> dict[str, float]:
    """Where the pattern stops, and what Eq. (5) makes of it, printed and corrected."""
    with load_fmu("HRGSlow").power_on(GYRO, seed=0, start_angle=0.0) as gyro:
        begin = advance(gyro, INPUT, SETTLED)
        stopped = (advance(gyro, INPUT, 100.0) - begin) / 100
        angle = gyro.read("patternAngle")
    sine = math.sin(4 * (angle - AXIS))
    mapped = {
        "controller.biasMap.sin4": -LIMIT * math.cos(4 * AXIS),
        "controller.biasMap.cos4": LIMIT * math.sin(4 * AXIS),
    }
    compensated = simulate_output_rate({**GYRO, **mapped}, 0.0, INPUT, SETTLED, 100.0, "HRGSlow")
    return {
        "locked_output_over_input": stopped / INPUT,
        "eq5_printed_over_input": -D / 2 * sine / INPUT,
        "eq5_corrected_over_input": D / (4 * K) * sine / INPUT,
        "eq5_compensated_output_over_input": compensated / INPUT,
        "locked_cosine": math.cos(4 * (angle - AXIS)),
    }


def _stability() -> dict[str, float]:
    """How far the pattern goes in 5000 s from 0.1 deg beside each of the two rest angles."""
    asin = math.asin(INPUT / LIMIT) / 4
    rest = {"unstable": AXIS + asin, "stable": AXIS + math.pi / 4 - asin}
    moved = {}
    for name, angle in rest.items():
        with load_fmu("HRGSlow").power_on(GYRO, seed=0, start_angle=angle + 0.1 * DEG) as gyro:
            advance(gyro, INPUT, SETTLED)
            moved[f"{name}_departure_deg"] = abs(gyro.read("patternAngle") - angle) / DEG
    return moved


def _cancellation() -> dict[str, float]:
    """Half width of the dead zone that is left with a share of Eq. (7)'s force, over the whole.

    The force turns the pattern at -f/(4 w a) (Eq. 6 for the physical angle), so that Eq. (7)'s
    f = w a D sin 4(theta - theta_tau) turns it at -(D/4) sin 4(theta - theta_tau): share 1.
    """
    left = {}
    for name, share in (("none", 0.0), ("half", 0.5), ("eq7", 1.0), ("twice", 2.0)):
        force = {
            CANCELLATION + "dampingAnisotropy": share * D,
            CANCELLATION + "dampingAxis": AXIS,
        }
        angles = AXIS + np.arange(8) * math.pi / 16
        bias = [simulate_output_rate({**GYRO, **force}, float(a)) for a in angles]
        left[f"left_by_{name}_force"] = float(np.max(np.abs(bias))) / LIMIT
    return left


def _printed_dead_zone() -> dict[str, float]:
    """What a dead zone of 0.001 deg/s takes, and how long it takes to capture the pattern."""
    anisotropy = 4 * K * PRINTED
    return {
        "dead_zone_anisotropy_per_s": anisotropy,
        "dead_zone_anisotropy_percent": 100 * anisotropy * TAU,
        "dead_zone_deg_h": PRINTED / DEG * HOUR,
        "capture_time_h": 1 / anisotropy / HOUR,
    }
