"""The bias map as the estimator in the electronics corrects it, beside what a log tells of it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import TERMS
from pyhrg.witness.estimator import CORRECTED, arrange_parameters
from pyhrg.witness.fit import Flown, fit_changes
from pyhrg.witness.information import compute_maps_response
from pyhrg.witness.mechanisms import COUNT, change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import measure_channels, measure_responses
from tests.pyhrg.witness.flights import (
    GYRO,
    INTERVAL,
    PRIOR,
    RISE,
    compute_rms,
    draw_changes,
    fly,
    record_flight,
)

DRAWS = 1000
"""Number of bootstrap draws. Chosen."""
CHANGE = [f"controller.estimator.change[{place}]" for place in (1, 2, 3)]


@dataclass(frozen=True)
class Corrected:
    """Bias maps of a gyro at the end of a flight, (TERMS,), rad/s: the true change since its
    calibration; that by the electronics and by the log; the standard deviation of the latter;
    whether the electronics follow their estimate."""

    true: Array
    electronics: Array
    log: Array
    sigma: Array
    is_followed: bool


def correct_flights(
    fmus: tuple[GyroFmu, GyroFmu, GyroFmu],
    flights: int,
    duration: float,
    *,
    self_test: bool,
    drifts: bool,
) -> Iterator[Corrected]:
    """Flights, s, of gyros whose mechanisms drifted, or did not, each with the next seed.

    fmus: `HRG`, `HRGSlow` and `HRGSelfCorrecting`.
    """
    fast, slow, correcting = fmus
    responses = measure_responses(slow, GYRO)
    (channels,) = measure_channels(slow, [GYRO])
    parameters = arrange_parameters(GYRO, PRIOR, channels[0], responses)
    response = compute_maps_response(responses, RISE)[:TERMS]
    for seed in range(flights):
        changes = draw_changes(PRIOR, np.random.default_rng(seed)) if drifts else np.zeros(COUNT)
        device = change_device(GYRO, changes)
        log = fly(fast, device, duration, seed, self_test=self_test)
        (found,) = fit_changes(
            fast, slow, [Flown(GYRO, read_witnesses(log, GYRO), PRIOR, responses)]
        )
        corrected, is_followed = read_change(
            correcting, replace(device, model=parameters), duration, seed, self_test=self_test
        )
        covariance = response @ found.covariance @ response.T
        yield Corrected(
            response @ changes,
            corrected,
            response @ found.changes,
            np.sqrt(np.diag(covariance)),
            is_followed,
        )


def read_change(
    fmu: GyroFmu, device: Device, duration: float, seed: int, *, self_test: bool
) -> tuple[Array, bool]:
    """(TERMS,) change of the bias map that the electronics take out at the end of a flight, rad/s,
    and whether that is their estimate."""
    time = np.arange(0.0, duration, INTERVAL)
    names = [*CHANGE, "mapFollowed"]
    rows, _, _ = record_flight(fmu, device, time, seed, names, self_test=self_test)
    change = np.zeros(TERMS)
    change[CORRECTED] = rows[-1, 2:5]
    return change, bool(rows[-1, 5])


def list_figures(found: Sequence[Corrected]) -> list[float]:
    """Rms, 1e-3 deg/h, of the true change, of the errors by the electronics, by the log and by
    another gyro's electronics, and of the log's standard deviation."""
    others = np.roll([each.electronics for each in found], 1, axis=0)
    true, electronics, log, sigma = (
        np.array([getattr(each, name) for each in found])
        for name in ("true", "electronics", "log", "sigma")
    )
    maps = (true, electronics - true, log - true, others - true, sigma)
    return [1e3 * compute_rms(each) / DEG_PER_H for each in maps]


def bootstrap_ratio(found: Sequence[Corrected]) -> tuple[float, float]:
    """95 % interval over flights of the rms error by the electronics over the rms change."""
    generator = np.random.default_rng(0)
    drawn = generator.integers(len(found), size=(DRAWS, len(found)))
    ratios = []
    for numbers in drawn:
        true, left, *_ = list_figures([found[n] for n in numbers])
        ratios.append(left / true)
    low, high = np.quantile(ratios, (0.025, 0.975))
    return float(low), float(high)
