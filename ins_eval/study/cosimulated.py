"""A sample of triads flown for real: the gyros' FMU at 1 kHz and the navigator, not linearised.

Without noise, whose errors are a draw in either case: what is compared is what the linear model
makes of the gyros' maps, their warming and the accelerometers.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import static_alignment
from ins_eval.common.increments import Increments
from ins_eval.common.state import State, position_error
from ins_eval.imu.gyros import case_force
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.study.block import Triad
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import slow_parameters
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


def truth(mission: StudyMission, interval: float = INTERVAL) -> Truth:
    """Of a mission from power-on, in increments of this interval, s."""
    trajectory = mission.trajectory()
    duration = mission.hours * 3600
    steps = round(duration / interval)
    kept = round(mission.kept / interval)
    time = mission.kept * np.arange(1.0, steps // kept + 1)
    before = round(STILL / interval)
    return Truth(
        increments=trajectory.increments(-STILL, interval, before + steps),
        start=trajectory.state(0.0),
        height=trajectory.position(interval * np.arange(steps + 1.0))[:, 2],
        position=trajectory.position(time),
        kept=kept,
    )


def cosimulated(fmu: GyroFmu, flying: Truth, triad: Triad) -> Array:
    """(k, 2) error north and east, m, of one triad without noise.

    Args:
        fmu: `HRG`, or `HRGSlow`, whose loops are at rest.
        flying: the mission.
        triad: what flies.
    """
    true = flying.increments
    rotation = np.stack(
        [_measured(fmu, f, true, axis) for axis, f in enumerate(triad.flights)], axis=-1
    )
    interval = true.interval
    velocity = true.velocity + interval * triad.accelerometers
    measured = Increments(interval, rotation, velocity, -STILL)
    begin, zero = round(SETTLING / interval), round(STILL / interval)
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


def _measured(fmu: GyroFmu, flown: Flight, true: Increments, axis: int) -> Array:
    """(n,) increments of a gyro's angle along a body axis, rad; its case warms."""
    input_axis = np.eye(3)[axis]
    inputs = {
        "angularRate": true.rotation[:, axis] / true.interval,
        "caseTemperature": flown.case_temperature(true.bounds[:-1]),
    }
    force = case_force(true, input_axis)
    inputs |= {f"acceleration{name}": force[:, i] for i, name in enumerate("XYZ")}
    moving = {name: values[:, None] for name, values in inputs.items()}
    quiet = flown.device.without_noise().fmu_parameters()
    if not fmu.is_sampled:
        quiet = {**slow_parameters(flown.device), "samplePeriod": true.interval}
    with fmu.power_on(quiet, seed=0, start_angle=flown.power_on_angle) as gyro:
        angle = gyro.record(moving, {}, true.interval, ["gyroAngle"])[0][:, 0]
    return np.diff(angle, prepend=0.0)
