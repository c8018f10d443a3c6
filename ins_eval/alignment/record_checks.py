"""Checks of the record that an alignment gets: an attitude from a bad record would be wrong by more
than its sigma.

The stated latitude is held against the one that a standing vehicle's gyros measure. Gravity gives
the vertical, and the gyros give Earth's rate about it: RATE sin(latitude), upward (Groves 2013,
section 5.6.2). Corrupted records are refused with the time: stuck samples, spikes, and displacement
that no standing vehicle has.
"""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from ins_eval.alignment.analytic import mean_rate_variance
from ins_eval.alignment.kalman.dead_reckoning import MIN_STEPS
from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments
from pyhrg.records.saturation import find_runs

MAX_RATE_DEVIATION = 0.2
"""Largest relative difference of the mean rate from Earth's. Chosen: beyond it the vehicle turned,
and no latitude can be read."""
RATE_TOLERANCE = 0.06
"""Tolerance of the rate about the vertical, relative to Earth's rate. Chosen: it covers creeping
tilt, scale-factor errors and a place read off a map; 3.4 deg of latitude at the equator, 4.9 deg at
45."""
BOUND_SIGMA = 5.0
"""Sigmas of the measured rate that are added to the tolerance. Chosen."""
PARTS = 20
"""Parts of the record whose mean rates' scatter is that of vehicle and gyros. Chosen."""


def check_latitude(record: Increments, latitude: float, errors: SensorErrors) -> None:
    """Check that the gyros do not contradict the stated latitude, rad.

    The bound of the rate about the vertical is `RATE_TOLERANCE` plus 5 sigma, both of the gyros'
    stated errors and of the scatter between `PARTS` parts of the record. A vehicle that swings in
    heading has a large scatter and so hides a wrong latitude. On the equator reversed gyros are not
    detected.
    """
    force = record.velocity.sum(axis=0)
    up = force / np.linalg.norm(force)
    mean = record.rotation.sum(axis=0) / record.duration
    if abs(np.linalg.norm(mean) / earth.RATE - 1) > MAX_RATE_DEVIATION:
        return
    parts = [part.mean() for part in np.array_split(record.rotation @ up, PARTS)]
    scatter = np.var(parts, ddof=1) / PARTS / record.interval**2
    stated = mean_rate_variance(errors, record.duration)
    bound = RATE_TOLERANCE * earth.RATE + BOUND_SIGMA * np.sqrt(stated + scatter)
    measured, expected = float(mean @ up), earth.RATE * np.sin(latitude)
    if abs(measured - expected) > bound:
        shown = np.rad2deg(np.arcsin(np.clip(measured / earth.RATE, -1, 1)))
        reason = ": latitude, or gyros?"
        if measured * expected < 0:
            reason = ": latitude's sign, or gyros reversed?"
        raise HrgError(
            f"gyros show latitude {shown:.2f} deg: expected the stated "
            f"{np.rad2deg(latitude):.2f} deg; rate about the vertical {measured:.3g} rad/s: "
            f"expected {expected:.3g} rad/s within {bound:.2g} rad/s"
            f"{reason}"
        )


Rows = NDArray[np.int64]

MAX_REPEAT_DURATION = 5.0
"""Longest time for which a sensor may repeat one sample, s. Chosen; on the recorded ring-laser log
counts repeat for up to 0.11 s."""
MIN_EXPECTED_REPEATS = 1e-6
"""Smallest expected number of repetitions in a record for which coarse counts explain one.
Chosen."""
ROUNDING = 1e-10
"""Relative difference, to the largest sample, below which samples count as equal. Chosen: above the
rounding of a simulated vehicle at rest."""
EASING_RATIO = 0.2
"""Largest ratio of the change at the ends of a repetition to the median change between samples for
which the repetition is smooth. Chosen."""
MAX_SPIKES = {"rotation": (1.0, "rad/s"), "velocity": (50.0, "m/s^2")}
"""Largest rate and specific force by which one sample exceeds both its neighbours. Chosen; people
in a car cause 0.007 rad/s and 1 m/s^2 at 100 Hz."""
SETTLING_STEPS = MIN_STEPS // 2
"""Number of first innovations that are ignored, since they depend on the start attitude. Chosen."""
MAX_INNOVATION_SIGMA = 12.0
"""Largest innovation, in sigma. Chosen above 9.2, the largest on the sound records that were tried
(vehicles that people board)."""
DRIFT_STEPS = 10
"""Number of successive innovations whose mean is tested for drift. Chosen."""
MAX_DRIFT_SIGMA = 6.5
"""Largest mean of `DRIFT_STEPS` innovations, in its sigma. Chosen between 5.8, the largest on the
sound records that were tried, and 7, reached by a turn of 3 deg that only the gyros measure."""


def check_samples(record: Increments) -> None:
    """Check a record for spikes and stuck sensors.

    Records of ideal sensors pass: they repeat one sample throughout, or change smoothly before and
    after a repetition, as around a turn.
    """
    for sensor, samples in (("rotation", record.rotation), ("velocity", record.velocity)):
        _check_spikes(record, sensor, samples)
        _check_stuck(record, sensor, samples)


def check_explained(alignment: Alignment) -> None:
    """Check that the displacement is that of a standing vehicle.

    The normalized innovations of a filter whose model holds are white with sigma 1. A large one is
    a jump. A large mean of several is a drift, which the filter would take for a wide sway.
    """
    settled = slice(SETTLING_STEPS, None)
    time, innovation = alignment.history.time[settled], alignment.history.innovation[settled]
    _check_normalised(time, innovation, "jumps", MAX_INNOVATION_SIGMA)
    count = min(DRIFT_STEPS, len(innovation))
    sums = sliding_window_view(innovation, count, axis=0).sum(axis=-1) / np.sqrt(count)
    _check_normalised(time, sums, f"drifts over {count} steps", MAX_DRIFT_SIGMA)


def _check_normalised(time: Array, normalised: Array, verb: str, limit: float) -> None:
    size = np.max(np.abs(normalised), axis=1)
    worst = int(np.argmax(size))
    if size[worst] > limit:
        raise HrgError(
            f"at {time[worst]:.1f} s: displacement {verb} by {size[worst]:.3g} sigma: "
            f"expected at most {limit:g} of a standing vehicle: a sensor failed, the vehicle "
            "moved, gyros and accelerometers contradict each other, or the sensors' errors are "
            "stated far too small"
        )


def _check_spikes(record: Increments, sensor: str, samples: Array) -> None:
    limit, unit = MAX_SPIKES[sensor]
    height = _measure_spikes(samples) / record.interval
    if height.size and (worst := float(height.max())) > limit:
        row = int(np.argmax(height.max(axis=1))) + 1
        raise HrgError(
            f"at {record.bounds[row]:.2f} s, increment {row}: {sensor} {samples[row]} "
            f"exceeds both its neighbours by {worst:.3g} {unit}: expected at most {limit:g} "
            f"{unit} of a standing vehicle"
        )


def _measure_spikes(samples: Array) -> Array:
    """Return by how much each sample (n - 2, 3) but the ends exceeds the nearer of its
    neighbours."""
    rise, fall = np.diff(samples, axis=0)[:-1], -np.diff(samples, axis=0)[1:]
    return np.where(rise * fall > 0, np.minimum(np.abs(rise), np.abs(fall)), 0.0)


def _check_stuck(record: Increments, sensor: str, samples: Array) -> None:
    change = np.linalg.norm(np.diff(samples, axis=0), axis=1)
    same = change <= ROUNDING * np.max(np.abs(samples))
    starts, ends = find_runs(same)
    lengths = ends - starts
    long = lengths * record.interval >= MAX_REPEAT_DURATION
    if not long.any() or _is_smooth(change, starts[long], lengths[long]):
        return
    longest = int(np.argmax(lengths))
    share = (same.sum() - lengths[longest]) / (len(same) - lengths[longest])
    if len(same) * share ** lengths[longest] < MIN_EXPECTED_REPEATS:
        raise HrgError(
            f"{sensor} stuck from {record.bounds[starts[longest]]:.2f} s: the same sample for "
            f"{lengths[longest] * record.interval:.4g} s, where {100 * share:.2g} % of the others "
            f"repeat the one before: expected less than {MAX_REPEAT_DURATION:g} s"
        )


def _is_smooth(change: Array, starts: Rows, lengths: Rows) -> bool:
    """Tell whether samples change smoothly before and after each repetition, or never change."""
    edges = np.union1d(starts - 1, starts + lengths)
    edges = edges[(edges >= 0) & (edges < len(change))]
    outside = np.ones(len(change), dtype=bool)
    outside[edges] = False
    for start, length in zip(starts, lengths, strict=True):
        outside[start : start + length] = False
    varying = change[outside & (change > 0)]
    return varying.size == 0 or bool(np.max(change[edges]) < EASING_RATIO * np.median(varying))
