"""Noise of each channel, from what the believed noises say and the gyro's own records show."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.robust import robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import Observed
from pyhrg.gap.replay.thermometer import reading_steps
from pyhrg.gap.whitening.whitening import Correlated, SlowNoise

Array = NDArray[np.float64]

CLIP = 5.0
"""Second differences further out than this many deviations are no noise."""
FEW = 30
"""Second differences below which rows of a length have no noise of their own."""
RESOLVED = {
    "amplitude": 2e-8,
    "amplitude_force": 3e-9,
    "quadrature_force": 5e-9,
    "frequency_offset": 1e-6,
}
"""What replays of one gyro with sampled loops and with loops at rest agree to, SI: records without
noise are compared no closer."""
LASTING = 3.0
"""Thermal lags that the error of a coarse thermometer lasts."""
LEAST_ANGLE = 1e-10
"""Noise of an angle of which none is stated, rad: numbers with eight decimals of a degree."""


@dataclass(frozen=True)
class ChannelNoise:
    """Noise of all channels.

    angle: of the output angle, rad.
    white: standard deviations of a row of the other channels, SI, by field and the row's length, s.
    temperature: of one reading of a test's temperature log, K, by test.
    reading_steps: of these logs, K; 0 where they are finer than their noise.
    per_kelvin: how a channel follows the resonator's temperature, SI/K.
    thermal_lag: s.
    bryan_factor: as believed. Noise that turns a driven pattern is a noise of its amplitude as well
        while nothing holds it.
    """

    angle: SlowNoise
    white: Mapping[str, Mapping[float, float]]
    temperature: Mapping[str, float]
    reading_steps: Mapping[str, float]
    per_kelvin: Mapping[str, float]
    thermal_lag: float
    bryan_factor: float

    def of(self, channel: str, test: Observed) -> SlowNoise:
        """Noise of a channel in a test's rows."""
        if channel == "gyro_angle":
            return self.angle.louder(test.encoder)
        interval = test.log.interval
        white = _nearest(self.white[channel], interval)
        if channel in self.per_kelvin:
            kelvin = self.temperature.get(test.test.id, max(self.temperature.values()))
            lagged = self.per_kelvin[channel] * kelvin * np.sqrt(interval)
            lasting = self._lasting(self.per_kelvin[channel], test)
            return SlowNoise(white, lagged=lagged, lag=self.thermal_lag, correlated=lasting)
        if channel == "amplitude" and not test.log.drive_on.all():
            return SlowNoise(white, walk=2 * self.bryan_factor * self.angle.walk)
        return SlowNoise(white)

    def _lasting(self, per_kelvin: float, test: Observed) -> Correlated | None:
        """What half a step of the temperature's readings makes of a channel."""
        step = self.reading_steps.get(test.test.id, 0.0)
        if not step:
            return None
        level = per_kelvin * step / 2
        return Correlated(level, LASTING * self.thermal_lag, of_rate=False)


def believed_noise(
    believed: Device, tests: Sequence[Observed], residuals: Sequence[Mapping[str, Array]]
) -> ChannelNoise:
    """The device's own noises on its angle; the other channels' from second differences of
    residuals at rest, which nothing slow is seen in.

    Args:
        believed: the device.
        tests: observed.
        residuals: (n,) by channel, record less simulation, for each test.
    """
    white = {name: _white(name, tests, residuals) for name in RESOLVED}
    steps = reading_steps({t.test.id: t.log.temperature for t in tests})
    temperature = {
        t.test.id: max(
            _deviation([_seconds(t.log.temperature, t.rows["temperature"])]),
            steps[t.test.id] / math.sqrt(12),
        )
        for t in tests
    }
    per_kelvin = {
        "frequency_offset": abs(believed.frequency * believed.frequency_per_kelvin),
        "amplitude_force": abs(believed.decay_time_per_kelvin / believed.decay_time),
    }
    for channel, slope in per_kelvin.items():
        for interval, deviation in white[channel].items():
            those = [temperature[t.test.id] for t in tests if t.log.interval == interval]
            change = slope * float(np.median(those)) * interval / believed.thermal_lag
            white[channel][interval] = _beside(deviation, change, RESOLVED[channel])
    return ChannelNoise(
        angle_noise(believed),
        white,
        temperature,
        steps,
        per_kelvin,
        believed.thermal_lag,
        believed.bryan_factor,
    )


def _white(
    name: str, tests: Sequence[Observed], residuals: Sequence[Mapping[str, Array]]
) -> dict[float, float]:
    """Noise that comes through a loop is less in the mean over a longer row."""
    parts: dict[float, list[Array]] = {}
    for test, residual in zip(tests, residuals, strict=True):
        own = parts.setdefault(test.log.interval, [])
        own.append(_seconds(residual[name], test.rows[name]))
    every = [part for own in parts.values() for part in own]
    return {
        interval: max(
            _deviation(own if sum(map(len, own)) >= FEW else every),
            RESOLVED[name],
        )
        for interval, own in parts.items()
    }


def _nearest(by_interval: Mapping[float, float], interval: float) -> float:
    """Value of rows that are nearest in length."""
    return by_interval[min(by_interval, key=lambda known: abs(math.log(known / interval)))]


def _beside(deviation: float, step: float, least: float) -> float:
    """Noise of a row beside that of a thermometer, by which the channel moves a step a row."""
    return float(np.sqrt(max(deviation**2 - step**2 / 12, least**2)))


def angle_noise(device: Device) -> SlowNoise:
    """Noise that a device states of its output angle; counting it in steps is noise, too."""
    return SlowNoise(
        max(math.hypot(device.pickoff_noise, device.angle_quantum / math.sqrt(12)), LEAST_ANGLE),
        device.angle_random_walk,
        device.rate_random_walk,
        device.bias_instability,
    )


def _seconds(series: Array, rows: NDArray[np.bool_]) -> Array:
    """Second differences where three rows follow each other, over sqrt(6)."""
    three = rows[2:] & rows[1:-1] & rows[:-2]
    return np.asarray(np.diff(series, 2)[three] / np.sqrt(6))


def _deviation(parts: Sequence[Array]) -> float:
    """Standard deviation, those parts aside in which more than noise is seen; 0 of nothing."""
    there = [p for p in parts if len(p)]
    if not there:
        return 0.0
    typical = float(np.median([robust_deviation(p) for p in there]))
    values = np.concatenate(there)
    return float(np.std(values[np.abs(values) <= CLIP * typical]))
