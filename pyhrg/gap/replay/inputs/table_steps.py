"""The step of readings that are whole multiples of one, and the steps in which a table's encoder
shows its angle: what they hide while it rests and turns (docs/methods/replay.md, Eqs. 12 and 13).
"""

import math
from collections.abc import Sequence

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.caches.compiled import compile_loop
from pyhrg.common.units import ARCSEC
from pyhrg.records import Log

SAMPLES = 200
"""Number of values that are compared with each other. Chosen: they have 20 000 pairs."""
MAX_OFF_LATTICE = 0.02
"""Share of neighbouring values that may differ by more than rounding and by less than the smallest
step; with more of them the values are on no lattice. Chosen: a glitch or a gap moves some
readings."""
MIN_PHASOR = 0.98
"""Least length of the mean phasor (docs/methods/evidence.md, Eq. 18) of values on a lattice.
Chosen: phases that scatter by 0.2 rad have it."""
MAX_COUNT = 20
"""Largest value, in steps, that is used to fit the step. Chosen: an error of 1 % of the step is
then 0.2 steps, and the count is still right."""
MIN_STEP, MAX_STEP = 0.02 * ARCSEC, 30 * ARCSEC
"""Range of the steps that are looked for, rad. Chosen: a smaller one is below any gyro's noise."""
ROUNDING = 4e-3 * ARCSEC
"""Two second differences that differ by less are equal, rad. Chosen: more than the sixth decimal of
a degree."""
MIN_APART = 0.3
"""Median of the second differences of table less gyro, in steps, above which the gyro does not show
the steps. Chosen: rounding has 0.5, a motion none."""
MIN_REST_ROWS = 10
"""Number of readings that make a rest. Chosen."""
PLACE_STEPS = 4
"""Width of an angle that is passed again, in steps. Chosen: readings of one angle differ by one."""
MIN_PASSES = 3
"""Number of times that a table passes an angle whose error lasts. Chosen."""
MAX_SHAPES = 100
"""Number of rests, or of such angles, above which their errors count as white. Chosen."""
ERROR_PER_STEP = 1 / math.sqrt(12)
"""Standard deviation of an even rounding error, in steps."""


def find_lattice_step(
    values: Array, smallest: float, largest: float, rounding: float
) -> tuple[float, float] | None:
    """Step of (n,) values and its standard deviation, between the smallest and the largest that
    count; None where the values are on no lattice. Values that differ by less than `rounding` are
    equal."""
    sample = np.sort(values[:: max(1, len(values) // SAMPLES)])
    gaps = np.diff(sample)
    steps = gaps[gaps >= smallest]
    if len(sample) < SAMPLES / 2 or not len(steps):
        return None
    if np.mean((gaps > rounding) & (gaps < smallest)) > MAX_OFF_LATTICE:
        return None
    small = sample[np.abs(sample) < MAX_COUNT * steps.min()]
    counts = np.round(small / steps.min())
    power = float(counts @ counts)
    step = float(small @ counts) / power if power else 0.0
    if not smallest <= step <= largest:
        return None
    if abs(np.exp(2j * math.pi * values / step).mean()) < MIN_PHASOR:
        return None
    scatter = float(np.std(small - step * counts))
    return step, max(scatter, rounding) / math.sqrt(power)


def find_table_step(logs: Sequence[Log]) -> float:
    """The step of which second differences of the table's angle are whole multiples in all logs,
    rad, while those of the gyro's angle are not; 0 where there is none, or where the table turns
    too little to say."""
    tables = np.concatenate([np.empty(0), *(np.diff(log.table_angle, 2) for log in logs)])
    gyros = np.concatenate([np.empty(0), *(np.diff(log.gyro_angle, 2) for log in logs)])
    turns = np.isfinite(gyros) & (np.abs(tables) > ROUNDING)
    found = find_lattice_step(tables[turns], MIN_STEP, MAX_STEP, ROUNDING)
    apart = np.abs(tables - gyros)[turns]
    return found[0] if found and np.median(apart) >= MIN_APART * found[0] else 0.0


def find_rests(table_angle: Array, step: float) -> list[slice]:
    """Rows of each rest: of readings that stay within a step of the first one."""
    starts = np.flatnonzero(_begin_rests(table_angle, 1.5 * step))
    ends = np.append(starts[1:], len(table_angle))
    pairs = zip(starts.tolist(), ends.tolist(), strict=True)
    return [slice(begin, end) for begin, end in pairs if end - begin >= MIN_REST_ROWS]


@compile_loop
def _begin_rests(table_angle: Array, reach: float) -> Mask:
    """(n,) whether a reading is further from the first one of a rest than `reach`: it begins the
    next one."""
    begins = np.zeros(len(table_angle), dtype=np.bool_)
    first = np.inf
    for i, reading in enumerate(table_angle):
        if abs(reading - first) > reach:
            first = reading
            begins[i] = True
    return begins


def find_turning_rows(table_angle: Array) -> Mask:
    """(n,) rows whose reading is not that of the row before, or of the next one."""
    changed = np.diff(table_angle) != 0
    return np.asarray(np.append(False, changed) | np.append(changed, False))


def shape_rounding_errors(table_angle: Array, step: float) -> Array:
    """(n, r) standard deviations of the output angle's errors by rounding that last, rad: one of
    the start, from the first move on, one of each later rest, and one of each angle that a turning
    table passes again and again. None where there are too many rests."""
    rests = find_rests(table_angle, step) if step else []
    if not (step and np.ptp(table_angle)) or len(rests) > MAX_SHAPES:
        return np.zeros((len(table_angle), 0))
    rows = np.arange(len(table_angle))
    is_at = [(rows >= rest.start) & (rows < rest.stop) for rest in rests]
    begin = is_at.pop(0) if rests and rests[0].start == 0 else rows < 0
    shapes = [~begin, *is_at, *_find_places(table_angle, step, np.any([begin, *is_at], axis=0))]
    return np.asarray(ERROR_PER_STEP * step * np.array(shapes, dtype=float).T)


def _find_places(table_angle: Array, step: float, is_at_rest: Mask) -> list[Mask]:
    """(n,) rows of each angle that is passed several times; none if there are many."""
    count = round(2 * math.pi / (PLACE_STEPS * step))
    places = np.round(table_angle / (2 * math.pi) * count) % count
    places[is_at_rest] = np.nan
    passes = places[np.diff(places, prepend=np.nan) != 0]
    distinct, counts = np.unique(passes[np.isfinite(passes)], return_counts=True)
    recurring = distinct[counts >= MIN_PASSES]
    return [places == place for place in recurring] if len(recurring) <= MAX_SHAPES else []
