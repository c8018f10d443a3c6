"""Course of a temperature test: soaks with positions and spins, ramps between them.

Each ramp finds the pattern 22.5 deg further on: a gain that drifts with temperature turns the
detected angle, in proportion to sin 4th, and only so is it told from a bias of the ramp itself.
"""

from collections.abc import Sequence

from pyhrg.bench.bench import Bench
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.units import DEG, MINUTE, ZERO_CELSIUS

SOAKS = (-40.0, -20.0, 0.0, 20.0, 40.0, 60.0)
"""Temperatures, degC."""
RAMP = 1.0 / MINUTE
"""K/s."""
LAGS = 6.0
"""Soak, in thermal lags: 20 K are 0.05 K then."""
POSITIONS = 8
PATTERN_STEP = 22.5 * DEG
SETTLE = 20.0
"""Time in a position before its first data point, s."""
TABLE_RATE = 10 * DEG
SPIN_RATE = 100 * DEG
SPIN = 70.0
"""Time at the rate of a spin, s: 4 quarter turns of the pattern and more."""
PAIRS = 2


def programme(
    bench: Bench,
    soaks: Sequence[float] = SOAKS,
    interval: float = 1.0,
    lags: float = LAGS,
    pairs: int = PAIRS,
) -> Programme:
    """Up through the soaks, positions and spins at each, then back down in one ramp."""
    course = bench.programme(interval).rest(_whole(WARM_UP, interval))
    now = bench.device.reference_temperature
    for soak in soaks:
        now = _ramp(course, now, soak + ZERO_CELSIUS)
        course.rest(_whole(lags * bench.device.thermal_lag, interval))
        positions(course, bench.device.bryan_factor)
        for _ in range(pairs):
            for rate in (SPIN_RATE, -SPIN_RATE):
                course.spin(rate, _whole(SPIN, interval)).rest(interval)
        course.turn(PATTERN_STEP / bench.device.bryan_factor, TABLE_RATE)
    _ramp(course, now, soaks[0] + ZERO_CELSIUS)
    return course


def positions(course: Programme, bryan_factor: float, segments: int = 1) -> None:
    """Eight positions of the pattern, 22.5 deg apart, moved by the table."""
    step = course.interval
    for _ in range(POSITIONS):
        course.turn(PATTERN_STEP / bryan_factor, TABLE_RATE)
        course.rest(_whole(SETTLE, step) + segments * (_whole(SEGMENT, step) + step))


def _ramp(course: Programme, begin: float, end: float) -> float:
    course.heat(end, _whole(abs(end - begin) / RAMP, course.interval))
    return end


def _whole(duration: float, interval: float) -> float:
    """Duration in whole rows, at least one."""
    return max(1, round(duration / interval)) * interval
