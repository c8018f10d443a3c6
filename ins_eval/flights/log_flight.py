"""Dead reckoning of a recorded log: align on its beginning, navigate to its end."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.align import align
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import State, Track
from ins_eval.flights.flight import held
from ins_eval.flights.flown import Flown
from ins_eval.flights.plan import Plan
from ins_eval.flights.truth import still
from ins_eval.navigation.strapdown import navigate
from ins_eval.results import flights

Array = NDArray[np.float64]

Reference = Callable[[Array], Track]
"""True states at times (m,), s; attitudes that nobody knows are NaN."""


def at_rest(position: Array) -> Reference:
    """The truth of a vehicle that stood there all the time, whatever way it faced."""

    def track(time: Array) -> Track:
        rows = len(time)
        unknown = np.full((rows, 3, 3), np.nan)
        return Track(time, np.tile(position, (rows, 1)), np.zeros((rows, 3)), unknown)

    return track


def fly_log(
    plan: Plan,
    name: str,
    log: Increments,
    position: Array,
    errors: SensorErrors,
    reference: Reference | None,
) -> Flown:
    """Align on a log's beginning, and navigate.

    Args:
        plan: with an alignment.
        name: of the log.
        log: at rest until alignment ends.
        position: (3,) at its beginning: latitude, longitude, rad, height, m.
        errors: of its sensors, as alignment believes them.
        reference: the truth, if there is one; it holds the height too.

    Raises:
        AlignmentError: its beginning can't be aligned on.
        NavigationError: the navigator can't start or go on.
    """
    _, zero = still(plan.alignment, plan.interval, warm_up=0.0)
    log = replace(log, start=-zero * log.interval)
    alignment = align(log.between(0, zero), position, errors)
    measured = log.between(zero, zero + plan.count)
    latitude, longitude, height = map(float, position)
    start = State(latitude, longitude, height, np.zeros(3), alignment.mat_nb)
    heights = np.full(plan.count + 1, height)
    if reference:
        heights = reference(measured.bounds).position[:, 2]
    track = navigate(start, measured, held(plan, heights), plan.keep_every, plan.samples)
    dataset = flights.navigated([track])
    if reference:
        dataset = flights.against([track], reference(track.time))
    return Flown(plan, "dead reckoning", name, np.asarray(position), [alignment], dataset)
