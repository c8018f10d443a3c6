"""Noise of every channel, from the nominal device's stated noise and from the records."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.inputs import list_measured_temperatures
from pyhrg.gap.replay.inputs.thermometer import estimate_reading_steps
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.reading_noise import MIN_DIFFERENCES, OUTLIER_SIGMA
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.wander import estimate_wander
from pyhrg.gap.whitening.whitening import NoiseModel

REPLAY_RESOLUTION = {
    "amplitude": 2e-8,
    "amplitude_force": 3e-9,
    "quadrature_force": 5e-9,
    "frequency_offset": 1e-6,
}
"""Smallest noise that a channel is given, SI: the difference of two replays of one device, with
sampled loops and with quasi-steady loops (tests/pyhrg/gap/replay/test_simulation.py)."""
SETTLED_PHASE = 4.0
"""Shortest mean of a force, in time constants of its loop, that has all of the force noise. Chosen:
second differences of such means see 1.13 of its variance (docs/methods/whitening.md, Eq. 22)."""
THIRD_DIFFERENCE = np.array([20.0, -30.0, 12.0, -2.0]) / 6
"""Weights of the autocovariance at lags of 0 to 3 rows in the variance of third differences over
sqrt(6). Derived: 1, -3, 3, -1 correlated with itself."""
MIN_ANGLE_NOISE = 1e-10
"""White noise of an output angle for which none is stated, rad: the rounding of a log with eight
decimals of a degree."""


def estimate_campaign_noise(
    nominal: Device,
    tests: Sequence[ObservedTest],
    residuals: Sequence[Mapping[str, Array]],
    thermometer_lag: float = 0.0,
) -> CampaignNoise:
    """Noise of all channels. That of the output angle is the nominal device's stated noise.

    That of the other channels is estimated from second differences of residuals, to which a slow
    signal contributes almost nothing (docs/methods/whitening.md, Eq. 14); how far the temperature
    wanders in steady tests, from differences of means (Eq. 15c). Residuals are record less
    simulation, (n,) by channel for each test, SI. The simulation undoes `thermometer_lag`, s, which
    amplifies the thermometer's noise.
    """
    residuals = [
        _refer_to_nominal_amplitude(test, residual)
        for test, residual in zip(tests, residuals, strict=True)
    ]
    white = {name: _estimate_white(name, tests, residuals) for name in REPLAY_RESOLUTION}
    steps = estimate_reading_steps({t.test.id: list_measured_temperatures(t.log) for t in tests})
    temperature = {
        t.test.id: max(
            _standard_deviation([_second_differences(t.log.temperature, t.rows["temperature"])]),
            steps[t.test.id] / math.sqrt(12),
        )
        for t in tests
    }
    per_kelvin = compute_temperature_slopes(nominal)
    for channel, slope in per_kelvin.items():
        for interval, deviation in white[channel].items():
            own = [t for t in tests if t.log.interval == interval]
            kelvins = [0.0 if t.inputs.is_steady else temperature[t.test.id] for t in own]
            change = slope * float(np.median(kelvins)) * interval / nominal.thermal_lag
            least = REPLAY_RESOLUTION[channel]
            white[channel][interval] = math.sqrt(max(deviation**2 - change**2 / 12, least**2))
    wander = {
        channel: estimate_wander(channel, tests, residuals, white[channel], nominal.thermal_lag)
        for channel in per_kelvin
    }
    white |= _add_hidden_force_noise(nominal, tests, residuals, white)
    return CampaignNoise(
        build_angle_noise(nominal),
        white,
        temperature,
        steps,
        per_kelvin,
        wander,
        nominal.thermal_lag,
        thermometer_lag,
        nominal.bryan_factor,
    )


def _refer_to_nominal_amplitude(
    test: ObservedTest, residual: Mapping[str, Array]
) -> dict[str, Array]:
    """A test's residuals with white noise as large as at nominal amplitude (Eq. 17a)."""
    growth = {name: test.noise_growth.get(name, 1.0) for name in residual if name != "amplitude"}
    return {name: values / growth.get(name, 1.0) for name, values in residual.items()}


def _add_hidden_force_noise(
    nominal: Device,
    tests: Sequence[ObservedTest],
    residuals: Sequence[Mapping[str, Array]],
    white: Mapping[str, Mapping[float, float]],
) -> dict[str, dict[float, float]]:
    """Standard deviations of a row of each force by row length, with the noise that its loop keeps
    from second differences of short rows (Eq. 23), but no more than means of rows show."""
    density = (2 * nominal.bryan_factor * nominal.angle_random_walk) ** 2
    loops = {
        "amplitude_force": nominal.amplitude_loop,
        "quadrature_force": nominal.quadrature_loop,
    }
    complete = {channel: dict(white[channel]) for channel in loops}
    for channel, loop in loops.items():
        for interval, deviation in white[channel].items():
            share = compute_visible_share(interval, loop)
            if share >= 1:
                continue
            hidden = (1 - share) * min(density / interval, deviation**2 / share)
            pairs = zip(tests, residuals, strict=True)
            own = [(t, r[channel]) for t, r in pairs if t.log.interval == interval]
            shown = _estimate_white_of_means(channel, own, SETTLED_PHASE / loop)
            allowed = math.sqrt(deviation**2 + hidden)
            complete[channel][interval] = min(allowed, max(deviation, shown))
    return complete


def compute_visible_share(interval: float, natural_frequency: float) -> float:
    """Variance that force noise makes in the second differences (Eq. 14) of a loop's force, over
    that of white noise of the same density (docs/methods/whitening.md, Eq. 22).

    The loop is critically damped, with this natural frequency, rad/s; its force is averaged over
    rows of `interval` seconds.
    """
    phases = natural_frequency * interval * np.arange(4)
    covariances = (1 + 3 * phases) * np.exp(-phases) / 4 - phases / 2
    return float(THIRD_DIFFERENCE @ covariances) / (natural_frequency * interval)


def compute_temperature_slopes(device: Device) -> dict[str, float]:
    """Sensitivity of each channel that follows the resonator's temperature, SI/K, unsigned."""
    return {
        "frequency_offset": abs(device.frequency * device.frequency_per_kelvin),
        "amplitude_force": abs(device.decay_time_per_kelvin / device.decay_time),
    }


def _estimate_white(
    name: str, tests: Sequence[ObservedTest], residuals: Sequence[Mapping[str, Array]]
) -> dict[float, float]:
    """Standard deviation by row length: a loop averages its noise over a longer row."""
    parts: dict[float, list[Array]] = {}
    for test, residual in zip(tests, residuals, strict=True):
        own = parts.setdefault(test.log.interval, [])
        own.append(_second_differences(residual[name], test.rows[name]))
    every = [part for own in parts.values() for part in own]
    return {
        interval: max(
            _standard_deviation(own if sum(map(len, own)) >= MIN_DIFFERENCES else every),
            REPLAY_RESOLUTION[name],
        )
        for interval, own in parts.items()
    }


def _estimate_white_of_means(
    name: str, pairs: Sequence[tuple[ObservedTest, Array]], duration: float
) -> float:
    """Standard deviation of a row that makes the second differences of means over at least this
    duration, s, from pairs of a test and its (n,) residual: the median of tests, because a signal
    widens it in some. Infinite where no test has enough means."""
    deviations = []
    for test, residual in pairs:
        count = math.ceil(duration / test.log.interval)
        whole = len(residual) // count * count
        means = residual[:whole].reshape(-1, count).mean(axis=1)
        rows = np.asarray(test.rows[name][:whole].reshape(-1, count).all(axis=1))
        differences = _second_differences(means * math.sqrt(count), rows)
        if len(differences) >= MIN_DIFFERENCES:
            deviations.append(_standard_deviation([differences]))
    return float(np.median(deviations)) if deviations else math.inf


def build_angle_noise(device: Device) -> NoiseModel:
    """Noise that a device states of its output angle, rad; quantization counts as white noise."""
    return NoiseModel(
        max(
            math.hypot(device.angle_white_noise, device.quantization_step / math.sqrt(12)),
            MIN_ANGLE_NOISE,
        ),
        device.angle_random_walk,
        device.rate_random_walk,
        device.bias_instability,
    )


def _second_differences(series: Array, rows: Mask) -> Array:
    """Second differences over sqrt(6), of each three compared rows in succession."""
    three = rows[2:] & rows[1:-1] & rows[:-2]
    return np.asarray(np.diff(series, 2)[three] / np.sqrt(6))


def _standard_deviation(parts: Sequence[Array]) -> float:
    """Standard deviation of all parts without outliers; 0 of no values.

    The outlier limit is that of the typical part, so that parts with a signal don't widen it.
    """
    nonempty = [p for p in parts if len(p)]
    if not nonempty:
        return 0.0
    typical = float(np.median([estimate_robust_deviation(p) for p in nonempty]))
    values = np.concatenate(nonempty)
    return float(np.std(values[np.abs(values) <= OUTLIER_SIGMA * typical]))
