"""Whether a resonator had settled to the case's temperature before its log begins."""

import numpy as np

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log

MIN_DEPARTURE = 1.0
"""Departure of the first reading from the reference temperature, K, above which a log may begin
with a settled resonator. Chosen: five tolerances of a thermometer's offset; below it the offset
says the same."""
MAX_POWER_RATIO = 0.25
"""Largest power of the frequency's residual with a settled resonator, over that with one that
starts at the reference temperature, at which the log begins so. Chosen."""


def is_soaked(
    log: Log, temperatures: Array, nominal: Device, least_departure: float = MIN_DEPARTURE
) -> bool:
    """Whether the loop frequency shows a resonator that was at the case's temperature when the log
    began, and not at the reference temperature. The temperatures are (n + 1,) of the case at the
    rows' bounds, K; where the first departs by less than the least departure, the log says nothing
    (docs/methods/replay.md, "Start temperature")."""
    departure = float(temperatures[0]) - nominal.reference_temperature
    rows = np.isfinite(log.frequency_offset) & log.is_driven
    if abs(departure) < least_departure or not rows.any():
        return False
    settled = follow_with_lag(temperatures, log.interval, nominal.thermal_lag)[1:]
    cold = settled - departure * np.exp(-log.time / nominal.thermal_lag)
    slope = nominal.frequency * nominal.frequency_per_kelvin
    powers = [
        float(np.var((log.frequency_offset - slope * warmth)[rows])) for warmth in (settled, cold)
    ]
    return powers[0] < MAX_POWER_RATIO * powers[1]
