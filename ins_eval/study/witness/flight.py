"""Flights of triads at 1 kHz with the channels that their gyros record of themselves."""

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np

from ins_eval.mission_model.missions import SETTLING, STILL
from ins_eval.study.cosimulated import (
    MissionTruth,
    align_and_navigate,
    make_increments,
    make_noise_seeds,
    tilt_input_axes,
)
from ins_eval.study.gyros.drawn_triad import AXES, DrawnTriad
from ins_eval.study.witness.disturbed import disturb_gyro
from ins_eval.study.witness.self_test import SETTLING as AFTER_TEST
from ins_eval.study.witness.self_test import rotate_virtually
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.fmu import CONTROL_PERIOD, Gyro, GyroFmu, record_together
from pyhrg.records.imu.log import Increments
from pyhrg.witness.replay import Witnesses
from pyhrg.witness.responses import FORCES

ROW = 0.1
"""Length of a row of the channels, s."""
PIECE = 60_000
"""Number of increments that are recorded at once; it bounds memory. Chosen: 10 min."""


@dataclass(frozen=True)
class ChannelFlight:
    """A flight of a triad from power-on.

    Attributes:
        truth: truth of the flight's mission.
        measured: increments of the IMU.
        witnesses: witness channels of each gyro, in rows of `ROW`.
        patterns: (n + 1, 3) detected pattern angles at the bounds of the increments, rad.
        self_test: duration of the self-test at power-on, s.
    """

    truth: MissionTruth
    measured: Increments
    witnesses: tuple[Witnesses, ...]
    patterns: Array
    self_test: float

    def navigate(self, error: Array | float = 0.0) -> Array:
        """(k, 2) error north and east, m, after errors (n, 3) of the gyros' increments, rad, were
        taken out."""
        raw = self.measured
        corrected = Increments(raw.interval, raw.rotation - error, raw.velocity, raw.start)
        begin = self.self_test + AFTER_TEST if self.self_test else SETTLING
        return align_and_navigate(self.truth, corrected, begin)


def fly_with_channels(
    fmu: GyroFmu,
    truth: MissionTruth,
    triads: Sequence[DrawnTriad],
    noise: Sequence[np.random.SeedSequence],
    self_test: float = 0.0,
    disturbances: Sequence[Sequence[Disturbance]] = (),
) -> list[ChannelFlight]:
    """Co-simulated flights with all noise, a seed of each triad; arguments as `cosimulate`.

    disturbances: effects outside the model, of each triad's gyros; none by default.
    """
    true = truth.increments
    count = len(true) - len(true) % round(ROW / true.interval)
    rotation = rotate_virtually(true.bounds[:-1] + STILL, self_test)
    seeds = [make_noise_seeds(each) for each in noise]
    disturbed = [
        disturb_gyro(each, truth, triad, axis, rotation)
        for triad, effects in zip(triads if disturbances else (), disturbances, strict=True)
        for axis, each in enumerate(effects)
    ]
    models = [each.disturbance.model for each in disturbed] or [{}] * (AXES * len(triads))
    added = [each.list_inputs() for each in disturbed]
    ends, means = [], []
    with ExitStack() as stack:
        flown = [f for triad in triads for f in triad.flights]
        numbers = [seed for gyros, _ in seeds for seed in gyros]
        on = [
            stack.enter_context(
                fmu.power_on({**f.device.fmu_parameters(), **model}, seed, f.power_on_angle)
            )
            for f, model, seed in zip(flown, models, numbers, strict=True)
        ]
        for first in range(0, len(true), PIECE):
            piece = slice(first, min(first + PIECE, len(true)))
            recorded = _record_piece(on, truth, triads, rotation, piece, added)
            ends.append(np.stack([each for each, _ in recorded], axis=1))
            means.append(np.stack([each for _, each in recorded], axis=1))
    read, averaged = np.concatenate(ends), np.concatenate(means)
    for place, each in enumerate(disturbed):
        each.change_records(read[:, place], averaged[:, place])
    flights = []
    for place, (triad, (_, accelerometers)) in enumerate(zip(triads, seeds, strict=True)):
        gyros = slice(AXES * place, AXES * (place + 1))
        start = [[f.power_on_angle for f in triad.flights]]
        patterns = np.concatenate([start, read[:, gyros, 1]])
        witnesses = tuple(
            _gather_witnesses(truth, patterns, averaged[:, gyros], rotation, axis, count)
            for axis in range(AXES)
        )
        measured = make_increments(truth, triad, read[:, gyros, 0], accelerometers)
        flights.append(ChannelFlight(truth, measured, witnesses, patterns, self_test))
    return flights


def _record_piece(
    on: list[Gyro],
    truth: MissionTruth,
    triads: Sequence[DrawnTriad],
    rotation: Array,
    piece: slice,
    added: Sequence[Mapping[str, Array]],
) -> list[tuple[Array, Array]]:
    """Readings at the end, and means over every control period, of each increment of a piece."""
    interval = truth.increments.interval
    ticks = round(interval / CONTROL_PERIOD)
    time = truth.increments.bounds[:-1][piece]
    turned = truth.increments.rotation[piece] / interval
    moving, held = [], []
    for triad in triads:
        rates = turned @ tilt_input_axes(triad.mounting).T
        for axis, flown in enumerate(triad.flights):
            moving.append({"angularRate": np.repeat(rates[:, axis][:, None], ticks, axis=1)})
            held.append(
                {f"acceleration{x}": truth.forces[axis][piece, i] for i, x in enumerate("XYZ")}
                | {
                    "caseTemperature": flown.case_temperature(time),
                    "virtualRotation": rotation[piece],
                }
            )
    for place, each in enumerate(added):
        inputs = {name: values[piece] for name, values in each.items()}
        moving[place]["angularRate"] += inputs.pop("angularRate")[:, None]
        held[place] |= inputs
    outputs = ["gyroAngle", "patternAngle"], [*FORCES, "frequencyOffset"]
    return record_together(on, moving, held, interval / ticks, *outputs)


def _gather_witnesses(
    truth: MissionTruth,
    patterns: Array,
    means: Array,
    rotation: Array,
    axis: int,
    count: int,
) -> Witnesses:
    parts = round(ROW / truth.increments.interval)

    def average(values: Array) -> Array:
        return np.asarray(values[:count].reshape(-1, parts, *values.shape[1:]).mean(axis=1))

    channels = average(means[:, axis])
    return Witnesses(
        interval=ROW,
        angle=patterns[: count + 1 : parts, axis],
        forces=channels[:, :2],
        frequency=channels[:, 2],
        virtual_rotation=average(rotation),
        specific_force=average(truth.forces[axis]),
    )
