"""Detection gain asymmetry (Actuators 14:275): found from one turn, taken out of the angle."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pyhrg.common.units import DEG, PPM
from tests.agreement.paper.gyros import K, simulate_turn

DEVIATION = 0.6 * DEG
"""Largest deviation of the pattern angle that is published, before: it is a quarter of g."""
GYRO = {"pickOff.gainMismatch": 4 * DEVIATION}
RATES = (5 * DEG, 20 * DEG, 50 * DEG, 100 * DEG)
ORDERS = (4, 8)


def figures() -> dict[str, float]:
    """Largest deviation of the pattern angle, deg, and errors of the scale factor, ppm."""
    raw = {rate: _read_turn(GYRO, rate) for rate in RATES}
    mended = {**GYRO, **raw[RATES[0]].harmonics}
    compensated = _read_turn(mended, RATES[0])
    return {
        "asymmetry_percent": 100 * GYRO["pickOff.gainMismatch"],
        "deviation_before_deg": raw[RATES[0]].deviation / DEG,
        "deviation_after_deg": compensated.deviation / DEG,
        "nonlinearity_ppm": _find_range(raw) / PPM,
        "scale_factor_slow_ppm": raw[RATES[0]].scale_factor / PPM,
        "scale_factor_expected_ppm": -(GYRO["pickOff.gainMismatch"] ** 2) / 4 / PPM,
    }


@dataclass(frozen=True)
class Reading:
    """What a turn at constant rate shows.

    harmonics: of the deviation by the angle read, rad, by the FMU's parameters.
    deviation: largest of the pattern angle from its straight line, rad.
    scale_factor: its error, relative.
    """

    harmonics: dict[str, float]
    deviation: float
    scale_factor: float


def _read_turn(parameters: Mapping[str, float], rate: float) -> Reading:
    """Four periods of the fourth harmonic; line and harmonics are fitted together."""
    turn = simulate_turn(parameters, rate, 4 * math.pi / 2 / (K * rate))
    deviation = -K * (turn.gyro_angle - rate * turn.time)
    table = [f(n * turn.pattern_angle) for n in ORDERS for f in (np.cos, np.sin)]
    columns = np.stack([*table, np.ones_like(turn.time), turn.time], 1)
    *fitted, start, slope = np.linalg.lstsq(columns, deviation, rcond=None)[0]
    names = [f"controller.scaleFactorMap.{f}{n}" for n in ORDERS for f in ("cos", "sin")]
    return Reading(
        harmonics=dict(zip(names, map(float, fitted), strict=True)),
        deviation=float(np.max(np.abs(deviation - start - slope * turn.time))),
        scale_factor=float(-slope / K / rate),
    )


def _find_range(readings: Mapping[float, Reading]) -> float:
    errors = [reading.scale_factor for reading in readings.values()]
    return max(errors) - min(errors)
