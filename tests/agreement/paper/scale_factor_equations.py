"""Eqs. (2) and (3): scale factor over the circumference (sections 1.2, 4.2), on the FMU."""

import math

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from tests.agreement.paper.gyros import DAMPING, K, Turn, simulate_turn

GAIN, NON_ORTHOGONALITY = "pickOff.gainMismatch", "pickOff.nonOrthogonality"
SMALL = 1e-3
COARSE = 1e-2
RATE, FAST = 5 * DEG, 100 * DEG
"""Rates of methods A and B (section 4.2), rad/s."""
PERIOD = math.pi / 2 / (K * RATE)
"""Period of the fourth harmonic at 5 deg/s, s."""
PRINTED = 2e-5
"""Scale-factor error that the paper reports at one position."""


def figures() -> dict[str, float]:
    """Phase of each error, mean over a turn, and what both methods see."""
    gain, skew = _harmonic({GAIN: SMALL}), _harmonic({NON_ORTHOGONALITY: SMALL})
    return {
        "gain_cos4": gain.real / SMALL,
        "gain_sin4": gain.imag / SMALL,
        "skew_cos4": skew.real / SMALL,
        "skew_sin4": skew.imag / SMALL,
        **_printed_ripple(),
        **_mean_over_a_turn(),
        **_bias_in_method_a(),
        "period_5_deg_s": PERIOD,
        "table_turns_a_period": PERIOD * RATE / (2 * math.pi),
        "frequency_100_deg_s_Hz": FAST / RATE / PERIOD,
        "kept_of_ripple_0p3_s": _kept(0.3),
        "kept_of_ripple_1_s": _kept(1.0),
    }


def _harmonic(parameters: dict[str, float]) -> complex:
    """Fourth harmonic c + is of the relative rate error, c cos 4theta + s sin 4theta; half the
    sum of both directions, so that bias falls out."""
    found = []
    for rate in (RATE, -RATE):
        turn = simulate_turn(parameters, rate, round(2 * PERIOD, 1))
        error = np.diff(turn.gyro_angle) / np.diff(turn.time) / rate - 1
        angle = (turn.pattern_angle[1:] + turn.pattern_angle[:-1]) / 2
        found.append(_fitted(angle, error))
    return sum(found) / 2


def _fitted(angle: Array, values: Array) -> complex:
    """c + is of the least-squares mean + c cos 4theta + s sin 4theta."""
    columns = np.column_stack([np.ones_like(angle), *_waves(angle)])
    _, cosine, sine = np.linalg.lstsq(columns, values, rcond=None)[0]
    return complex(cosine, sine)


def _waves(angle: Array) -> tuple[Array, Array]:
    return np.cos(4 * angle), np.sin(4 * angle)


def _printed_ripple() -> dict[str, float]:
    """What a rate error of 2e-5 is in angle, and what is left of it over ten table turns.

    d cos 4theta in rate is (d/4) sin 4theta of the pattern, d/4k of the input.
    """
    ripple = PRINTED / (4 * K)
    return {
        "ripple_pattern_arcsec": PRINTED / 4 / ARCSEC,
        "ripple_input_arcsec": ripple / ARCSEC,
        "mean_over_10_turns": 2 * ripple / (10 * 2 * math.pi),
    }


def _mean_over_a_turn() -> dict[str, float]:
    """Scale factor over whole periods of a gyro with a hundred times the usual error, half the
    sum of both directions, less that of the ideal gyro (its hold, -(Ts/2)/tau)."""
    mean = [_whole_turns(parameters) for parameters in ({GAIN: COARSE}, {})]
    return {
        "coarse_mean": mean[0] - mean[1],
        "coarse_mean_over_square": (mean[0] - mean[1]) / COARSE**2,
    }


def _whole_turns(parameters: dict[str, float]) -> float:
    """Mean relative rate error over 8 periods of the pattern."""
    errors = []
    for rate in (RATE, -RATE):
        turn = simulate_turn(parameters, rate, 520.0)
        wanted = turn.pattern_angle[0] - 8 * math.pi / 2 * np.sign(rate)
        order = np.argsort(turn.pattern_angle)
        gyro, time = (
            np.interp(wanted, turn.pattern_angle[order], values[order])
            for values in (turn.gyro_angle, turn.time)
        )
        errors.append((gyro - turn.gyro_angle[0]) / (time - turn.time[0]) / rate - 1)
    return float(np.mean(errors))


def _bias_in_method_a() -> dict[str, float]:
    """Method A on a gyro with perfect pick-offs and a bias of 1 deg/h: one direction shows a
    scale-factor error, half the sum of both shows none."""
    bias = 1 * DEG_PER_H
    found = {}
    for rate in (RATE, -RATE):
        turn = simulate_turn({DAMPING: 4 * K * bias}, rate, round(PERIOD, 1))
        found[rate] = _ripple(turn)
    return {
        "bias_over_rate_5_deg_s": bias / RATE,
        "bias_over_rate_100_deg_s": bias / FAST,
        "method_a_one_direction": abs(found[RATE]),
        "method_a_both_directions": abs(found[RATE] + found[-RATE]) / 2,
    }


def _ripple(turn: Turn) -> complex:
    """Fourth harmonic c + is of the relative rate error, from the angle (method A): line and
    harmonic fitted together, as one period alone doesn't keep them apart."""
    columns = np.column_stack([np.ones_like(turn.time), turn.time, *_waves(turn.pattern_angle)])
    *_, cosine, sine = np.linalg.lstsq(columns, turn.gyro_angle, rcond=None)[0]
    return 4 * K * complex(-sine, cosine)


def _kept(average: float) -> float:
    """Share of the ripple at 100 deg/s that a mean over `average` s leaves."""
    return float(np.sinc(FAST / RATE / PERIOD * average))
