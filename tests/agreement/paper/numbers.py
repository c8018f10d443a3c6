"""Numbers of sections 0, 1.2, 2.3 and 1.1 that a closed form gives."""

import math

import numpy as np
from scipy import integrate

from pyhrg.common.site import Site
from pyhrg.common.units import DEG, DEG_PER_H, HOUR, NAUTICAL_MILE
from tests.agreement.paper.gyros import TAU, K, load_fmu
from tests.driving import advance

MOVED = 0.1
"""What the pattern moves in two hours (section 1.2), rad."""
EARTH_RADIUS = 6371e3
SCHULER = math.sqrt(9.80665 / EARTH_RADIUS)
"""rad/s."""
PRINTED_RATIO = 0.7072 / 0.0288
FIRST, FULL = 0.05, 1.0
"""Amplitudes of a start-up in two stages."""


def figures() -> dict[str, float]:
    """Section by section."""
    return {**_stability_at_one_position(), **_navigation(), **_forces(), **_start_up()}


def _deviation(harmonic: int, start: float) -> float:
    """Standard deviation of sin(harmonic x) over x from start to start + 0.1 rad."""

    def mean(power: int) -> float:
        return integrate.quad(lambda x: math.sin(harmonic * x) ** power, start, start + MOVED)[0]

    return math.sqrt(mean(2) / MOVED - (mean(1) / MOVED) ** 2)


def _stability_at_one_position() -> dict[str, float]:
    """Section 1.2: a bias of amplitude 1 deg/h while the pattern moves 0.1 rad, and over a turn."""
    starts = np.linspace(0.0, math.pi / 2, 721)
    fourth = np.array([_deviation(4, start) for start in starts])
    turn, rms = math.sqrt(0.5), math.sqrt(float(np.mean(fourth[:-1] ** 2)))
    return {
        "moved_in_2_h_rad": K * Site().vertical_rate * 2 * HOUR,
        "deviation_first_harmonic": _deviation(1, 0.0),
        "deviation_ramp": MOVED / math.sqrt(12),
        "deviation_fourth_from_0": float(fourth[0]),
        "deviation_fourth_most": float(fourth.max()),
        "deviation_fourth_least": float(fourth.min()),
        "deviation_fourth_rms": rms,
        "deviation_turn": turn,
        "deviation_turn_7200": math.sqrt(7200 / 7199 / 2),
        "ratio_printed": PRINTED_RATIO,
        "ratio_least": turn / float(fourth.max()),
        "ratio_rms": turn / rms,
        "ratio_most": turn / float(fourth.min()),
    }


def _navigation() -> dict[str, float]:
    """Section 0: position error by a constant bias of a level gyro, eps R (t - sin(w t)/w).

    Section 2.1: of the vertical gyro, whose drift of heading makes Earth's rate a growing bias of
    the east gyro: eps W_E cos L R (t^2/2 - (1 - cos(w t))/w^2).
    """

    def miles(bias: float, time: float) -> float:
        drift = time - math.sin(SCHULER * time) / SCHULER
        return bias * DEG_PER_H * EARTH_RADIUS * drift / NAUTICAL_MILE

    def vertical_miles(time: float) -> float:
        drift = time**2 / 2 - (1 - math.cos(SCHULER * time)) / SCHULER**2
        return 0.01 * DEG_PER_H * Site().horizontal_rate * EARTH_RADIUS * drift / NAUTICAL_MILE

    return {
        "vertical_after_1_h_nmi": vertical_miles(HOUR),
        "vertical_after_2_h_nmi": vertical_miles(2 * HOUR),
        "mean_slope_nmi_h": 0.01 * DEG_PER_H * EARTH_RADIUS * HOUR / NAUTICAL_MILE,
        "after_1_h_nmi": miles(0.01, HOUR),
        "after_2_h_nmi": miles(0.01, 2 * HOUR),
        "two_gyros_after_1_h_nmi": math.sqrt(2) * miles(0.01, HOUR),
        "two_gyros_after_2_h_nmi": math.sqrt(2) * miles(0.01, 2 * HOUR),
        "two_gyros_0p1_after_1_h_nmi": math.sqrt(2) * miles(0.1, HOUR),
    }


def _forces() -> dict[str, float]:
    """Sections 1.1 and 2.3: force over the one that holds the amplitude, a/tau.

    Rebalance of W takes a growth of 2kW; from 0 to a within T takes a/tau / (1 - exp(-T/tau)).
    """
    start_up = 1 / (1 - math.exp(-10 / TAU))
    return {
        "force_rebalance_10_deg_s": 2 * K * 10 * DEG * TAU,
        "force_full_in_10_s": start_up,
        "force_first_in_1_s": FIRST / (1 - math.exp(-1 / TAU)),
        "force_full_in_1_s": 1 / (1 - math.exp(-1 / TAU)),
        "rebalance_range_of_10_s_start_deg_s": start_up / (2 * K * TAU) / DEG,
        "noise_at_first_amplitude": 1 / FIRST,
    }


def _start_up() -> dict[str, float]:
    """Section 2.3's two stages on the FMU, from 1 % of the amplitude, with a drive that has just
    the force for 10 s."""
    parameters = {
        "startAmplitude": 0.01,
        "controller.startUp.firstAmplitude": FIRST,
        "drive.authority": 45.5 / TAU,
    }
    valid, full = math.nan, math.nan
    with load_fmu().power_on(parameters, seed=0, start_angle=0.3) as gyro:
        while math.isnan(full):
            advance(gyro, 0.0, 0.01)
            if math.isnan(valid) and gyro.read("valid") == 1:
                valid = gyro.time
            if gyro.read("amplitude") > 0.99 * FULL:
                full = gyro.time
    return {"valid_after_s": valid, "full_amplitude_after_s": full}
