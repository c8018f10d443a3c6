"""What nobody has a name for: a response that follows one coordinate of the test.

Each element is a small block of columns in one channel, over pattern angle, table angle,
temperature and its rate, input rate, acceleration, amplitude or time. In the output angle an
element is an error of the angle itself, or a bias, whose integral it is.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property

import numba
import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import Observed

Array = NDArray[np.float64]

PATTERN_HARMONICS = (1, 2, 3, 4, 5, 6, 8, 10, 12, 16)
TABLE_HARMONICS = (1, 2, 3, 4, 8)
FOLLOWED = (1, 2, 4)
"""Harmonics of the pattern angle that loops follow as it turns, in proportion to the rate."""
POWERS = (1, 2, 3)
PLAYS = (2.0, 10.0)
"""By which what has hysteresis lags behind the temperature, K from end to end."""
STEADY = 0.05 / 60
"""Temperature rate that is next to none, K/s."""
WARM_UPS = (60.0, 300.0, 1200.0, 6000.0)
"""Time constants of what settles after power-on, s."""
EACH_POWER_ON = "a value for each power-on"


@dataclass(frozen=True)
class Element:
    """A block of columns of one channel.

    coordinate: of the campaign format.
    of: what function of the coordinate it is.
    harmonic: where the coordinate is an angle.
    is_of_each_power_on: whether every test has a size of its own: its one column is another in
        each.
    """

    channel: str
    coordinate: str
    of: str
    harmonic: int | None = None
    is_of_each_power_on: bool = field(default=False, kw_only=True)

    @property
    def foretells(self) -> bool:
        """Whether it says anything of a test that is yet to be made."""
        return not self.is_of_each_power_on

    @property
    def words(self) -> str:
        """What it is, for people."""
        return f"{self.of} ({self.channel})"


@dataclass(frozen=True)
class Coordinates:
    """Where a test was, row by row; (n,) each.

    pattern_angle: rad, by simulation.
    table_angle: rad.
    table_rate: rad/s, mean over the row.
    case, resonator: temperatures above the reference, K.
    case_rate: K/s, smoothed.
    amplitude: commanded, or of a free pattern by simulation, over the nominal one, less one.
    """

    test: Observed
    pattern_angle: Array
    table_angle: Array
    table_rate: Array
    case: Array
    resonator: Array
    case_rate: Array
    amplitude: Array

    @cached_property
    def functions(self) -> list[tuple[str, str, int | None, Array]]:
        """Coordinate, words, harmonic, and (n, b) values: what elements are made of."""
        return list(_functions(self))


def coordinates(
    test: Observed, pattern_angle: Array, amplitude: Array, believed: Device
) -> Coordinates:
    """Where a test was.

    Args:
        test: of a campaign.
        pattern_angle: (n,) rad.
        amplitude: (n,) of the vibration; only where the drive is off.
        believed: thermal lag, reference temperature and amplitude are used.
    """
    log = test.log
    case = test.inputs.temperatures - believed.reference_temperature
    kept = np.exp(-log.interval / believed.thermal_lag)
    resonator = np.zeros(len(case))
    for i in range(1, len(case)):
        resonator[i] = kept * resonator[i - 1] + (1 - kept) * (case[i] + case[i - 1]) / 2
    return Coordinates(
        test,
        pattern_angle,
        log.table_angle,
        test.inputs.table.means,
        case[1:],
        resonator[1:],
        _slope(case, log.interval)[1:],
        np.where(log.drive_on > 0, log.amplitude_setpoint, amplitude) / believed.amplitude - 1,
    )


SMOOTHING = 300.0
"""Time over which the slope of a noisy temperature log is taken, s."""


def _slope(series: Array, interval: float) -> Array:
    half = max(1, round(SMOOTHING / interval / 2))
    n = len(series)
    low, high = np.maximum(np.arange(n) - half, 0), np.minimum(np.arange(n) + half, n - 1)
    return np.asarray((series[high] - series[low]) / ((high - low) * interval))


def columns(where: Coordinates, channel: str) -> list[tuple[Element, Array]]:
    """Elements of a channel in one test: (n, b) each, in the same order for every test.

    Args:
        where: the test's coordinates.
        channel: a field of a log.
    """
    found = []
    is_angle = channel == "gyro_angle"
    for coordinate, of, harmonic, block in where.functions:
        words, values = of, block
        if is_angle:
            words, values = f"bias: {of}", np.cumsum(block, axis=0) * where.test.log.interval
        own = of == EACH_POWER_ON
        element = Element(channel, coordinate, words, harmonic, is_of_each_power_on=own)
        found.append((element, values))
        if is_angle and harmonic:
            found.append((Element(channel, coordinate, f"angle: {of}", harmonic), block))
    if is_angle:
        for coordinate, of, block in _pickoffs(where):
            found.append((Element(channel, coordinate, f"angle: {of}"), block))
    return found


def _pickoffs(where: Coordinates) -> Iterator[tuple[str, str, Array]]:
    """What gains and axes of pick-offs that follow a coordinate do to the angle: coordinate, words,
    and (n, 2) values."""
    second, words = _turn(2 * where.pattern_angle), "2nd harmonic of the pattern angle, times"
    warm = where.resonator[:, None] / 10
    yield "temperature", f"{words} the temperature", second * warm
    for axis in "xyz":
        force = getattr(where.test.log, f"acceleration_{axis}")[:, None] / 10
        yield "acceleration", f"{words} acceleration {axis}", second * force
        yield "acceleration", f"{words} acceleration {axis} squared", second * force**2


def _functions(where: Coordinates) -> Iterator[tuple[str, str, int | None, Array]]:
    """Coordinate, words, harmonic, and (n, b) values."""
    log = where.test.log
    yield "wave_angle", "mean over the pattern angle", 0, np.ones((len(log.time), 1))
    for m in PATTERN_HARMONICS:
        yield "wave_angle", f"harmonic {m} of the pattern angle", m, _turn(m * where.pattern_angle)
    for m in TABLE_HARMONICS:
        yield "table_angle", f"harmonic {m} of the table angle", m, _turn(m * where.table_angle)
    for p in POWERS:
        yield "temperature", f"temperature^{p}", None, _column((where.resonator / 10) ** p)
    fourth = _turn(4 * where.pattern_angle)
    yield "temperature", "temperature, 4th harmonic", None, fourth * where.resonator[:, None] / 10
    yield "temperature", "temperature of the case", None, _column(where.case / 10)
    yield "temperature_rate", "temperature rate", None, _column(where.case_rate * 60)
    yield "temperature_rate", "its magnitude", None, _column(np.abs(where.case_rate) * 60)
    yield "temperature_rate", "its square", None, _column((where.case_rate * 60) ** 2)
    yield "temperature_rate", "its direction", None, _column(_direction(where.case_rate))
    for play in PLAYS:
        words = f"temperature with a play of {play:g} K"
        yield "temperature", words, None, _column(_followed(where.case, play) / 10)
    rate = where.table_rate
    for m in FOLLOWED:
        words = f"harmonic {m} of the pattern angle, times the rate"
        yield "wave_angle", words, None, _turn(m * where.pattern_angle) * rate[:, None]
    for p, words in ((1, "rate"), (2, "rate squared"), (3, "rate cubed")):
        yield "rate", words, None, _column(rate**p)
    yield "rate", "magnitude of the rate", None, _column(np.abs(rate))
    virtual = log.virtual_rotation
    yield "rate", "commanded rotation", None, _column(virtual)
    yield "rate", "its magnitude", None, _column(np.abs(virtual))
    force = {axis: getattr(log, f"acceleration_{axis}") / 10 for axis in "xyz"}
    for axis in "xyz":
        yield "acceleration", f"acceleration {axis}", None, _column(force[axis])
        yield "acceleration", f"acceleration {axis} squared", None, _column(force[axis] ** 2)
    for pair in ("xy", "xz", "yz"):
        product = force[pair[0]] * force[pair[1]]
        yield "acceleration", f"acceleration {pair[0]} times {pair[1]}", None, _column(product)
    yield "amplitude", "amplitude", None, _column(where.amplitude)
    yield "amplitude", "amplitude squared", None, _column(where.amplitude**2)
    yield "time", "time since power-on", None, _column(log.time / 3600)
    for constant in WARM_UPS:
        settling = np.exp(-log.time / constant)
        yield "time", f"settling in {constant:g} s", None, _column(settling)
    yield "time", EACH_POWER_ON, None, np.ones((len(log.time), 1))


def _direction(rate: Array) -> Array:
    """Of a rate, K/s: -1 to 1, 0 where it is none."""
    return np.asarray(rate / np.hypot(rate, STEADY))


@numba.njit(cache=True)
def _followed(series: Array, play: float) -> Array:
    """(n,) what a series drags behind it, once it has taken up the play: hysteresis."""
    lagging = np.empty_like(series)
    last = series[0]
    for i, value in enumerate(series):
        last = min(max(last, value - play / 2), value + play / 2)
        lagging[i] = last
    return lagging


def _turn(angle: Array) -> Array:
    return np.column_stack([np.cos(angle), np.sin(angle)])


def _column(values: Array) -> Array:
    return np.asarray(values)[:, None]
