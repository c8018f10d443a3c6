"""Programme of a temperature test: soaks with positions and spins, and ramps between them.

The pattern turns by 22.5 deg between ramps. A pick-off gain that drifts with temperature turns the
detected angle in proportion to sin 4th; ramps at several pattern angles separate this from a bias
by the ramp itself.
"""

from collections.abc import Sequence

from pyhrg.bench.bench import Bench
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.units import DEG, MINUTE, ZERO_CELSIUS

SOAKS = (-40.0, -20.0, 0.0, 20.0, 40.0, 60.0)
"""Temperatures of the soaks, degC."""
RAMP = 1.0 / MINUTE
"""Rate of the case's temperature on a ramp, K/s."""
LAGS = 6.0
"""Duration of a soak in thermal lags; a step of 20 K has settled to 0.05 K then."""
POSITIONS = 8
PATTERN_STEP = 22.5 * DEG
SETTLE = 20.0
"""Time in a position before its first data point, s."""
TABLE_RATE = 10 * DEG
SPIN_RATE = 100 * DEG
SPIN = 70.0
"""Duration of a spin, s: more than 4 quarter turns of the pattern."""
PAIRS = 2
"""Pairs of spins in opposite directions at each soak."""


def make_programme(
    bench: Bench,
    soaks: Sequence[float] = SOAKS,
    interval: float = 1.0,
    lags: float = LAGS,
) -> Programme:
    """Programme of one power-on: up through the soaks, then down to the first in one ramp.

    Soaks are in degC, each with positions and `PAIRS` of spins in opposite directions; they last
    `lags` thermal lags of the gyro. Rows are `interval` seconds long.
    """
    course = bench.programme(interval).rest(_round_to_rows(WARM_UP, interval))
    now = bench.device.reference_temperature
    for soak in soaks:
        now = _add_ramp(course, now, soak + ZERO_CELSIUS)
        course.rest(_round_to_rows(lags * bench.device.thermal_lag, interval))
        add_positions(course, bench.device.bryan_factor)
        for _ in range(PAIRS):
            for rate in (SPIN_RATE, -SPIN_RATE):
                course.spin(rate, _round_to_rows(SPIN, interval)).rest(interval)
        course.turn(PATTERN_STEP / bench.device.bryan_factor, TABLE_RATE)
    _add_ramp(course, now, soaks[0] + ZERO_CELSIUS)
    return course


def add_positions(course: Programme, bryan_factor: float, segments: int = 1) -> None:
    """Append eight positions of the pattern, 22.5 deg apart, that the table turns it to."""
    step = course.interval
    for _ in range(POSITIONS):
        course.turn(PATTERN_STEP / bryan_factor, TABLE_RATE)
        course.rest(
            _round_to_rows(SETTLE, step) + segments * (_round_to_rows(SEGMENT, step) + step)
        )


def _add_ramp(course: Programme, begin: float, end: float) -> float:
    course.heat(end, _round_to_rows(abs(end - begin) / RAMP, course.interval))
    return end


def _round_to_rows(duration: float, interval: float) -> float:
    """Duration, s, in whole rows, at least one."""
    return max(1, round(duration / interval)) * interval
