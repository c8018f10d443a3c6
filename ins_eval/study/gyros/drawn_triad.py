"""Triads of gyros, drawn from their seeds: built, calibrated, benched, drifted.

Each triad draws from its own child of the study's seed, so that a triad is the same in whatever
block and on whatever worker it is made.
"""

from dataclasses import dataclass, field, fields

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan
from ins_eval.study.gyros.drift import Drift, Flight, draw_flight
from ins_eval.study.gyros.makers_calibration import Method, calibrate_gyro
from ins_eval.study.gyros.measured_gyro import MeasuredGyro, measure_gyro
from ins_eval.study.gyros.population import TRIMMED, Population
from ins_eval.study.gyros.true_maps import compute_turning_bias, read_flight_coefficients, start_at
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, MICRO_G
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

AXES = 3


@dataclass(frozen=True)
class TriadDistribution:
    """What triads are drawn from: gyros, the maker's calibration, the bench, the drift.

    Attributes:
        accelerometer_bias: standard deviation of each accelerometer's bias, m/s^2.
        mounting: standard deviation of the angle by which each input axis leans, in each of two
            directions, rad.

    Raises:
        HrgError: a bench with a single power-on.
    """

    population: Population = TRIMMED
    method: Method = "mean"
    calibration: BenchPlan = CALIBRATION
    bench: BenchPlan = field(default_factory=BenchPlan)
    drift: Drift = field(default_factory=Drift)
    accelerometer_bias: float = 10 * MICRO_G
    mounting: float = 10 * ARCSEC

    def __post_init__(self) -> None:
        if self.bench.runs < 2:
            raise HrgError(
                f"bench: found {self.bench.runs} power-on of each test, expected 2 or more: one "
                "shows no scatter"
            )


@dataclass(frozen=True)
class DrawnGyro:
    """A gyro of a triad.

    Attributes:
        device: the gyro as its maker has calibrated it.
        bench_seed: seed of the bench's noise.
        flight: the gyro as it flies.
    """

    device: Device
    bench_seed: int
    flight: Flight


@dataclass(frozen=True)
class DrawnTriad:
    """Three gyros in one flight, and what the bench measured of them.

    Attributes:
        measured: the bench's results.
        flights: the gyros as they fly.
        accelerometers: (3,) biases, m/s^2.
        mounting: (2, 3) angles by which input axes lean (`TriadBlock`), rad.
        seed: (2,) entropy of the noise in flight.
        calibrated: the gyros as the bench measured them.
    """

    measured: tuple[MeasuredGyro, ...]
    flights: tuple[Flight, ...]
    accelerometers: Array
    mounting: Array
    seed: NDArray[np.uint64]
    calibrated: tuple[Device, ...] = ()


def make_triad_seed(study_seed: int, number: int) -> np.random.SeedSequence:
    return np.random.SeedSequence(study_seed, spawn_key=(number,))


def draw_triad(
    fmu: GyroFmu, distribution: TriadDistribution, seed: np.random.SeedSequence
) -> DrawnTriad:
    """One triad, from the FMU `HRGSlow`; its seed decides all of it."""
    generator = np.random.default_rng(seed)
    gyros = draw_gyros(fmu, distribution, generator)
    return DrawnTriad(
        measured=tuple(
            measure_gyro(fmu, each.device, distribution.bench, each.bench_seed) for each in gyros
        ),
        flights=tuple(each.flight for each in gyros),
        calibrated=tuple(each.device for each in gyros),
        accelerometers=generator.normal(0.0, distribution.accelerometer_bias, AXES),
        seed=generator.integers(2**63, size=2).astype(np.uint64),
        mounting=generator.normal(0.0, distribution.mounting, (2, AXES)),
    )


def draw_gyros(
    fmu: GyroFmu, distribution: TriadDistribution, generator: np.random.Generator
) -> list[DrawnGyro]:
    """The three gyros of a triad, built, calibrated and aged; they are not benched."""
    return [_draw_gyro(fmu, distribution, generator) for _ in range(AXES)]


def _draw_gyro(
    fmu: GyroFmu, distribution: TriadDistribution, generator: np.random.Generator
) -> DrawnGyro:
    built = distribution.population.draw(generator)
    maker, bench = generator.integers(2**63, size=2).tolist()
    device: Device = calibrate_gyro(
        fmu, built, distribution.method, maker, distribution.calibration
    )
    return DrawnGyro(device, bench, draw_flight(device, distribution.drift, generator))


def tabulate_triads(fmu: GyroFmu, triads: list[DrawnTriad]) -> TriadBlock:
    """Triads as arrays; their true maps are measured by simulation of the FMU `HRGSlow`."""
    flights = [[_read_flight_map(fmu, flight) for flight in each.flights] for each in triads]

    def stacked(values: list[list[Array]]) -> Array:
        return np.moveaxis(np.array(values), 1, -1)

    return TriadBlock(
        **{
            each.name: stacked([[getattr(g, each.name) for g in t.measured] for t in triads])
            for each in fields(MeasuredGyro)
        },
        start_angle=np.array([[f.power_on_angle for f in each.flights] for each in triads]),
        rise=np.array([[f.rise for f in each.flights] for each in triads]),
        in_flight=stacked([[coefficients for coefficients, _ in each] for each in flights]),
        turning=stacked([[turning for _, turning in each] for each in flights]),
        noise=stacked([[_list_noise(f.device) for f in each.flights] for each in triads]),
        accelerometers=np.array([each.accelerometers for each in triads]),
        mounting=np.array([each.mounting for each in triads]),
        seeds=np.array([each.seed for each in triads]),
    )


def _read_flight_map(fmu: GyroFmu, flight: Flight) -> tuple[Array, Array]:
    """Coefficients in flight, and the bias that turns the pattern, from the power-on angle."""
    coefficients = read_flight_coefficients(fmu, flight.device, flight.rise)
    turning = compute_turning_bias(flight.device, coefficients, flight.power_on_angle)
    return start_at(coefficients, flight.power_on_angle), turning


def _list_noise(device: Device) -> Array:
    """(4,) noise coefficients, SI, in the order of `COEFFICIENT_NAMES`."""
    return np.array([getattr(device, name) for name in COEFFICIENT_NAMES])
