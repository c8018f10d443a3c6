"""Records that a sensor spoiled: samples that stick, spikes, motion that the filter can't explain.

Each is refused with its time; the attitude found on it would be wrong by more than its sigma.
"""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from ins_eval.alignment.kalman.dead_reckoning import FEWEST_STEPS
from ins_eval.alignment.result import Alignment, AlignmentError
from ins_eval.common.increments import Increments

Array = NDArray[np.float64]
Rows = NDArray[np.int64]

LONGEST_REPEAT = 5.0
"""One sample over and over, s; a ring laser's counts repeat for up to 0.11 s."""
BY_CHANCE = 1e-6
"""Probability of a repetition that counts explain, at most this often in a record."""
ROUNDING = 1e-12
"""Of the largest sample: what differs by less is equal."""
EASED = 0.2
"""Of the median change from sample to sample: less at its ends makes a repetition smooth."""
SPIKES = {"rotation": (1.0, "rad/s"), "velocity": (50.0, "m/s^2")}
"""Rate and specific force that come and go within one sample: a standing vehicle's inertia
forbids it. People in a car reach 0.007 rad/s and 1 m/s^2 at 100 Hz."""
SETTLING = FEWEST_STEPS // 2
"""First innovations, which show what the start attitude was."""
MOST_SURPRISING = 12.0
"""Of an innovation, in sigma; people who get in reach 9.2."""
DRIFTING = 10
"""Successive innovations that are looked at together."""
MOST_DRIFTING = 6.5
"""Of their mean, in its sigma; swaying and boarded vehicles reach 5.8, a turn by 3 deg
that gyros make up 7."""


def check_samples(record: Increments) -> None:
    """Refuse a spike, or a sensor that sticks.

    A record that repeats itself throughout, as ideal sensors at rest, is let pass, and so is one
    that eases into and out of its repetition, as they do about a turn.

    Raises:
        AlignmentError: names the time, what was found and what was expected.
    """
    for sensor, samples in (("rotation", record.rotation), ("velocity", record.velocity)):
        _check_spikes(record, sensor, samples)
        _check_stuck(record, sensor, samples)


def check_explained(found: Alignment) -> None:
    """Refuse a record whose displacement is not that of a standing vehicle.

    Innovations of a filter whose model holds are white, each of sigma 1. One that is far off is a
    jump; several on end that are off to the same side are a drift, which passes for wide sway.

    Raises:
        AlignmentError: names the time, what was found and what was expected.
    """
    assert found.history is not None
    time, innovation = found.history.time[SETTLING:], found.history.innovation[SETTLING:]
    _check_surprise(time, innovation, "jumps", MOST_SURPRISING)
    several = min(DRIFTING, len(innovation))
    on_end = sliding_window_view(innovation, several, axis=0).sum(axis=-1) / np.sqrt(several)
    _check_surprise(time, on_end, f"drifts over {several} steps", MOST_DRIFTING)


def _check_surprise(time: Array, normalised: Array, what: str, most: float) -> None:
    surprise = np.max(np.abs(normalised), axis=1)
    worst = int(np.argmax(surprise))
    if surprise[worst] > most:
        raise AlignmentError(
            f"at {time[worst]:.1f} s: displacement {what} by {surprise[worst]:.3g} sigma: "
            f"expected at most {most:g} of a standing vehicle: a sensor failed, the vehicle "
            "moved, gyros and accelerometers contradict each other, or the sensors' errors are "
            "stated far too small"
        )


def _check_spikes(record: Increments, sensor: str, samples: Array) -> None:
    most, unit = SPIKES[sensor]
    height = _lone_heights(samples) / record.interval
    if height.size and (worst := float(height.max())) > most:
        row = int(np.argmax(height.max(axis=1))) + 1
        raise AlignmentError(
            f"at {record.bounds[row]:.2f} s, increment {row}: {sensor} {samples[row]} "
            f"rises by {worst:.3g} {unit} over both its neighbours: expected at most {most:g} "
            f"{unit} of a standing vehicle"
        )


def _lone_heights(samples: Array) -> Array:
    """(n - 2, 3) by how much each sample but the ends sticks out from the nearer neighbour."""
    rise, fall = np.diff(samples, axis=0)[:-1], -np.diff(samples, axis=0)[1:]
    return np.where(rise * fall > 0, np.minimum(np.abs(rise), np.abs(fall)), 0.0)


def _check_stuck(record: Increments, sensor: str, samples: Array) -> None:
    change = np.linalg.norm(np.diff(samples, axis=0), axis=1)
    same = change <= ROUNDING * np.max(np.abs(samples))
    starts, lengths = _runs(same)
    long = lengths * record.interval >= LONGEST_REPEAT
    if not long.any() or _smooth(change, starts[long], lengths[long]):
        return
    longest = int(np.argmax(lengths))
    share = (same.sum() - lengths[longest]) / (len(same) - lengths[longest])
    if len(same) * share ** lengths[longest] < BY_CHANCE:
        raise AlignmentError(
            f"{sensor} stuck from {record.bounds[starts[longest]]:.2f} s: the same sample for "
            f"{lengths[longest] * record.interval:.4g} s, where {100 * share:.2g} % of the others "
            f"repeat the one before: expected less than {LONGEST_REPEAT:g} s"
        )


def _smooth(change: Array, starts: Rows, lengths: Rows) -> bool:
    """Whether samples ease into and out of all their repetitions, or there is nothing else."""
    edges = np.union1d(starts - 1, starts + lengths)
    edges = edges[(edges >= 0) & (edges < len(change))]
    outside = np.ones(len(change), dtype=bool)
    outside[edges] = False
    for start, length in zip(starts, lengths, strict=True):
        outside[start : start + length] = False
    varying = change[outside & (change > 0)]
    return varying.size == 0 or bool(np.max(change[edges]) < EASED * np.median(varying))


def _runs(same: NDArray[np.bool_]) -> tuple[Rows, Rows]:
    """Where runs of True begin, and how long they are."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], same, [False]]).astype(np.int64)))
    return edges[::2], edges[1::2] - edges[::2]
