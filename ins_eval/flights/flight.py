"""Flights of an IMU along a trajectory: measure, align, navigate."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.alignment.align import align
from ins_eval.alignment.result import Alignment
from ins_eval.common.state import Track
from ins_eval.flights.plan import Plan
from ins_eval.flights.truth import Truth
from ins_eval.imu.imu import Imu, ImuReading
from ins_eval.mission_model.missions import SETTLING
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.increments import Increments


@dataclass(frozen=True)
class Run:
    """One flight; alignment: None when it started from the truth."""

    measured: ImuReading
    alignment: Alignment | None
    track: Track


@dataclass(frozen=True)
class Runs:
    """All flights of a plan.

    own: the navigator's track on ideal increments from the true start; first: the first run;
    alignments, tracks: of all runs.
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
    return Run(measured, alignment, track)


def _navigate(plan: Plan, truth: Truth, measured: Increments, alignment: Alignment | None) -> Track:
    """Track from the true position and velocity, and the aligned attitude."""
    start = replace(truth.start, mat_nb=alignment.mat_nb) if alignment else truth.start
    height = hold_height(plan, truth.heights)
    return navigate(start, truth.flight(measured), height, plan.keep_every, plan.samples)
