"""Residuals as they are shown: channels in units that people use, and coordinates."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import (
    ARCSEC,
    DEG,
    DEG_PER_H,
    HZ,
    MINUTE,
    PPM,
    STANDARD_GRAVITY,
    ZERO_CELSIUS,
)
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import coordinates
from pyhrg.gap.replay.observations import Observed
from pyhrg.gap.whitening.channel_noise import ChannelNoise
from pyhrg.gap.whitening.noise_draws import drawn

Array = NDArray[np.float64]

DRAWS = 100
"""Of noise, for what it leaves in a bin."""
SEED = 2
"""Of them."""
TURN = 360.0


@dataclass(frozen=True)
class View:
    """What is shown of a channel.

    key: the page's.
    channel: a field of a log.
    title, unit: as read.
    size: of the unit, SI.
    rate: whether it is the change from row to row, over the row.
    """

    key: str
    channel: str
    title: str
    unit: str
    size: float
    rate: bool = False

    def shown(self, residual: Array, interval: float) -> Array:
        """(n, ...) a residual, SI, in the unit."""
        if not self.rate:
            return residual / self.size
        before = np.full_like(residual[:1], np.nan)
        return np.asarray(np.diff(residual, axis=0, prepend=before) / interval / self.size)


VIEWS = (
    View("angle", "gyro_angle", "Output angle", "arcsec", ARCSEC),
    View("rate", "gyro_angle", "Output rate", "deg/h", DEG_PER_H, rate=True),
    View("amplitude", "amplitude", "Amplitude", "ppm", PPM),
    View("amplitude_force", "amplitude_force", "Amplitude force", "10⁻⁹/s", 1e-9),
    View("quadrature_force", "quadrature_force", "Quadrature force", "10⁻⁹/s", 1e-9),
    View("frequency", "frequency_offset", "Loop frequency", "µHz", 1e-6 * HZ),
)


@dataclass(frozen=True)
class Axis:
    """A coordinate that residuals are drawn against.

    key, title, unit: as of a view.
    least: range in a test below which the coordinate stands still, in the unit.
    bins: that the range is cut in; odd, so that the middle of the range is that of a bin.
    turns: whether it is an angle that starts anew after a turn.
    """

    key: str
    title: str
    unit: str
    least: float
    bins: int = 31
    turns: bool = False


AXES = (
    Axis("wave_angle", "Pattern angle", "deg", 2.0, 36, turns=True),
    Axis("table_angle", "Table angle", "deg", 2.0, 36, turns=True),
    Axis("temperature", "Resonator temperature", "°C", 0.5),
    Axis("temperature_rate", "Temperature rate of the case", "K/min", 0.02),
    Axis("rate", "Rate of the table", "deg/s", 0.01),
    Axis("commanded_rate", "Commanded rotation", "deg/s", 0.01),
    Axis("acceleration_x", "Specific force along x", "g", 0.01),
    Axis("acceleration_y", "Specific force along y", "g", 0.01),
    Axis("acceleration_z", "Specific force along the input axis", "g", 0.01),
    Axis("amplitude", "Amplitude set point", "nominal", 1e-3),
    Axis("time", "Time since power-on", "s", 0.0, 61),
)


def along(test: Observed, believed: Device) -> dict[str, Array]:
    """(n,) where a test was, by the axes' keys, in their units.

    Args:
        test: observed.
        believed: thermal lag and reference temperature are used.
    """
    log = test.log
    where = coordinates(test, log.wave_angle, log.amplitude, believed)
    celsius = where.resonator + believed.reference_temperature - ZERO_CELSIUS
    return {
        "wave_angle": where.pattern_angle / DEG,
        "table_angle": where.table_angle / DEG,
        "temperature": celsius,
        "temperature_rate": where.case_rate * MINUTE,
        "rate": where.table_rate / DEG,
        "commanded_rate": log.virtual_rotation / DEG,
        "acceleration_x": log.acceleration_x / STANDARD_GRAVITY,
        "acceleration_y": log.acceleration_y / STANDARD_GRAVITY,
        "acceleration_z": log.acceleration_z / STANDARD_GRAVITY,
        "amplitude": log.amplitude_setpoint,
        "time": log.time,
    }


def moving(where: dict[str, Array]) -> list[Axis]:
    """Axes along which a test moves."""
    return [axis for axis in AXES if _range(where[axis.key]) > axis.least]


def noises(test: Observed, view: View, noise: ChannelNoise, draws: Sequence[int]) -> Array:
    """(n, DRAWS) what noise alone would show, in the view's unit.

    Args:
        test: whose rows count.
        view: of a channel.
        noise: of all channels.
        draws: numbers that tell this test's draws from others'.
    """
    generator = np.random.default_rng([SEED, *draws])
    n, interval = len(test.log.time), test.log.interval
    of = noise.of(view.channel, test)
    readings = np.column_stack([drawn(of, n, interval, generator) for _ in range(DRAWS)])
    return view.shown(readings, interval)


def _range(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if len(known) else 0.0
