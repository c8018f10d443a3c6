"""Co-simulation of a sample of triads: the gyros' FMU at 1 kHz and the nonlinear navigator.

Noise is left out, because its errors are random in either case. The comparison checks how the
linear model treats the gyros' maps, their warming and the accelerometers.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common.state import State, position_error
from ins_eval.imu.gyros import resolve_force_in_case
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import list_slow_parameters
from pyhrg.fmu import GyroFmu
from pyhrg.records.imu.increments import Increments

Array = NDArray[np.float64]

INTERVAL = 0.01
"""Interval of the IMU's increments, s. Chosen."""


@dataclass(frozen=True)
class Agreement:
    """Linear and nonlinear position error compared, rms over triads and times, m.

    triads: number of triads; flown: rms of the nonlinear error; difference: rms of the difference;
    worst: largest ratio of the two for a single triad.
    """

    triads: int
    flown: float
    difference: float
    worst: float

    @property
    def share(self) -> float:
        """Ratio of the difference to the nonlinear error."""
        return self.difference / self.flown


@dataclass(frozen=True)
class MissionTruth:
    """A mission as the nonlinear navigator needs it.

    increments: true increments from power-on; start: true state after the alignment; height: (n,)
    true heights for the vertical channel, m; position: (k, 3) true positions at the kept times;
    kept: number of increments between these.
    """

    increments: Increments
    start: State
    height: Array
    position: Array
    kept: int


def sample_truth(mission: StudyMission, interval: float = INTERVAL) -> MissionTruth:
    """The truth of a mission from power-on, in increments of this interval, s."""
    trajectory = mission.trajectory()
    duration = mission.hours * 3600
    steps = round(duration / interval)
    kept = round(mission.interval / interval)
    time = mission.interval * np.arange(1.0, steps // kept + 1)
    before = round(STILL / interval)
    return MissionTruth(
        increments=trajectory.increments(-STILL, interval, before + steps),
        start=trajectory.state(0.0),
        height=trajectory.position(interval * np.arange(steps + 1.0))[:, 2],
        position=trajectory.position(time),
        kept=kept,
    )


def cosimulate(fmu: GyroFmu, truth: MissionTruth, triad: DrawnTriad) -> Array:
    """(k, 2) error north and east, m, of one triad without noise.

    Args:
        fmu: `HRG`, or `HRGSlow`, whose loops are in their steady state.
        truth: the mission.
        triad: the triad.
    """
    true = truth.increments
    rotation = np.stack(
        [_simulate_gyro(fmu, f, true, axis) for axis, f in enumerate(triad.flights)], axis=-1
    )
    interval = true.interval
    velocity = true.velocity + interval * triad.accelerometers
    measured = Increments(interval, rotation, velocity, -STILL)
    begin, zero = round(SETTLING / interval), round(STILL / interval)
    start = truth.start
    mat_nb = level_and_gyrocompass(measured.between(begin, zero), start.latitude)
    state = State(start.latitude, start.longitude, start.height, start.velocity, mat_nb)
    flight = measured.between(zero, len(measured))
    track = navigate(state, flight, Clamped(truth.height), truth.kept)
    return position_error(track.position[-len(truth.position) :], truth.position)[:, :2]


def compare_errors(linear: Array, nonlinear: Array) -> Agreement:
    """Comparison of errors (r, k, 2), m, of the same triads."""
    difference = np.square(linear - nonlinear).sum(-1)
    size = np.square(nonlinear).sum(-1)
    return Agreement(
        triads=len(linear),
        flown=float(np.sqrt(size.mean())),
        difference=float(np.sqrt(difference.mean())),
        worst=float(np.sqrt((difference.mean(-1) / size.mean(-1)).max())),
    )


def _simulate_gyro(fmu: GyroFmu, flown: Flight, true: Increments, axis: int) -> Array:
    """(n,) increments of a gyro's angle along a body axis, rad, while its case warms."""
    input_axis = np.eye(3)[axis]
    inputs = {
        "angularRate": true.rotation[:, axis] / true.interval,
        "caseTemperature": flown.case_temperature(true.bounds[:-1]),
    }
    force = resolve_force_in_case(true, input_axis)
    inputs |= {f"acceleration{name}": force[:, i] for i, name in enumerate("XYZ")}
    moving = {name: values[:, None] for name, values in inputs.items()}
    quiet = flown.device.without_noise().fmu_parameters()
    if not fmu.is_sampled:
        quiet = {**list_slow_parameters(flown.device), "samplePeriod": true.interval}
    with fmu.power_on(quiet, seed=0, start_angle=flown.power_on_angle) as gyro:
        angle = gyro.record(moving, {}, true.interval, ["gyroAngle"])[0][:, 0]
    return np.diff(angle, prepend=0.0)
