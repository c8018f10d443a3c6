"""Flights of an IMU along a trajectory: measure, align, navigate."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.align import align
from ins_eval.alignment.result import Alignment
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import Track
from ins_eval.flights.plan import WARM_UP, Plan
from ins_eval.flights.truth import Truth
from ins_eval.imu.imu import Imu, Measured, StartUpError
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.navigation.strapdown import navigate

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Run:
    """One flight; alignment: None when it started from the truth."""

    measured: Measured
    alignment: Alignment | None
    track: Track


@dataclass(frozen=True)
class Flights:
    """All flights of a plan.

    own: the navigator's track on ideal increments from the true start; first: the first run;
    alignments, tracks: of all runs.
    """

    own: Track
    first: Run
    alignments: Sequence[Alignment]
    tracks: Sequence[Track]


def fly(plan: Plan, truth: Truth, imu: Imu, done: Callable[[], object] = lambda: None) -> Flights:
    """Fly the ideal increments, then each run's; `done` is called after each.

    Raises:
        AlignmentError: what was measured can't be aligned on.
        NavigationError: the navigator can't start or go on.
        StartUpError: gyros that aren't ready after the warm-up, or fail in flight.
    """
    if plan.alignment is not None:
        imu = imu.from_power_on()
    own = _navigated(plan, truth, truth.increments, None)
    done()
    alignments, tracks = [], []
    first = None
    for seed in run_seeds(plan.seed, plan.runs):
        run = _run(plan, truth, imu, seed)
        first = first or run
        alignments += [run.alignment] if run.alignment else []
        tracks.append(run.track)
        done()
    assert first
    return Flights(own, first, alignments, tracks)


def run_seeds(seed: int, runs: int) -> list[int]:
    """Of each run; the first ones are the same however many there are."""
    children = np.random.SeedSequence(seed).spawn(runs)
    return [int(child.generate_state(1, np.uint64)[0] >> np.uint64(1)) for child in children]


def held(plan: Plan, heights: Array) -> Height:
    """What holds the navigator's height to these, m, at the bounds of the intervals."""
    if plan.height == "free":
        return Free()
    return Clamped(heights) if plan.height == "clamped" else BaroDamped(heights)


def _run(plan: Plan, truth: Truth, imu: Imu, seed: int) -> Run:
    measured = imu.measure(truth.increments, seed)
    if measured.ready is not None and not np.all(measured.ready[truth.warm :]):
        raise StartUpError(
            f"{imu.name}: gyros are not ready throughout; expected them to be {WARM_UP:g} s after "
            "power-on, when alignment begins, and from then on"
        )
    alignment = _aligned(plan, truth, measured.increments, imu.errors)
    track = _navigated(plan, truth, measured.increments, alignment)
    return Run(measured, alignment, track)


def _aligned(
    plan: Plan, truth: Truth, measured: Increments, errors: SensorErrors
) -> Alignment | None:
    if plan.alignment is None:
        return None
    return align(truth.alignment(measured), truth.position, errors)


def _navigated(
    plan: Plan, truth: Truth, measured: Increments, alignment: Alignment | None
) -> Track:
    """From the true position and velocity, and the aligned attitude."""
    start = replace(truth.start, mat_nb=alignment.mat_nb) if alignment else truth.start
    height = held(plan, truth.heights)
    return navigate(start, truth.flight(measured), height, plan.keep_every, plan.samples)
