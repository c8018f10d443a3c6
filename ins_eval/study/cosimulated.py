"""A sample of triads flown for real: the gyros' FMU at 1 kHz and the navigator, not linearised.

Without noise, whose errors are a draw in either case: what is compared is what the linear model
makes of the gyros' maps, their warming and the accelerometers.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import static_alignment
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.state import State, position_error
from ins_eval.study.block import Triad
from ins_eval.study.drift import Flight
from ins_eval.study.missions import SETTLING, STILL, StudyMission
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

INTERVAL = 0.01
"""Of the IMU's increments, s."""


@dataclass(frozen=True)
class Agreement:
    """Linear against nonlinear, rms over n triads and the told times, m.

    flown: of the nonlinear error; apart: of the difference; worst: largest share of a triad's own.
    """

    triads: int
    flown: float
    apart: float
    worst: float

    @property
    def share(self) -> float:
        """Of the ensemble's rms that the two are apart."""
        return self.apart / self.flown


@dataclass(frozen=True)
class Truth:
    """A mission as the nonlinear navigator needs it."""

    increments: Increments
    start: State
    height: Array
    position: Array
    kept: int


def truth(mission: StudyMission) -> Truth:
    """Of a mission from power-on."""
    trajectory = mission.trajectory()
    duration = mission.hours * 3600
    steps = round(duration / INTERVAL)
    kept = round(mission.kept / INTERVAL)
    time = mission.kept * np.arange(1.0, steps // kept + 1)
    before = round(STILL / INTERVAL)
    return Truth(
        increments=trajectory.increments(-STILL, INTERVAL, before + steps),
        start=trajectory.state(0.0),
        height=trajectory.position(INTERVAL * np.arange(steps + 1.0))[:, 2],
        position=trajectory.position(time),
        kept=kept,
    )


def cosimulated(fmu: GyroFmu, flying: Truth, triad: Triad) -> Array:
    """(k, 2) error north and east, m, of one triad without noise.

    Args:
        fmu: `HRG`.
        flying: the mission.
        triad: what flies.
    """
    true = flying.increments
    rotation = np.stack(
        [_measured(fmu, f, true.rotation[:, axis]) for axis, f in enumerate(triad.flights)], axis=-1
    )
    velocity = true.velocity + INTERVAL * triad.accelerometers
    measured = Increments(INTERVAL, rotation, velocity, -STILL)
    begin, zero = round(SETTLING / INTERVAL), round(STILL / INTERVAL)
    start = flying.start
    mat_nb = static_alignment(measured.between(begin, zero), start.latitude)
    state = State(start.latitude, start.longitude, start.height, start.velocity, mat_nb)
    flight = measured.between(zero, len(measured))
    track = navigate(state, flight, Clamped(flying.height), flying.kept)
    return position_error(track.position[-len(flying.position) :], flying.position)[:, :2]


def agreement(linear: Array, nonlinear: Array) -> Agreement:
    """Of errors (r, k, 2), m, of the same triads."""
    apart, size = np.square(linear - nonlinear).sum(-1), np.square(nonlinear).sum(-1)
    return Agreement(
        triads=len(linear),
        flown=float(np.sqrt(size.mean())),
        apart=float(np.sqrt(apart.mean())),
        worst=float(np.sqrt((apart.mean(-1) / size.mean(-1)).max())),
    )


def _measured(fmu: GyroFmu, flown: Flight, rotation: Array) -> Array:
    """(n,) increments of a gyro's angle, rad."""
    quiet: Device = flown.warming.without_noise()
    with fmu.power_on(quiet.fmu_parameters(), seed=0, start_angle=flown.power_on_angle) as gyro:
        angle = gyro.drive(rotation / INTERVAL, INTERVAL)
    return np.diff(angle, prepend=0.0)
