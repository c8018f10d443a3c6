"""Coordinates of a test, row by row, and the basis functions of each that candidate terms have."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.bench.readings.play import follow_with_play
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import EACH_POWER_ON
from pyhrg.gap.replay.inputs.thermometer import compute_slopes
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.soundness.fault import TABLE_RIPPLES

PATTERN_HARMONICS = range(1, 19)
"""Harmonics of the pattern angle. Chosen: a cause that is no sine has multiples of its harmonic;
what is missing here of a large one is read as other terms."""
TABLE_HARMONICS = (1, *TABLE_RIPPLES)
"""Harmonics of the table angle. Chosen."""
RATE_HARMONICS = (1, 2, 4)
"""Harmonics of the pattern angle that also appear in proportion to the rate, as loops follow the
turning pattern. Chosen."""
TEMPERATURE_POWERS = (1, 2, 3)
"""Powers of the temperature. Chosen."""
HYSTERESIS_WIDTHS = (2, 5, 10, 20)
"""Widths of the temperature hysteresis, from end to end, K. Chosen."""
SPECIFIC_FORCES = tuple(f"acceleration {axis}" for axis in "xyz")
"""Words of the specific forces along the three axes."""
LAST_MOTION = "direction of the last motion of the table"
"""Words of the function that a backlash of the encoder's drive follows."""
BACKLASH_WIDTH = 10 * ARCSEC
"""Turn back after which the table's direction of motion is another one, rad. Chosen: far above the
noise of an encoder, far below a move."""
THERMAL_LAGS = (600, 3600)
"""Time constants with which a part of the gyro follows the case's temperature, s. Chosen."""
ZERO_TEMPERATURE_RATE = 0.05 / 60
"""Temperature rate at which its direction passes smoothly through zero, K/s. Chosen."""
WARM_UP_TIMES = (60.0, 150.0, 400.0, 1000.0, 2500.0, 6000.0)
"""Time constants of transients after power-on, s. Chosen: about a factor of 2.5 apart."""
SMOOTHING_TIME = 300.0
"""Time over which the slope of a noisy temperature log is taken, s. Chosen."""
SETTLING_FACTORS = ("the settling in 400 s", "the settling in 2500 s")
"""Functions that settle after power-on, as factors of a product. Chosen."""
ANISOTROPY_FACTORS = (
    ("temperature", "the temperature"),
    ("temperature", "the temperature squared"),
    *(("acceleration", words) for words in SPECIFIC_FORCES),
    ("amplitude", "the amplitude"),
    ("time", "the time"),
    *(("time", words) for words in SETTLING_FACTORS),
)
"""Coordinates that an anisotropy of damping or stiffness may follow, with the function of each."""
Functions = Iterator[tuple[str, str, int | None, Array]]
"""Coordinate, words, harmonic and (n,) or (n, b) values."""


@dataclass(frozen=True)
class Coordinates:
    """Coordinates of a test, row by row; (n,) each.

    nominal: device, for the constants that a response needs.
    pattern_angle: of the replay, rad.
    table_angle: rad.
    table_rate: mean over the row, rad/s.
    case, resonator: temperatures above the reference, K.
    case_rate: smoothed slope of the case's temperature, K/s.
    level: amplitude of the replay over the nominal one.
    amplitude: relative departure from the nominal amplitude; the commanded one, or while the drive
        is off that of the replay's energy: quadrature grows then.
    growth_rate: that the drive gives, of the replay, 1/s; 0 while the drive is off.
    quadrature_force: of the replay.
    free_turns: turn of a free pattern by a constant rate, over that of a driven one.
    is_mean: whether harmonics of angles are means over the rows, not values at their ends.
    kept: candidate terms that were found in a channel, by channel.
    """

    nominal: Device
    test: ObservedTest
    pattern_angle: Array
    table_angle: Array
    table_rate: Array
    case: Array
    resonator: Array
    case_rate: Array
    level: Array
    amplitude: Array
    growth_rate: Array
    quadrature_force: Array
    free_turns: Array
    is_mean: bool = False
    kept: dict[str, dict[object, Any]] = field(
        default_factory=dict, init=False, compare=False, repr=False
    )

    @cached_property
    def means(self) -> "Coordinates":
        """These coordinates, harmonics of angles averaged over the rows."""
        return replace(self, is_mean=True)

    def rotate(self, angle: Array) -> Array:
        """(n, 2) cosine and sine of an angle that turns evenly between the rows' ends, rad: there,
        or their means over the rows."""
        if not self.is_mean:
            return make_harmonic(angle)
        begin = np.concatenate((angle[:1], angle[:-1]))
        share = np.sinc((angle - begin) / (2 * math.pi))
        return np.asarray(share[:, None] * make_harmonic((begin + angle) / 2))

    def integrate(self, rate: Array) -> Array:
        """(n, b) integral of rates over the rows, as a pattern that is free in some of them
        turns."""
        turned = np.cumsum(rate, axis=0) * self.test.log.interval
        return np.asarray(turned * self.free_turns[:, None])

    @cached_property
    def functions(self) -> list[tuple[str, str, int | None, Array]]:
        """Coordinate, words, harmonic and (n, b) values of each basis function."""
        return [(c, w, m, v.reshape(len(v), -1)) for c, w, m, v in _generate_functions(self)]

    @cached_property
    def harmonics(self) -> dict[int, Array]:
        """(n, 2) cosine and sine of each multiple of the pattern angle."""
        return {m: self.rotate(m * self.pattern_angle) for m in PATTERN_HARMONICS}

    @cached_property
    def table_direction(self) -> Array:
        """(n, 1) direction of the table's last motion, -1 to 1; 0 until it moves. By half the
        backlash, with this sign, an encoder with backlash lags behind the table."""
        turned = np.append(0.0, self.table_angle)
        moved = np.sign(np.diff(follow_with_play(turned, BACKLASH_WIDTH)))
        last = np.maximum.accumulate(np.where(moved != 0, np.arange(len(moved)), 0))
        return np.asarray(moved[last, None])

    @cached_property
    def factors(self) -> dict[str, Array]:
        """(n, 1) second functions of products, by their words."""
        log = self.test.log
        accelerations = (log.acceleration_x, log.acceleration_y, log.acceleration_z)
        forces = {w: own / 10 for w, own in zip(SPECIFIC_FORCES, accelerations, strict=True)}
        factors = {
            "the rate": self.table_rate,
            "the temperature": self.resonator / 10,
            "the temperature squared": (self.resonator / 10) ** 2,
            "the amplitude": self.amplitude,
            "the time": log.time / 3600,
            **forces,
            **{f"{words} squared": force**2 for words, force in forces.items()},
        }
        for constant in WARM_UP_TIMES:
            factors[f"the settling in {constant:g} s"] = np.exp(-log.time / constant)
        return {words: values[:, None] for words, values in factors.items()}

    def multiply(self, words: str, block: Array, second: str) -> tuple[str, None, Array]:
        """Words, no harmonic, and (n, b) values of a product with one of these."""
        return f"{words}, times {second}", None, block * self.factors[second]

    def multiply_harmonic(self, m: int, second: str) -> tuple[str, None, Array]:
        """Words, no harmonic, and values of such a product of a harmonic of the pattern angle."""
        return self.multiply(name_harmonic(m), self.harmonics[m], second)


def name_harmonic(m: int) -> str:
    """Words of a multiple of the pattern angle."""
    return f"harmonic {m} of the pattern angle"


def compute_coordinates(
    test: ObservedTest,
    replay: Mapping[str, Array],
    nominal: Device,
    free_turns: Array | None = None,
) -> Coordinates:
    """Coordinates of a test, from its replay, (n,) by field of a log, SI, and from the nominal
    thermal lag, reference temperature and amplitude. Without `free_turns` a free pattern turns as a
    driven one does."""
    log = test.log
    is_driven = log.is_driven
    energetic = np.hypot(replay["amplitude"], replay.get("quadrature", 0.0))
    return Coordinates(
        nominal,
        test,
        replay["wave_angle"],
        log.table_angle,
        test.inputs.table.means,
        *compute_temperatures(test, nominal),
        replay["amplitude"] / nominal.amplitude,
        np.where(is_driven, log.amplitude_setpoint, energetic) / nominal.amplitude - 1,
        np.where(is_driven, replay["amplitude_force"], 0.0),
        replay["quadrature_force"],
        np.ones(len(log.time)) if free_turns is None else free_turns,
    )


def compute_temperatures(test: ObservedTest, device: Device) -> tuple[Array, Array, Array]:
    """(n,) temperatures of the case and of the resonator above the reference, K, and the case's
    smoothed slope, K/s, as a device's thermometer reads them."""
    interval = test.log.interval
    case = test.inputs.find_case_temperatures(device) - device.reference_temperature
    start = float(case[0]) if test.inputs.is_soaked else 0.0
    resonator = follow_with_lag(case, interval, device.thermal_lag, start)
    slopes = compute_slopes(case, interval, SMOOTHING_TIME / 2)
    return case[1:], resonator[1:], slopes[1:]


def _generate_functions(where: Coordinates) -> Functions:
    """Basis functions in the order of the design's columns."""
    yield from _generate_angle_functions(where)
    yield from _generate_temperature_functions(where)
    yield from _generate_rate_functions(where)
    yield from _generate_acceleration_functions(where)
    yield "amplitude", "amplitude", None, where.amplitude
    yield "amplitude", "amplitude squared", None, where.amplitude * (2 + where.amplitude)
    yield from generate_anisotropies(where)
    time = where.test.log.time
    yield "time", "time since power-on", None, time / 3600
    for constant in WARM_UP_TIMES:
        words = f"settling in {constant:g} s"
        yield "time", words, None, where.factors[f"the {words}"]
    if (period := where.test.line_period) is not None:
        cycle = where.rotate(2 * math.pi * time / period)
        yield "time", f"harmonic 1 of a period of {period:.9g} s", 1, cycle
    yield "time", EACH_POWER_ON, None, np.ones(len(time))


def _generate_angle_functions(where: Coordinates) -> Functions:
    yield "wave_angle", "mean over the pattern angle", 0, np.ones(len(where.pattern_angle))
    for m in PATTERN_HARMONICS:
        yield "wave_angle", name_harmonic(m), m, where.harmonics[m]
    for m in TABLE_HARMONICS:
        words = f"harmonic {m} of the table angle"
        yield "table_angle", words, m, where.rotate(m * where.table_angle)


def generate_anisotropies(where: Coordinates) -> Functions:
    """What an anisotropy of damping or stiffness gives that follows another coordinate."""
    for coordinate, second in ANISOTROPY_FACTORS:
        yield coordinate, *where.multiply_harmonic(4, second)


def _generate_temperature_functions(where: Coordinates) -> Functions:
    for p in TEMPERATURE_POWERS:
        yield "temperature", f"temperature^{p}", None, (where.resonator / 10) ** p
    yield "temperature", "temperature of the case", None, where.case / 10
    rate, words = where.case_rate, "of the temperature rate"
    yield "temperature_rate", "temperature rate", None, rate * 60
    yield "temperature_rate", f"magnitude {words}", None, np.abs(rate) * 60
    yield "temperature_rate", f"square {words}", None, (rate * 60) ** 2
    direction = rate / np.hypot(rate, ZERO_TEMPERATURE_RATE)  # smooth about zero, -1 to 1
    yield "temperature_rate", f"direction {words}", None, direction
    for width in HYSTERESIS_WIDTHS:
        lagging = follow_with_play(where.case, width) / 10
        yield "temperature", f"temperature with a hysteresis of {width:g} K", None, lagging
    for lag in THERMAL_LAGS:
        lagging = follow_with_lag(where.case, where.test.log.interval, lag) / 10
        yield "temperature", f"temperature behind a lag of {lag:g} s", None, lagging


def _generate_rate_functions(where: Coordinates) -> Functions:
    rate = where.table_rate
    for m in RATE_HARMONICS:
        yield "wave_angle", *where.multiply_harmonic(m, "the rate")
    for p, words in ((1, "rate"), (2, "rate squared"), (3, "rate cubed")):
        yield "rate", words, None, rate**p
    yield "rate", "magnitude of the rate", None, np.abs(rate)
    commanded = where.test.log.virtual_rotation
    yield "rate", "commanded rotation", None, commanded
    yield "rate", "magnitude of the commanded rotation", None, np.abs(commanded)


def _generate_acceleration_functions(where: Coordinates) -> Functions:
    force = {axis: where.factors[f"acceleration {axis}"] for axis in "xyz"}
    for axis in "xyz":
        yield "acceleration", f"acceleration {axis}", None, force[axis]
        yield "acceleration", f"acceleration {axis} squared", None, force[axis] ** 2
    for pair in ("xy", "xz", "yz"):
        product = force[pair[0]] * force[pair[1]]
        yield "acceleration", f"acceleration {pair[0]} times {pair[1]}", None, product


def make_harmonic(angle: Array) -> Array:
    """(n, 2) cosine and sine."""
    return np.column_stack([np.cos(angle), np.sin(angle)])


def turn_harmonic(block: Array) -> Array:
    """(n, 2) cosine and sine of a harmonic, a quarter of its period ahead."""
    return np.column_stack([-block[:, 1], block[:, 0]])


def average_rows(block: Array) -> Array:
    """(n, b) mean of each row and the one before."""
    return np.asarray((block + np.vstack([block[:1], block[:-1]])) / 2)
