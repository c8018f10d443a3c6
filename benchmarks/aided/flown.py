"""Triads of the study's population on the FMU at 1 kHz, with position fixes and then without."""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.aided.known import KNOWN, learn_deviations, list_states, make_bench_maps
from ins_eval.aided.bench_maps import choose_bench_maps, take_bench_maps
from ins_eval.aided.bias_map import BiasMap, read_bias_map
from ins_eval.aided.correction import correct_increments
from ins_eval.aided.fixes import Fixes, make_position_fixes
from ins_eval.aided.kalman.backward import Adjoint, smooth
from ins_eval.aided.kalman.drive import Drive, measure_turn, sample_drive
from ins_eval.aided.kalman.forward import SEGMENT, Filter, Filtered, list_noise, run_filter
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.aided.kalman.start import align_in_motion
from ins_eval.common.state import displace, position_error
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.linear_model import linearize
from ins_eval.mission_model.bench_map import BenchMap
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.missions import SETTLING, StudyMission, plan_mission
from ins_eval.mission_model.signals import (
    compute_resonator_warmth,
)
from ins_eval.navigation.height import Clamped, Free
from ins_eval.navigation.strapdown import navigate
from ins_eval.study.cosimulated import (
    AXES,
    MissionTruth,
    align_and_navigate,
    make_increments,
    make_noise_seeds,
    sample_truth,
    seed_noise,
    tilt_input_axes,
)
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
)
from ins_eval.study.gyros.true_maps import read_flight_coefficients
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.units import HOUR
from pyhrg.fmu import GyroFmu, record_together
from pyhrg.records.imu.log import Increments

MISSIONS = ("car", "city", "airliner", "ship")
AIDED_HOURS, FREE_HOURS = 2.0, 1.0
FIX_SPACING, FIX_SIGMA = 1.0, 2.0
"""Of the position fixes, s, and of each component, m."""
FIRST_JUDGED, STUDY_SEED, FIX_SEED = 100, 1, 3
NO_ARM = np.zeros(3)


@dataclass(frozen=True)
class Told:
    """Maps at the end of the fixes and before the drive, and the horizontal error after
    `FREE_HOURS` without fixes, m, with the errors found; used: number of the bench's maps that the
    drive did not contradict."""

    maps: BiasMap
    prior: BiasMap
    free: float
    used: int = 0


@dataclass(frozen=True)
class AidedTriad:
    """One triad.

    own: with the population as prior; benched, misled: with the bench's maps as well, its own and
    those of the triad before; true, bench: maps at the end of the fixes; innovation: normalised
    innovation squared over its degrees; uncorrected, shuffled: horizontal error after `FREE_HOURS`
    without fixes, m, without the errors found, and with those found of another triad; alone: after
    as long from an alignment at rest, without fixes, m; by_noise: (2, 2) covariance of the
    position, m^2, that the sensors' noise after the last fix makes of a navigator that knows all
    else.
    """

    mission: str
    own: Told
    benched: Told
    misled: Told
    true: Array
    bench: Array
    innovation: float
    uncorrected: float
    shuffled: float
    alone: float
    by_noise: Array


def fly_triads(
    fmus: tuple[GyroFmu, GyroFmu], distribution: TriadDistribution, learning: int, count: int
) -> Iterator[AidedTriad]:
    """Triads in turn on `MISSIONS`; fmus: `HRG` and `HRGSlow`."""
    deviations = learn_deviations(fmus[1], distribution, learning)
    missions = [plan_mission(name, AIDED_HOURS + FREE_HOURS) for name in MISSIONS]
    truths = [sample_truth(mission) for mission in missions]
    other: tuple[Array, dict[int, BenchMap]] | None = None
    for number in range(count):
        seed = make_triad_seed(STUDY_SEED, FIRST_JUDGED + number)
        triad = draw_triad(fmus[1], distribution, seed)
        place = number % len(missions)
        generator = np.random.default_rng([FIX_SEED, number])
        flown = _Flown(fmus[0], missions[place], truths[place], triad, generator)
        states = list_states(distribution, triad, deviations)
        maps = make_bench_maps(fmus[1], distribution, triad)
        found = flown.filter(states)
        another = other or (0 * found.coefficients, {})
        yield flown.judge(fmus[1], found, maps, another)
        other = found.coefficients, maps


def measure(
    fast: GyroFmu, truth: MissionTruth, triad: DrawnTriad, noise: np.random.SeedSequence
) -> tuple[Increments, Array]:
    """Increments of a triad from power-on, and (n, 3) detected pattern angles, rad."""
    true = truth.increments
    rates = true.rotation @ tilt_input_axes(triad.mounting).T / true.interval
    seeds, accelerometers = make_noise_seeds(noise)
    moving = []
    for axis, flown in enumerate(triad.flights):
        inputs = {
            "angularRate": rates[:, axis],
            "caseTemperature": flown.case_temperature(true.bounds[:-1]),
        }
        inputs |= {f"acceleration{x}": truth.forces[axis][:, i] for i, x in enumerate("XYZ")}
        moving.append({name: values[:, None] for name, values in inputs.items()})
    with ExitStack() as stack:
        on = [
            stack.enter_context(
                fast.power_on(f.device.fmu_parameters(), seed=seed, start_angle=f.power_on_angle)
            )
            for f, seed in zip(triad.flights, seeds, strict=True)
        ]
        names = ["gyroAngle", "patternAngle"]
        recorded = record_together(on, moving, [{}] * AXES, true.interval, names)
    ends = np.stack([each for each, _ in recorded], axis=1)
    return make_increments(truth, triad, ends[:, :, 0], accelerometers), ends[:, :, 1]


def propagate(
    drive: Drive,
    first: int,
    states: SensorStates,
    truth: Trajectory,
    mean: Array | float = 0.0,
    covariance: Array | float = 0.0,
) -> tuple[Array, Array]:
    """Mean (2,), m, and covariance (2, 2), m^2, of the position error at a drive's end, by errors
    (n,) of a covariance (n, n) at a step and by the noise from there on."""
    kalman = Filter(states, np.zeros((COUNT, COUNT)), drive.step)
    kalman.mean[:], kalman.covariance[:] = mean, covariance
    for begin in range(first, drive.steps, round(SEGMENT / drive.step)):
        end = min(begin + round(SEGMENT / drive.step), drive.steps)
        at = truth.state(drive.increments.start + begin * drive.step)
        _, motion = drive.navigate(at, begin, end)
        model = linearize(motion, Free(), states.effects)
        noise = list_noise(model.constant_errors, states.noise, drive.step)
        for k in range(len(model)):
            kalman.predict(model.transition[k], model.inputs[k].reshape(COUNT, -1), noise[k])
    return kalman.mean[:2], kalman.covariance[:2, :2]


class _Flown:
    """A triad's flight with fixes."""

    def __init__(
        self,
        fast: GyroFmu,
        mission: StudyMission,
        truth: MissionTruth,
        triad: DrawnTriad,
        generator: np.random.Generator,
    ) -> None:
        self._mission, self._truth, self._triad = mission, truth, triad
        self._trajectory = mission.trajectory()
        self._all, pattern = measure(fast, truth, triad, seed_noise(triad, 0))
        first = round(SETTLING / self._all.interval)
        self._used = self._all.between(first, len(self._all))
        self._turned = measure_turn(self._used, pattern[first:])
        self._drive = sample_drive(self._used, self._turned)
        self._fixes = self._fix(generator)
        self._last = int((AIDED_HOURS * HOUR - self._used.start) / self._drive.step)

    def _fix(self, generator: np.random.Generator) -> Fixes:
        time = np.arange(self._used.start, AIDED_HOURS * HOUR, FIX_SPACING)
        errors = generator.normal(0.0, FIX_SIGMA, (len(time), 3))
        return make_position_fixes(
            time, displace(self._trajectory.position(time), errors), FIX_SIGMA
        )

    def filter(self, states: SensorStates) -> Filtered:
        self._states = states
        self._start = align_in_motion(self._drive, self._fixes, states, NO_ARM)
        return self._filter(states)

    def _filter(self, states: SensorStates) -> Filtered:
        return run_filter(self._drive, self._fixes, states, self._start, NO_ARM, self._last)

    def judge(
        self,
        slow: GyroFmu,
        found: Filtered,
        maps: Mapping[int, BenchMap],
        other: tuple[Array, Mapping[int, BenchMap]],
    ) -> AidedTriad:
        time = AIDED_HOURS * HOUR
        alone = np.linalg.norm(align_and_navigate(self._truth, self._all), axis=1)
        kept = round(FREE_HOURS * HOUR / self._mission.interval) - 1
        uncorrected, shuffled = (self._navigate(found, each) for each in (None, other[0]))
        _, adjoint = smooth(found, self._states, self._drive.step)
        return AidedTriad(
            mission=self._mission.name,
            own=self._tell(self._states, found),
            benched=self._follow(found, maps, adjoint),
            misled=self._follow(found, other[1], adjoint),
            true=np.array([self._read_map(slow, axis, time) for axis in range(AXES)]),
            bench=np.array([each.fitted_map[:TERMS] for each in self._triad.measured]),
            innovation=float(np.mean([u.square for u in found.updates])) / 3,
            uncorrected=uncorrected,
            shuffled=shuffled,
            alone=float(alone[kept]),
            by_noise=propagate(self._drive, self._last, self._states, self._trajectory)[1],
        )

    def _follow(self, found: Filtered, maps: Mapping[int, BenchMap], adjoint: Adjoint) -> Told:
        """What the drive tells with a bench's maps, as far as it does not contradict them."""
        used, _ = choose_bench_maps(self._states, maps, adjoint)
        if not used:
            return self._tell(self._states, found)
        states = take_bench_maps(self._states, used)
        return replace(self._tell(states, self._filter(states)), used=len(used))

    def _tell(self, states: SensorStates, found: Filtered) -> Told:
        time, own = AIDED_HOURS * HOUR, found.covariance[-len(states) :, -len(states) :]
        return Told(
            maps=read_bias_map(states, found.coefficients, own, time),
            prior=read_bias_map(states, states.mean, states.covariance, time),
            free=self._navigate(found, found.coefficients),
        )

    def _read_map(self, slow: GyroFmu, axis: int, time: float) -> Array:
        flown = self._triad.flights[axis]
        terms = read_flight_coefficients(slow, flown.device, flown.rise)[KNOWN].reshape(3, 2, TERMS)
        warmth = float(compute_resonator_warmth(np.array(time)))
        return np.asarray(terms[:, 0].T @ warmth ** np.arange(3))

    def _navigate(self, found: Filtered, coefficients: Array | None) -> float:
        first = self._last * self._drive.rows
        count = (len(self._used) - first) // 2 * 2
        part = self._used.between(first, first + count)
        if coefficients is not None:
            turned = self._turned[first : first + count + 1]
            part = correct_increments(part, turned, self._states, coefficients, part.start)
        heights = Clamped(self._trajectory.position(part.bounds)[:, 2])
        way = navigate(found.state, part, heights, count)
        error = position_error(way.position, self._trajectory.position(way.time))
        return float(np.linalg.norm(error[-1, :2]))
