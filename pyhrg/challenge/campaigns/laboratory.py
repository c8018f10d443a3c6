"""Errors of a laboratory: nominal values and bench differ a little from the truth.

Written without use of the replay that a diagnosis makes of such records.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy import signal

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import KNOWN
from pyhrg.records import Log

LEVELS = {"ideal": 0.0, "good-lab": 1.0, "rough-lab": 3.0}
"""Largest error of each known value at a level of realism, in units of its tolerance."""
NOMINAL = tuple(
    k.fields[0] for k in KNOWN if k.family == "nominal" and k.fields[0] != "frequency_error"
)
"""Fields of a device that a campaign states as nominal; the frequency has an error of its own."""
LOST_SHARE, OUTLIER_SHARE = 1e-3, 3e-4
"""Shares of rows that a good laboratory's recorder loses, and that hold a wrong angle. Chosen."""
OUTLIER_SIZE = 0.05 * DEG
"""Largest error of such an angle, rad. Chosen."""
ENCODER_NOISE = 0.03 * ARCSEC
"""Standard deviation of the encoder's white noise, rad. Chosen."""
TEMPERATURE_STEP = 0.01
"""Resolution of the thermometer, K. Chosen."""


@dataclass(frozen=True)
class Laboratory:
    """One laboratory.

    Attributes:
        level: largest error of each value, in its tolerance; it scales the recorder's faults too.
        errors: true less nominal value of a field of a device, by field, SI.
    """

    level: float
    errors: Mapping[str, float]

    def true_device(self, nominal: Device) -> Device:
        """The true gyro, which differs from the nominal one by the errors."""
        own: dict[str, Any] = {f: getattr(nominal, f) + self.errors.get(f, 0.0) for f in NOMINAL}
        frequency = nominal.frequency + self.errors.get("frequency_error", 0.0)
        latitude = nominal.site.latitude + self.errors.get("latitude_error", 0.0)
        site = replace(nominal.site, latitude=latitude)
        tilt = self.errors.get("table_tilt_east", 0.0)
        return replace(nominal, frequency=frequency, site=site, table_tilt_east=tilt, **own)

    def list_beyond(self, nominal: Device) -> tuple[str, ...]:
        """Names of the known parameters that are off by more than their tolerance."""
        return tuple(
            k.name
            for k in KNOWN
            if abs(self.errors.get(k.fields[0], 0.0)) > k.tolerance_of(nominal)
        )

    def read(self, log: Log, reference_temperature: float) -> Log:
        """A true log as the instruments of this laboratory read it, without noise."""
        if not self.level:
            return log
        errors = self.errors
        late = errors["clock_latency"] + errors["clock_rate"] * log.time
        turned = log.table_angle + errors["encoder_eccentricity_phase"]
        run_out = np.sin(turned) - np.sin(errors["encoder_eccentricity_phase"])
        warm = _follow(log.temperature, log.interval, errors["thermometer_lag"])
        change = (warm - reference_temperature) * (1 + errors["thermometer_gain"])
        return replace(
            log,
            table_angle=log.table_angle - errors["encoder_eccentricity"] * run_out,
            temperature=reference_temperature + change + errors["thermometer_offset"],
            frequency_offset=log.frequency_offset + errors["frequency_error"],
            gyro_angle=_read_late(log.gyro_angle, log.time, late),
            wave_angle=_read_late(log.wave_angle, log.time, late),
            amplitude=_read_late(log.amplitude, log.time, errors["amplitude_latency"])
            * (1 + errors["amplitude_scale"]),
            amplitude_force=log.amplitude_force * (1 + errors["amplitude_force_scale"]),
            quadrature_force=log.quadrature_force * (1 + errors["quadrature_force_scale"]),
        )

    def record(self, log: Log, generator: np.random.Generator) -> Log:
        """A noisy log as the recorder of this laboratory writes it: with noise of the encoder, a
        coarse thermometer, lost rows and wrong angles."""
        if not self.level:
            return log
        count = len(log.time)
        noise = self.level * ENCODER_NOISE * generator.standard_normal(count)
        steps = np.round(log.temperature / TEMPERATURE_STEP) * TEMPERATURE_STEP
        outliers = generator.random(count) < self.level * OUTLIER_SHARE
        wrong = outliers * OUTLIER_SIZE * generator.uniform(-1, 1, count)
        kept = generator.random(count) >= self.level * LOST_SHARE
        kept[[0, -1]] = True
        log = replace(
            log,
            table_angle=log.table_angle + noise,
            temperature=steps,
            gyro_angle=log.gyro_angle + wrong,
        )
        columns: dict[str, Any] = {
            name: values[kept]
            for name, values in vars(log).items()
            if isinstance(values, np.ndarray) and len(values) == count
        }
        return replace(log, **columns)


def draw_laboratory(nominal: Device, level: float, generator: np.random.Generator) -> Laboratory:
    """A laboratory each of whose values is off by up to its tolerance, times the level."""
    errors: dict[str, float] = {}
    for known in KNOWN:
        size = level * known.tolerance_of(nominal)
        errors[known.fields[0]] = float(size * generator.uniform(-1, 1))
        if known.periods or known.name == "thermometer_lag":
            errors[known.fields[0]] = abs(errors[known.fields[0]])
        if known.periods:
            errors[known.fields[1]] = float(generator.uniform(0, 2 * np.pi))
    return Laboratory(level, errors)


def vary_each(nominal: Device, level: float) -> list[Laboratory]:
    """Laboratories of a level in each of which one component of one known parameter is off, by its
    tolerance times the level; none where the level is 0."""
    none = dict.fromkeys((field for known in KNOWN for field in known.fields), 0.0)
    return [
        Laboratory(level, {**none, known.fields[0]: level * known.tolerance_of(nominal), **angle})
        for known in KNOWN * bool(level)
        for angle in ([{known.fields[1]: a} for a in (0.0, np.pi / 2)] if known.periods else [{}])
    ]


def _follow(series: Array, interval: float, lag: float) -> Array:
    """(n,) readings of an instrument with a first-order lag, s, of a series that is linear between
    rows of an interval, s; it has settled at the first value."""
    kept = math.exp(-interval / lag) if lag else 0.0
    slopes = np.diff(series, prepend=series[0]) / interval
    behind = signal.lfilter([lag * (1 - kept)], [1.0, -kept], slopes)
    return np.asarray(series - behind)


def _read_late(values: Array, time: Array, late: Array | float) -> Array:
    """(n,) values read later, s, than the rows have them; the last rate goes on."""
    return np.asarray(values + late * np.gradient(values, time))
