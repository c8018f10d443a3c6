"""Flights of an IMU along a trajectory: measure, align, navigate, compare with the truth."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.alignment.align import align
from ins_eval.alignment.result import Alignment
from ins_eval.common.state import State, Track
from ins_eval.flights.plan import Plan
from ins_eval.imu.imu import Imu, ImuReading
from ins_eval.mission_model.missions import SETTLING
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments


@dataclass(frozen=True)
class Truth:
    """A trajectory, sampled for a plan.

    Attributes:
        trajectory: the trajectory that is sampled.
        increments: ideal increments from power-on.
        warm, zero: numbers of increments before alignment and before time 0.
        start: true state at time 0.
        track: true states at the kept times.
        heights: true heights at the bounds of the flight's intervals, m.
    """

    trajectory: Trajectory
    increments: Increments
    warm: int
    zero: int
    start: State
    track: Track
    heights: Array

    @property
    def position(self) -> Array:
        """(3,) at time 0: latitude, longitude, rad, height, m."""
        return self.start.position

    def alignment(self, increments: Increments) -> Increments:
        """Increments after the warm-up, until time 0."""
        return increments.between(self.warm, self.zero)

    def flight(self, increments: Increments) -> Increments:
        """Increments from time 0 on."""
        return increments.between(self.zero, len(increments))


def count_still_increments(
    alignment: float | None, interval: float, warm_up: float = SETTLING
) -> tuple[int, int]:
    """Numbers of increments of the warm-up, and of warm-up and alignment together."""
    if alignment is None:
        return 0, 0
    warm = round(warm_up / interval)
    return warm, warm + round(alignment / interval)


def sample_truth(plan: Plan, trajectory: Trajectory) -> Truth:
    """Ideal increments and true states of a trajectory that covers the plan."""
    warm, zero = count_still_increments(plan.alignment, plan.interval)
    bounds = plan.interval * np.arange(plan.count + 1.0)
    return Truth(
        trajectory=trajectory,
        increments=trajectory.increments(-zero * plan.interval, plan.interval, zero + plan.count),
        warm=warm,
        zero=zero,
        start=trajectory.state(0.0),
        track=trajectory.track(bounds[plan.keep_every :: plan.keep_every]),
        heights=trajectory.position(bounds)[:, 2],
    )


@dataclass(frozen=True)
class Run:
    """One flight.

    Attributes:
        seed: seed of the run's IMU.
        alignment: the run's alignment; None if it started from the truth.
    """

    seed: int
    measured: ImuReading
    alignment: Alignment | None
    track: Track


@dataclass(frozen=True)
class Runs:
    """All flights of a plan.

    Attributes:
        own: the navigator's track on ideal increments from the true start.
        first: the first run.
        alignments, tracks: alignment and navigated states of each run.
    """

    own: Track
    first: Run
    alignments: Sequence[Alignment]
    tracks: Sequence[Track]


def fly_runs(
    plan: Plan,
    truth: Truth,
    imu: Imu,
    progress: Callable[[int, int], None] | None = None,
) -> Runs:
    """All flights of a plan: on ideal increments first, then each run's."""
    if plan.alignment is not None:
        imu = imu.from_power_on()
    report = progress or (lambda done, total: None)
    own = _navigate(plan, truth, truth.increments, None)
    report(1, plan.runs + 1)
    alignments, tracks = [], []
    first = None
    for number, seed in enumerate(spawn_seeds(plan.seed, plan.runs), start=2):
        run = _run(plan, truth, imu, seed)
        first = first or run
        alignments += [run.alignment] if run.alignment else []
        tracks.append(run.track)
        report(number, plan.runs + 1)
    assert first
    return Runs(own, first, alignments, tracks)


def spawn_seeds(seed: int, runs: int) -> list[int]:
    """Seeds of the runs; the first ones are the same however many runs there are."""
    children = np.random.SeedSequence(seed).spawn(runs)
    return [int(child.generate_state(1, np.uint64)[0] >> np.uint64(1)) for child in children]


def hold_height(plan: Plan, heights: Array) -> Height:
    """What holds the navigator's height to these heights, m, at the bounds of the intervals."""
    if plan.height == "free":
        return Free()
    return Clamped(heights) if plan.height == "clamped" else BaroDamped(heights)


def _run(plan: Plan, truth: Truth, imu: Imu, seed: int) -> Run:
    measured = imu.measure(truth.increments, seed)
    if measured.ready is not None and not np.all(measured.ready[truth.warm :]):
        raise HrgError(
            f"{imu.name}: gyros are not ready throughout; expected them to be {SETTLING:g} s after "
            "power-on, when alignment begins, and from then on"
        )
    alignment = None
    if plan.alignment is not None:
        standing = truth.alignment(measured.increments)
        alignment = align(standing, truth.position, imu.errors)
    track = _navigate(plan, truth, measured.increments, alignment)
    return Run(seed, measured, alignment, track)


def _navigate(plan: Plan, truth: Truth, measured: Increments, alignment: Alignment | None) -> Track:
    """Track from the true position and velocity, and the aligned attitude."""
    start = replace(truth.start, mat_nb=alignment.mat_nb) if alignment else truth.start
    height = hold_height(plan, truth.heights)
    return navigate(start, truth.flight(measured), height, plan.keep_every, plan.samples)
