"""Estimates from the channels of triads' gyros in flights, and their position errors."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ins_eval.imu.gyros import resolve_force_in_case
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import STILL
from ins_eval.mission_model.signals import compute_resonator_warmth
from ins_eval.study.gyros.drawn_triad import AXES, DrawnTriad
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.witness.believed import BelievedGyro
from ins_eval.study.witness.estimated_map import (
    EstimatedMap,
    compute_angle_errors,
    compute_estimated_map,
    predict_error,
)
from ins_eval.study.witness.flight import ChannelFlight
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import FMU_FIELDS
from pyhrg.fmu import GyroFmu
from pyhrg.witness.fit import FittedChanges, Flown, fit_changes
from pyhrg.witness.information import compute_normalized_square
from pyhrg.witness.mechanisms import TEMPERATURE_RATE, read_values
from pyhrg.witness.replay import Witnesses
from pyhrg.witness.responses import Responses


@dataclass(frozen=True)
class WitnessedFlight:
    """Results of one flight, at its end; errors are north and east, m.

    Attributes:
        flown: (2,) error of the flight.
        by_bench: error of the same record, corrected by the maps that the bench knows.
        by_channels: error, corrected by the maps that the channels of the whole flight give.
        by_self_test: error, corrected by the maps that the channels give until the alignment ends.
        estimated, known: (2,) error that the maps estimated from the channels make, and those known
            from the bench.
        estimated_covariance, known_covariance: (2, 2) of these, m^2, without noise and mounting.
        squares, degrees: (3,) normalised squares of the estimated changes' errors, and degrees of
            freedom.
        p_values: (3,) as of `Filtered`.
        followed: (3,) whether each gyro's log is followed, 1 or 0.
    """

    flown: Array
    by_bench: Array
    by_channels: Array
    by_self_test: Array
    estimated: Array
    known: Array
    estimated_covariance: Array
    known_covariance: Array
    squares: Array
    degrees: Array
    p_values: Array
    followed: Array


def read_true_changes(device: Device, flight: Flight) -> Array:
    """(COUNT,) changes of the mechanisms from a device to a gyro in flight, SI."""
    drawn: dict[str, Any] = {
        FMU_FIELDS[n]: v for n, v in flight.device.model.items() if n in FMU_FIELDS
    }
    flown = replace(flight.device, **drawn)
    changes = read_values(flown) - read_values(device)
    # what acts by the rate of temperature is absolute, because a replay leaves it out
    return np.where(TEMPERATURE_RATE, read_values(flown), changes)


def witness_flights(
    fmus: tuple[GyroFmu, GyroFmu],
    weights: MissionWeights,
    triads: Sequence[DrawnTriad],
    believed: Sequence[Sequence[BelievedGyro]],
    flights: Sequence[ChannelFlight],
) -> list[WitnessedFlight]:
    """Estimates from flights of triads with one kind of start, predictions, and corrections.

    fmus: `HRG` and `HRGSlow`; weights: at the mission's end alone; believed: gyros of each triad.
    """
    fits = _fit(fmus, believed, [each.witnesses for each in flights])
    early = fits
    if flights[0].self_test:
        aligned = round(STILL / flights[0].witnesses[0].interval)
        before = [[each.take(aligned) for each in flight.witnesses] for flight in flights]
        early = _fit(fmus, believed, before)
    return [
        _judge(fmus[1], weights, *each)
        for each in zip(triads, believed, flights, fits, early, strict=True)
    ]


def _judge(
    slow: GyroFmu,
    weights: MissionWeights,
    triad: DrawnTriad,
    believed: Sequence[BelievedGyro],
    flight: ChannelFlight,
    fits: Sequence[FittedChanges],
    early: Sequence[FittedChanges],
) -> WitnessedFlight:
    """early: estimates until the alignment ended."""
    known = _estimate_maps(slow, believed, None, flight)
    estimated = _estimate_maps(slow, believed, fits, flight)
    start, none = flight.patterns[0], np.zeros((1, 1, 2, 2))
    predictions = [predict_error(weights, maps, start, none) for maps in (estimated, known)]
    true = [read_true_changes(b.device, f) for b, f in zip(believed, triad.flights, strict=True)]
    scored = [
        compute_normalized_square(estimated_changes - changes, covariance)
        for (estimated_changes, covariance, _), changes in zip(
            map(_follow, believed, fits), true, strict=True
        )
    ]
    return WitnessedFlight(
        flown=flight.navigate()[-1],
        by_bench=_correct(flight, known),
        by_channels=_correct(flight, estimated),
        by_self_test=_correct(flight, _estimate_maps(slow, believed, early, flight))
        if flight.self_test
        else np.full(2, np.nan),
        estimated=predictions[0].expected[0, -1],
        known=predictions[1].expected[0, -1],
        estimated_covariance=predictions[0].covariance[0, -1],
        known_covariance=predictions[1].covariance[0, -1],
        squares=np.array([square for square, _ in scored]),
        degrees=np.array([float(degrees) for _, degrees in scored]),
        p_values=np.array([fit.p_value for fit in fits]),
        followed=np.array([float(fit.is_explained) for fit in fits]),
    )


def _fit(
    fmus: tuple[GyroFmu, GyroFmu],
    believed: Sequence[Sequence[BelievedGyro]],
    witnesses: Sequence[Sequence[Witnesses]],
) -> list[list[FittedChanges]]:
    """Estimates of the gyros of each triad, replayed side by side."""
    gyros = [
        Flown(b.device, w, b.prior, b.responses)
        for triad, channels in zip(believed, witnesses, strict=True)
        for b, w in zip(triad, channels, strict=True)
    ]
    fits = fit_changes(*fmus, gyros)
    return [fits[first : first + AXES] for first in range(0, len(fits), AXES)]


def _estimate_maps(
    slow: GyroFmu,
    believed: Sequence[BelievedGyro],
    fits: Sequence[FittedChanges] | None,
    flight: ChannelFlight,
) -> list[EstimatedMap]:
    """Maps of the gyros by estimates, or by what is known before the flight."""
    estimated = []
    for axis in range(AXES):
        gyro, witnesses = believed[axis], flight.witnesses[axis]
        rise = _read_rise(gyro.device, witnesses)
        known = _follow(gyro, fits[axis] if fits else None)
        estimated.append(compute_estimated_map(slow, gyro.device, *known, rise))
    return estimated


def _follow(gyro: BelievedGyro, fit: FittedChanges | None) -> tuple[Array, Array, Responses]:
    """Changes, their covariance, and the sensitivities with them: those of the prior without an
    estimate and where the forces contradict it."""
    if fit and fit.is_explained:
        return fit.changes, fit.covariance, fit.responses
    return gyro.prior.mean, gyro.prior.covariance, gyro.responses


def _read_rise(device: Device, witnesses: Witnesses) -> float:
    """Final rise of a gyro's temperature, K, by its frequency at the end of a flight."""
    last = max(1, round(10.0 / witnesses.interval))
    end = witnesses.interval * len(witnesses.frequency) - STILL
    frequency = float(np.mean(witnesses.frequency[-last:]))
    temperature = frequency / (device.frequency * device.frequency_per_kelvin)
    return temperature / float(compute_resonator_warmth(np.array(end)))


def _correct(flight: ChannelFlight, estimated: Sequence[EstimatedMap]) -> Array:
    time, rotation = flight.measured.bounds, flight.measured.rotation
    errors = []
    for axis, each in enumerate(estimated):
        force = resolve_force_in_case(flight.measured, np.eye(AXES)[axis])
        pattern = flight.patterns[:, axis]
        errors.append(compute_angle_errors(each, pattern, time, rotation[:, axis], force))
    return np.asarray(flight.navigate(np.stack(errors, axis=-1))[-1])
