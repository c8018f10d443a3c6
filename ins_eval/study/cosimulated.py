"""Co-simulation of a triad: three FMUs at 1 kHz, accelerometers, mounting, nonlinear navigator.

With noise this is how a judged triad flies. Without noise it checks the linear model, which is the
predictor: how it treats the gyros' maps, their warming, mounting and accelerometers.
"""

from contextlib import ExitStack
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common.state import State, position_error
from ins_eval.imu.gyros import resolve_force_in_case
from ins_eval.imu.mounting import normalize_rows
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import list_slow_parameters
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.units import HOUR
from pyhrg.fmu import Gyro, GyroFmu, record_together
from pyhrg.records.imu.log import Increments

INTERVAL = 0.01
"""Interval of the IMU's increments, s. Chosen."""
AXES = 3
NOISE_IN_FLIGHT = 1
"""Number, in the seed of a co-simulation's noise, that sets it apart from the linear model's."""


@dataclass(frozen=True)
class Agreement:
    """Linear and nonlinear position error compared, rms over triads and times, m.

    Attributes:
        triads: number of triads.
        flown: rms of the nonlinear error.
        difference: rms of the difference.
    """

    triads: int
    flown: float
    difference: float

    @property
    def share(self) -> float:
        """Ratio of the difference to the nonlinear error."""
        return self.difference / self.flown


@dataclass(frozen=True)
class MissionTruth:
    """A mission as the co-simulation needs it: all that its triads share.

    Attributes:
        increments: true increments from power-on.
        forces: (3, n, 3) mean specific force along the axes of each gyro's case, m/s^2, without the
            lean of its input axis: 10 arcsec of it change a bias of 4e-4 deg/h per g by 2e-8 deg/h.
        start: true state after the alignment.
        height: (n,) true heights for the vertical channel, m.
        position: (k, 3) true positions at the kept times.
        kept: number of increments between these.
    """

    increments: Increments
    forces: Array
    start: State
    height: Array
    position: Array
    kept: int


def sample_truth(mission: StudyMission, interval: float = INTERVAL) -> MissionTruth:
    """The truth of a mission from power-on, in increments of this interval, s."""
    return sample_trajectory(mission.trajectory(), mission.hours * HOUR, mission.interval, interval)


def sample_trajectory(
    trajectory: Trajectory, duration: float, spacing: float, interval: float
) -> MissionTruth:
    """The truth along a trajectory from power-on, for this duration of navigation, s.

    spacing: time between kept positions, s; interval: of the increments, s.
    """
    steps, kept = round(duration / interval), round(spacing / interval)
    time = spacing * np.arange(1.0, steps // kept + 1)
    before = round(STILL / interval)
    increments = trajectory.increments(-STILL, interval, before + steps)
    return MissionTruth(
        increments=increments,
        forces=np.stack([resolve_force_in_case(increments, axis) for axis in np.eye(AXES)]),
        start=trajectory.state(0.0),
        height=trajectory.position(interval * np.arange(steps + 1.0))[:, 2],
        position=trajectory.position(time),
        kept=kept,
    )


def cosimulate(
    fmu: GyroFmu,
    truth: MissionTruth,
    triad: DrawnTriad,
    noise: np.random.SeedSequence | None = None,
) -> Array:
    """(k, 2) error north and east, m, of one triad that aligns itself and navigates.

    Args:
        fmu: `HRG`; or, without noise, `HRGSlow`, whose loops are in their steady state.
        noise: seed of the noise of gyros and accelerometers, from which each gyro gets its own;
            None leaves out all noise.
    """
    return align_and_navigate(truth, _measure(fmu, truth, triad, noise))


def align_at_rest(truth: MissionTruth, measured: Increments, settling: float) -> Array:
    """(3, 3) attitude at time 0 from these increments since `settling` s after power-on."""
    begin, zero = (round(time / measured.interval) for time in (settling, STILL))
    return level_and_gyrocompass(measured.between(begin, zero), truth.start.latitude)


def align_and_navigate(
    truth: MissionTruth, measured: Increments, settling: float = SETTLING
) -> Array:
    """(k, 2) error north and east, m, of a navigator with these increments.

    settling: time from power-on after which the alignment begins, s.
    """
    state = replace(truth.start, mat_nb=align_at_rest(truth, measured, settling))
    flight = measured.between(round(STILL / measured.interval), len(measured))
    track = navigate(state, flight, Clamped(truth.height), truth.kept)
    return position_error(track.position[-len(truth.position) :], truth.position)[:, :2]


def compare_errors(linear: Array, nonlinear: Array) -> Agreement:
    """Comparison of errors (r, k, 2), m, of the same triads."""

    def rms(errors: Array) -> float:
        return float(np.sqrt(np.square(errors).sum(-1).mean()))

    return Agreement(len(linear), rms(nonlinear), rms(linear - nonlinear))


def tilt_input_axes(mounting: Array) -> Array:
    """(3, 3) input axes in body axes, one a row, that lean by `mounting` (`TriadBlock`), rad."""
    leaning = [np.roll(np.diag(angles), ahead, axis=1) for ahead, angles in enumerate(mounting, 1)]
    return normalize_rows(np.eye(AXES) + sum(leaning))


def _measure(
    fmu: GyroFmu, truth: MissionTruth, triad: DrawnTriad, noise: np.random.SeedSequence | None
) -> Increments:
    """Increments of a triad from power-on; the navigator believes its input axes orthogonal."""
    true = truth.increments
    rates = true.rotation @ tilt_input_axes(triad.mounting).T / true.interval
    gyros, accelerometers = make_noise_seeds(noise) if noise else ([None] * AXES, None)
    time = true.bounds[:-1]
    moving = []
    for axis, flown in enumerate(triad.flights):
        inputs = {"angularRate": rates[:, axis], "caseTemperature": flown.case_temperature(time)}
        inputs |= {f"acceleration{x}": truth.forces[axis][:, i] for i, x in enumerate("XYZ")}
        moving.append({name: values[:, None] for name, values in inputs.items()})
    with ExitStack() as stack:
        on = [
            stack.enter_context(_power_on(fmu, flown, true.interval, seed))
            for flown, seed in zip(triad.flights, gyros, strict=True)
        ]
        recorded = record_together(on, moving, [{}] * AXES, true.interval, ["gyroAngle"])
    angles = np.hstack([angle for angle, _ in recorded])
    return make_increments(truth, triad, angles, accelerometers)


def make_increments(
    truth: MissionTruth, triad: DrawnTriad, angles: Array, noise: np.random.Generator | None
) -> Increments:
    """Increments of a triad from power-on.

    angles: (n, 3) output of the gyros at the end of each interval, rad; noise: generator of the
    accelerometers' noise, None for none.
    """
    true = truth.increments
    velocity = true.velocity + true.interval * triad.accelerometers
    if noise is not None:
        deviation = TYPICAL_ACCELEROMETERS.random_walk * np.sqrt(true.interval)
        velocity += deviation * noise.standard_normal(velocity.shape)
    return Increments(true.interval, np.diff(angles, axis=0, prepend=0.0), velocity, -STILL)


def seed_noise(triad: DrawnTriad, mission: int) -> np.random.SeedSequence:
    """Seed of a triad's noise in a mission of a study, by its number."""
    return np.random.SeedSequence(triad.seed.tolist(), spawn_key=(mission, NOISE_IN_FLIGHT))


def make_noise_seeds(noise: np.random.SeedSequence) -> tuple[list[int], np.random.Generator]:
    """Seeds of the gyros' noise, which the FMU takes from 0 to 2^31 - 1, and the generator of the
    accelerometers' noise."""
    seeds = noise.generate_state(AXES + 1, np.uint32)
    return (seeds[:AXES] >> 1).tolist(), np.random.default_rng(int(seeds[AXES]))


def _power_on(fmu: GyroFmu, flown: Flight, interval: float, seed: int | None) -> Gyro:
    """A gyro of a triad, switched on; without noise if seed is None."""
    device = flown.device if seed is not None else flown.device.without_noise()
    parameters = device.fmu_parameters()
    if not fmu.is_sampled:
        parameters = {**list_slow_parameters(device), "samplePeriod": interval}
    return fmu.power_on(parameters, seed=seed or 0, start_angle=flown.power_on_angle)
