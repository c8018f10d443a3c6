"""Estimates of gyros that are known as a bench leaves them, with the bench's error drawn."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.witness.uncertainty import compute_map_deviation
from ins_eval.study.gyros.drawn_triad import TriadDistribution
from ins_eval.study.gyros.drift import draw_flight
from ins_eval.study.gyros.population import RAW
from ins_eval.study.witness.believed import believe_gyro
from ins_eval.study.witness.witnessed import read_true_changes
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import TERMS
from pyhrg.witness.fit import Flown, fit_changes
from pyhrg.witness.information import compute_normalized_square
from pyhrg.witness.mechanisms import change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import measure_output
from tests.pyhrg.witness.flights import compute_rms, fly

DURATION = 600.0
FIRST_SEED = 1000


@dataclass(frozen=True)
class Benched:
    """One gyro. square, degrees: normalised square of the error; estimated, believed, sigma: rms
    over the circumference of the bias map's error by the estimate, before the flight, and as
    stated, deg/h; p_value: of the estimate."""

    square: float
    degrees: int
    estimated: float
    believed: float
    sigma: float
    p_value: float


def estimate_benched(
    fast: GyroFmu, slow: GyroFmu, count: int, self_test: bool
) -> Iterator[Benched]:
    """Gyros of the study in flights of ten minutes."""
    distribution, gyros, flights = TriadDistribution(population=RAW, method="map"), [], []
    for number in range(count):
        generator = np.random.default_rng(FIRST_SEED + number)
        device = RAW.draw(generator)
        believed = believe_gyro(slow, device, distribution, generator)
        flight = draw_flight(device, distribution.drift, generator)
        log = fly(fast, flight.device, DURATION, number, self_test=self_test)
        witnesses = read_witnesses(log, believed.device)
        gyros.append(Flown(believed.device, witnesses, believed.prior, believed.responses))
        flights.append(flight)
    fits = fit_changes(fast, slow, gyros)
    for gyro, flight, found in zip(gyros, flights, fits, strict=True):
        error = found.changes - read_true_changes(gyro.device, flight)
        true, estimated, before = (
            measure_output(slow, each, found.temperature)[:TERMS]
            for each in (
                flight.device,
                change_device(gyro.device, found.changes),
                change_device(gyro.device, gyro.prior.mean),
            )
        )
        yield Benched(
            *compute_normalized_square(error, found.covariance),
            compute_rms(estimated - true) / DEG_PER_H,
            compute_rms(before - true) / DEG_PER_H,
            compute_map_deviation(found.responses, found.covariance, found.temperature) / DEG_PER_H,
            found.p_value,
        )
