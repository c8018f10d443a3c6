"""A block of triads, from their seeds: built, calibrated, benched, drifted.

Each triad draws from its own child of the study's seed, so that blocks only group: the same triads
on any number of workers.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.triads import Triads
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan
from ins_eval.study.gyros.drift import Drift, Flight, flight
from ins_eval.study.gyros.knowledge import Knowledge, knowledge
from ins_eval.study.gyros.maker import Method, calibrated_gyro
from ins_eval.study.gyros.population import TRIMMED, Population
from ins_eval.study.gyros.true_maps import coefficients, started_at, turning
from pyhrg.common.units import MICRO_G
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

AXES = 3


@dataclass(frozen=True)
class Kind:
    """What triads are drawn from.

    accelerometer_bias: 1 sigma of each, m/s^2.
    """

    population: Population = TRIMMED
    method: Method = "mean"
    calibration: BenchPlan = CALIBRATION
    bench: BenchPlan = field(default_factory=BenchPlan)
    drift: Drift = field(default_factory=Drift)
    accelerometer_bias: float = 10 * MICRO_G


@dataclass(frozen=True)
class Triad:
    """Three gyros in one flight, and what the bench knows of them.

    accelerometers: (3,) biases, m/s^2; seed: of their noise in flight.
    """

    known: tuple[Knowledge, ...]
    benched: tuple[Device, ...]
    flights: tuple[Flight, ...]
    accelerometers: Array
    seed: NDArray[np.uint64]


def triad_seed(study_seed: int, number: int) -> np.random.SeedSequence:
    """Of a triad of the study."""
    return np.random.SeedSequence(study_seed, spawn_key=(number,))


def block(fmu: GyroFmu, kind: Kind, study_seed: int, first: int, count: int) -> Triads:
    """Triads first to first + count - 1 of a study.

    Args:
        fmu: `HRGSlow`.
        kind: what they are drawn from.
        study_seed: of the study.
        first, count: which of its triads.
    """
    numbers = range(first, first + count)
    return gathered(fmu, [triad(fmu, kind, triad_seed(study_seed, n)) for n in numbers])


def triad(fmu: GyroFmu, kind: Kind, seed: np.random.SeedSequence) -> Triad:
    """One triad; its seed decides all of it. Arguments as `block`."""
    generator = np.random.default_rng(seed)
    gyros = [_gyro(fmu, kind, generator) for _ in range(AXES)]
    return Triad(
        known=tuple(known for known, _, _ in gyros),
        benched=tuple(device for _, device, _ in gyros),
        flights=tuple(flown for _, _, flown in gyros),
        accelerometers=generator.normal(0.0, kind.accelerometer_bias, AXES),
        seed=generator.integers(2**63, size=2).astype(np.uint64),
    )


def _gyro(
    fmu: GyroFmu, kind: Kind, generator: np.random.Generator
) -> tuple[Knowledge, Device, Flight]:
    built = kind.population.draw(generator)
    maker, bench = generator.integers(2**63, size=2).tolist()
    device: Device = calibrated_gyro(fmu, built, kind.method, maker, kind.calibration)
    known = knowledge(fmu, device, kind.bench, bench)
    return known, device, flight(device, kind.drift, generator)


def gathered(fmu: GyroFmu, triads: list[Triad]) -> Triads:
    """As arrays; the true maps read off the FMU `HRGSlow`."""
    flights = [[_in_flight(fmu, flown) for flown in each.flights] for each in triads]

    def known(name: str) -> Array:
        return np.array([[getattr(gyro, name) for gyro in each.known] for each in triads])

    def stacked(values: list[list[Array]]) -> Array:
        return np.moveaxis(np.array(values), 1, -1)

    return Triads(
        fixed_stability=known("fixed_stability"),
        circumference_stability=known("circumference_stability"),
        instability=known("instability"),
        walk=known("walk"),
        known=stacked([[gyro.map.coefficients for gyro in each.known] for each in triads]),
        gain=stacked([[gyro.gain.coefficients for gyro in each.known] for each in triads]),
        variance=stacked([[gyro.variance for gyro in each.known] for each in triads]),
        true=stacked([_on_bench(fmu, each) for each in triads]),
        start_angle=np.array([[f.power_on_angle for f in each.flights] for each in triads]),
        rise=np.array([[f.rise for f in each.flights] for each in triads]),
        in_flight=stacked([[gyro[0] for gyro in each] for each in flights]),
        turning=stacked([[gyro[1] for gyro in each] for each in flights]),
        noise=stacked([[_noise(f.device) for f in each.flights] for each in triads]),
        accelerometers=np.array([each.accelerometers for each in triads]),
        seeds=np.array([each.seed for each in triads]),
    )


def _on_bench(fmu: GyroFmu, drawn: Triad) -> list[Array]:
    gyros = zip(drawn.benched, drawn.flights, strict=True)
    return [coefficients(fmu, device, flown.rise) for device, flown in gyros]


def _in_flight(fmu: GyroFmu, flown: Flight) -> tuple[Array, Array]:
    """Coefficients, and those that turn the pattern, from the power-on angle."""
    found, angle = coefficients(fmu, flown.device, flown.rise), flown.power_on_angle
    return started_at(found, angle), turning(flown.device, found, angle)


def _noise(device: Device) -> Array:
    """In the order of `noise_weights.KINDS`."""
    return np.array(
        [
            device.pickoff_noise,
            device.angle_random_walk,
            device.bias_instability,
            device.rate_random_walk,
        ]
    )
