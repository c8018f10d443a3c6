"""A triad of gyros flown in each of the cases."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.imu.gyros import GyroOutput
from ins_eval.mission_model.missions import STILL
from ins_eval.parking.gyro import ANGLES, CASES, LIMIT, Case, Known, MappedGyro, Start, fly_together
from ins_eval.parking.mission import INTERVAL, Mission, find_ready_time
from pyhrg.bench.bench import Bench
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

VERTICAL = 2
"""Axis of the gyro that is not parked: turns of the vehicle take its pattern all round."""
DRIVES = 10
"""Simulations of a gyro through the mission, a triad: three as they come, two level ones parked at
each of two angles, three with maps."""
RECORDS = ("running", "ready", "valid", "power_on")
"""Which part of the five minutes at rest alignment uses. `running`: all, with gyros that were
switched on before; `ready`: from when the last gyro is ready; `valid`: from when the last output is
valid; `power_on`: all, with gyros that are switched on as they begin."""
RUNNING = 60.0
"""Time from switch-on to the five minutes in the case `running`, s."""


@dataclass(frozen=True)
class TriadFlights:
    """One triad in each of `CASES`.

    Attributes:
        radial: (cases, m) position error, m.
        heading: (cases,) error of alignment, rad.
        ready: (cases,) when the last gyro was ready, s since power-on.
        start_up: (records,) heading error, rad, with maps, by what alignment uses (`RECORDS`).
    """

    radial: Array
    heading: Array
    ready: Array
    start_up: Array


def fly_triad(gyros: Sequence[MappedGyro], velocity: Array, mission: Mission) -> TriadFlights:
    """All cases, with the same noise and the same accelerometers.

    velocity: (n, 3) increments of the accelerometers, m/s.
    """
    flown = _fly_all(gyros, mission.truth.increments)
    radial, heading, ready = [], [], []
    for case in CASES:
        flights = [flown[axis, *_choose_start(axis, case)] for axis in range(3)]
        measured = _measure(gyros, flights, velocity, case)
        begin = max(find_ready_time(each.ready) for each in flights)
        error = mission.fly(measured, begin)
        radial.append(np.hypot(error[:, 0], error[:, 1]))
        heading.append(mission.heading_error(measured, begin))
        ready.append(begin + STILL)
    flights = [flown[axis, *_choose_start(axis, LIMIT)] for axis in range(3)]
    start_up = _start_up(gyros, flights, velocity, mission)
    return TriadFlights(np.stack(radial), np.array(heading), np.array(ready), start_up)


def _fly_all(
    gyros: Sequence[MappedGyro], truth: Increments
) -> dict[tuple[int, Start, bool], GyroOutput]:
    """Outputs by axis, start and whether the maps are in the electronics."""
    groups = [
        [(axis, Start.AS_IT_COMES, False) for axis in range(3)],
        [(axis, start, False) for start in ANGLES for axis in range(VERTICAL)],
        [(axis, Start.AS_IT_COMES, True) for axis in range(3)],
    ]
    flown: dict[tuple[int, Start, bool], GyroOutput] = {}
    for group in groups:
        benches = [_set_up(gyros[axis], start, with_maps) for axis, start, with_maps in group]
        outputs = fly_together(benches, [axis for axis, _, _ in group], truth)
        flown |= dict(zip(group, outputs, strict=True))
    return flown


def _set_up(gyro: MappedGyro, start: Start, with_maps: bool) -> Bench:
    angle = None if start is Start.AS_IT_COMES else ANGLES[start](gyro.bias)
    return gyro.set_up(angle, with_maps)


def _choose_start(axis: int, case: Case) -> tuple[Start, bool]:
    start = Start.AS_IT_COMES if axis == VERTICAL else case.start
    return start, case.known is Known.MAP


def _measure(
    gyros: Sequence[MappedGyro], flights: Sequence[GyroOutput], velocity: Array, case: Case
) -> Increments:
    """Increments less what is known of the biases."""
    rotation = np.stack([flight.rotation for flight in flights], axis=-1)
    for axis, (gyro, flight) in enumerate(zip(gyros, flights, strict=True)):
        level_only = axis == VERTICAL and case.known is Known.AT_START
        known = Known.MEAN if level_only else case.known
        first = round((find_ready_time(flight.ready) + STILL) / INTERVAL)
        angle = float(flight.pattern_angle[first])
        rotation[:, axis] -= gyro.compute_known_bias(known, angle) * INTERVAL
    return Increments(INTERVAL, rotation, velocity, -STILL)


def _start_up(
    gyros: Sequence[MappedGyro],
    flights: Sequence[GyroOutput],
    velocity: Array,
    mission: Mission,
) -> Array:
    """Heading errors in the order of `RECORDS`; all with the whole maps taken out."""
    truth = mission.truth.increments
    rest, before = round(STILL / INTERVAL), round(RUNNING / INTERVAL)
    rows = np.arange(-before, rest).clip(min=0)
    longer = Increments(INTERVAL, truth.rotation[rows], truth.velocity[rows], -STILL - RUNNING)
    early = fly_together([gyro.set_up(None, True) for gyro in gyros], range(3), longer)
    running = np.stack([flight.rotation[before:] for flight in early], axis=-1)
    started = _measure(gyros, flights, velocity, LIMIT)
    errors = [mission.heading_error(Increments(INTERVAL, running, velocity[:rest], -STILL))]
    for good in ("ready", "valid"):
        begin = max(find_ready_time(getattr(flight, good)) for flight in flights)
        errors.append(mission.heading_error(started, begin))
    return np.array([*errors, mission.heading_error(started)])
