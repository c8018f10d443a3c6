"""Noise of all channels of a campaign: what it is in a test, and in its rows."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.gap.replay.inputs.thermometer import SLOPE_TIME
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel, whiten

THERMOMETER_CORRELATION = 3.0
"""Correlation time of a coarse thermometer's rounding error, in thermal lags. Chosen."""


@dataclass(frozen=True)
class CampaignNoise:
    """Noise of all channels in all tests of a campaign.

    angle: of the output angle, rad.
    white_noise: standard deviations of one row of the other channels, SI, by field and row
        length, s.
    temperature: standard deviation of one reading of a test's temperature log, K, by test.
    reading_steps: quantization steps of these logs, K; 0 where they are finer than their noise.
    per_kelvin: sensitivity of a channel to the resonator's temperature, SI/K.
    wander: random walk of these channels in tests at a steady temperature, SI/sqrt(s).
    thermal_lag: time constant from case to resonator, s.
    thermometer_lag: of the thermometer behind the case, s.
    bryan_factor: of the nominal device. Noise that turns a driven pattern is also a noise of the
        amplitude while the drive is off.
    """

    angle: NoiseModel
    white_noise: Mapping[str, Mapping[float, float]]
    temperature: Mapping[str, float]
    reading_steps: Mapping[str, float]
    per_kelvin: Mapping[str, float]
    wander: Mapping[str, float]
    thermal_lag: float
    thermometer_lag: float
    bryan_factor: float

    def get_model(self, channel: str, test: ObservedTest, rows: Mask | None = None) -> NoiseModel:
        """Noise of a channel in a test, or some rows (docs/methods/whitening.md, Eqs. 13-17b)."""
        return adapt_to_rows(self.get_own_model(channel, test), channel, test, rows)

    def get_own_model(self, channel: str, test: ObservedTest) -> NoiseModel:
        """Noise of a channel that is the same in all rows of a test."""
        if channel == "gyro_angle":
            return self.angle
        interval = test.log.interval
        nearest = min(self.white_noise[channel], key=lambda known: abs(math.log(known / interval)))
        white = self.white_noise[channel][nearest]
        if channel in self.per_kelvin:
            return self._follow_thermometer(channel, test, white)
        if channel == "amplitude" and test.log.is_free.any():
            walk = 2 * self.bryan_factor * self.angle.angle_random_walk
            return NoiseModel(white, angle_random_walk=walk)
        return NoiseModel(white)

    def _follow_thermometer(self, channel: str, test: ObservedTest, white: float) -> NoiseModel:
        """White noise of a row, and what the thermometer's noise and rounding add to it (Eqs. 15
        to 16)."""
        name, lag = test.test.id, self.thermal_lag
        kelvin = self.temperature.get(name, max(self.temperature.values()))
        slope = self.per_kelvin[channel]
        density = slope * kelvin * math.sqrt(test.log.interval)
        step = self.reading_steps.get(name, 0.0)
        rounding = slope * self._lasting_error(step) if step else 0.0
        if test.inputs.is_steady:
            walk = rounding * math.sqrt(2 / (THERMOMETER_CORRELATION * lag))
            mean = slope * kelvin / math.sqrt(max(1, test.rows["temperature"].sum()))
            return NoiseModel(
                white,
                lagged=lag * min(self.wander[channel], math.hypot(density / lag, walk)),
                lag=lag,
                offset=math.hypot(mean, rounding),
                offset_lag=0.0 if test.inputs.is_soaked else lag,
            )
        lasting = []
        if rounding:
            lasting.append(CorrelatedNoise(rounding, THERMOMETER_CORRELATION * lag, of_rate=False))
        if self.thermometer_lag:
            time = max(SLOPE_TIME, test.log.interval)
            level = density * self.thermometer_lag / lag / math.sqrt(2 * time)
            lasting.append(CorrelatedNoise(level, time, of_rate=False))
        return NoiseModel(white, lagged=density, lag=lag, correlated=tuple(lasting))

    def _lasting_error(self, step: float) -> float:
        """Rounding error that lasts for many readings of a thermometer with this step, K (Eq. 16).
        The noise before rounding is that of the quietest test: no test is sure to have more."""
        coarse = [self.temperature[name] for name, own in self.reading_steps.items() if own]
        variance = max(min(coarse) ** 2 - step**2 / 12, 0.0)
        return step / 2 * math.exp(-2 * math.pi**2 * variance / step**2)


def adapt_to_rows(
    noise: NoiseModel, channel: str, test: ObservedTest, rows: Mask | None = None
) -> NoiseModel:
    """A channel's noise in the rows of a test: with the readings' own noise, and grown where the
    amplitude is small. The amplitude walks once the drive is off (Eqs. 13, 17 and 17a)."""
    levels, growth = (
        values if values is None or rows is None else values[rows]
        for values in (test.reading_noise.get(channel), test.noise_growth.get(channel))
    )
    white_growth = None if channel == "amplitude" else growth
    return replace(noise, reading_noise=levels, white_growth=white_growth, walk_growth=growth)


def whiten_finite(noise: NoiseModel, channel: str, test: ObservedTest, series: Array) -> Array:
    """(m, p) rows of (n, p) series of a channel in a test, whitened with its noise before it is
    adapted to rows; NaN in the first column is left out."""
    rows = np.isfinite(series[:, 0])
    steps = np.diff(test.log.time[rows], prepend=0.0)
    return whiten(series[rows], steps, adapt_to_rows(noise, channel, test, rows)).series
