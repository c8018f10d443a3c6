"""Channels in customary units, and the coordinates that residuals are drawn against."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
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
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.whitening import draw_noise

DRAWS = 100
"""Draws of the noise from which its band is computed (chosen)."""
SEED = 2
"""Seed of these draws, so that the same diagnosis gives the same page."""
FULL_TURN = 360.0
"""deg"""


@dataclass(frozen=True)
class View:
    """A channel as it is shown.

    key: identifies the view on the page.
    channel: field of a log.
    title, unit: text of the axis.
    factor: the unit in SI.
    is_rate: whether the difference between rows over the interval is shown.
    """

    key: str
    channel: str
    title: str
    unit: str
    factor: float
    is_rate: bool = False

    def convert(self, residual: Array, interval: float) -> Array:
        """A residual (n, ...) in the view's unit, from SI and the interval between rows, s."""
        if not self.is_rate:
            return residual / self.factor
        before = np.full_like(residual[:1], np.nan)
        return np.asarray(np.diff(residual, axis=0, prepend=before) / interval / self.factor)


VIEWS = (
    View("angle", "gyro_angle", "Output angle", "arcsec", ARCSEC),
    View("rate", "gyro_angle", "Output rate", "deg/h", DEG_PER_H, is_rate=True),
    View("amplitude", "amplitude", "Amplitude", "ppm", PPM),
    View("amplitude_force", "amplitude_force", "Amplitude force", "10⁻⁹/s", 1e-9),
    View("quadrature_force", "quadrature_force", "Quadrature force", "10⁻⁹/s", 1e-9),
    View("frequency", "frequency_offset", "Loop frequency", "µHz", 1e-6 * HZ),
)
ANGLE = VIEWS[0]


@dataclass(frozen=True)
class Axis:
    """A coordinate that residuals are drawn against.

    key, title, unit: as in a view.
    smallest_range: range in a test, in the unit, below which the coordinate counts as constant
        (chosen).
    bins: number over the range; odd, so that the middle of the range is the centre of a bin.
    is_angle: whether the coordinate is an angle, taken modulo a full turn.
    """

    key: str
    title: str
    unit: str
    smallest_range: float
    bins: int = 31
    is_angle: bool = False


AXES = (
    Axis("wave_angle", "Pattern angle", "deg", 2.0, 36, is_angle=True),
    Axis("table_angle", "Table angle", "deg", 2.0, 36, is_angle=True),
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


def compute_axis_values(test: ObservedTest, nominal: Device) -> dict[str, Array]:
    """(n,) coordinates at each row of a test, by the axes' keys and in their units. The resonator's
    temperature follows from the nominal thermal lag and reference temperature."""
    log = test.log
    where = compute_coordinates(test, vars(log), nominal)
    celsius = where.resonator + nominal.reference_temperature - ZERO_CELSIUS
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


def find_moving_axes(values: dict[str, Array]) -> list[Axis]:
    """Axes whose coordinate changes in a test."""
    return [axis for axis in AXES if _range(values[axis.key]) > axis.smallest_range]


def draw_view_noise(
    test: ObservedTest, view: View, noise: CampaignNoise, stream: Sequence[int]
) -> Array:
    """(n, DRAWS) simulated noise of a channel in the view's unit, in a test of n rows. The numbers
    `stream` select the random stream."""
    generator = np.random.default_rng([SEED, *stream])
    n, interval = len(test.log.time), test.log.interval
    model = noise.get_model(view.channel, test)
    readings = np.column_stack([draw_noise(model, n, interval, generator) for _ in range(DRAWS)])
    return view.convert(readings, interval)


def _range(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if len(known) else 0.0
