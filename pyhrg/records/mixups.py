"""Finds values in another unit than the header says: two columns then contradict each other."""

import math

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG, HOUR
from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.table import Table
from pyhrg.records.timing import find_even_steps

MIXUPS = {
    1 / DEG: "are radians given where degrees are meant?",
    HOUR: "is a rate per hour given where one per second is meant?",
}
"""What a message asks where a ratio is off by a factor, or by its inverse."""
MIXUP_FACTOR = 1.2
"""Largest factor between a ratio and that of a known mix-up. Chosen."""
BRYAN_FACTOR_RANGE = (0.1, 0.6)
"""Smallest and largest ratio of pattern to gyro angle. Chosen: any shell or ring; the largest is
twice that of a hemisphere."""
MIN_WAVE_CORRELATION = 0.9
"""Smallest correlation of pattern and gyro angle whose ratio is judged. Chosen: a pattern that
loops hold in place follows none."""
MIN_TURN = 1e-3 * DEG
"""Smallest turn of two columns that are compared, rad. Chosen."""
MIN_REST = 100.0
"""Shortest time at rest over which Earth's rate is looked for, s. Chosen."""
MAX_SLOW_RATE = 3 * DEG
"""Largest table rate beside which Earth's rate is looked for, rad/s: up to it, only a scale-factor
error of hundreds of ppm looks like Earth's rate in another unit."""
MIN_SLOW_TURNING = 30.0
"""Shortest time of such turning over which Earth's rate is looked for, s. Chosen."""
MIN_EARTH_RATE = 0.2 * EARTH_RATE
"""Smallest component of Earth's rate on the input axis that is looked for, rad/s. Chosen."""


def check_units(table: Table, interval: float, any_sign: bool) -> None:
    """Compare the gyro's angle with the table's, the pattern's with the gyro's, force with 1 g.
    With `any_sign`, the table's angle may count against the gyro's."""
    steps = _compute_steps(table, interval)
    _check_table(table, steps, interval, any_sign)
    _check_wave(table, steps)
    _check_gravity(table)


def check_earth_rate(table: Table, interval: float, latitude: float) -> None:
    """Compare the gyro's rate with Earth's. Where all angles have the same wrong unit, only this
    comparison finds it.

    At rest it is the gyro's rate that is compared; where the table turns at up to `MAX_SLOW_RATE`,
    it is the gyro's rate less the table's. The interval is in s, the site's latitude in rad.
    """
    columns = table.columns
    earth = columns["axis_up"][1:] * EARTH_RATE * math.sin(latitude)
    by_table = np.diff(columns["table_angle"])
    beyond = np.diff(columns["gyro_angle"]) - by_table
    is_free = (
        (columns["drive_on"][1:] > 0.5)
        & (np.abs(earth) > MIN_EARTH_RATE)
        & np.isfinite(beyond)
        & find_even_steps(columns["time"], interval)
    )
    is_resting = by_table == 0
    is_slow = ~is_resting & (np.abs(by_table) < MAX_SLOW_RATE * interval)
    for rows, shortest in ((is_free & is_resting, MIN_REST), (is_free & is_slow, MIN_SLOW_TURNING)):
        if np.sum(rows) * interval < shortest:
            continue
        if not beyond[rows].any():
            raise LogError(
                f"{table.source}: column {BY_FIELD['gyro_angle'].name}: stands still throughout; "
                "expected Earth's rate"
            )
        expected_turn = float(np.sum(np.abs(earth[rows])) * interval)
        ratio = float(np.sum(np.sign(earth) * beyond * rows)) / expected_turn
        _refuse_mixed_units(table, ratio, "Earth's rate asks for")


def _compute_steps(table: Table, interval: float) -> dict[str, Array]:
    """(m,) turns of table, gyro, pattern and virtual rotation over steps of one interval, rad."""
    columns, even = table.columns, find_even_steps(table.columns["time"], interval)
    steps = {n: np.diff(columns[f"{n}_angle"])[even] for n in ("table", "gyro", "wave")}
    steps["virtual"] = np.nan_to_num(columns["virtual_rotation"][1:])[even] * interval
    return steps


def _check_table(table: Table, steps: dict[str, Array], interval: float, any_sign: bool) -> None:
    """Regress the gyro's steps on the table's, where Earth's rate hardly counts."""
    turned, gyro = _select_finite(steps["table"], steps["gyro"])
    weight = float(np.sum(turned**2))
    earth = EARTH_RATE * interval * float(np.sum(np.abs(turned)))
    if np.sum(np.abs(turned)) < MIN_TURN or earth > (MIXUP_FACTOR - 1) * weight:
        return
    ratio = float(np.sum(turned * gyro)) / weight
    if 1 / MIXUP_FACTOR < -ratio < MIXUP_FACTOR and not any_sign:
        raise LogError(
            f"{table.source}: column {BY_FIELD['gyro_angle'].name}: turns {ratio:.3g} times as far "
            "as table_angle turns; expected about 1: is a sign reversed?"
        )
    _refuse_mixed_units(table, ratio, "table_angle turns")


def _check_wave(table: Table, steps: dict[str, Array]) -> None:
    """Regress the pattern's angle on the gyro's less the virtual rotation: the slope is -k."""
    felt, wave = (
        np.cumsum(x) for x in _select_finite(steps["virtual"] - steps["gyro"], steps["wave"])
    )
    if len(felt) < 2 or min(np.ptp(felt), np.ptp(wave)) < MIN_TURN:
        return
    felt, wave = felt - np.mean(felt), wave - np.mean(wave)
    slope = abs(float(np.sum(felt * wave) / np.sum(felt**2)))
    correlation = slope * float(np.std(felt) / np.std(wave))
    low, high = BRYAN_FACTOR_RANGE
    if correlation > MIN_WAVE_CORRELATION and not high * DEG <= slope <= low / DEG:
        names = "wave_angle", "gyro_angle and virtual_rotation turn"
        expected = f"a Bryan factor, {low:g} to {high:g}"
        raise _make_contradiction(table, slope, *names, expected, math.sqrt(low * high))


def _check_gravity(table: Table) -> None:
    force = np.stack([table.columns[f"acceleration_{axis}"] for axis in "xyz"])
    known = force[:, np.isfinite(force).all(axis=0)]
    if not known.size:
        return
    size = float(np.median(np.linalg.norm(known, axis=0)))
    if 1 / MIXUP_FACTOR < size < MIXUP_FACTOR:
        name = BY_FIELD["acceleration_z"].name
        raise LogError(
            f"{table.source}: column {name} and its like: {size:.3g} in all; "
            "expected about 9.8: is g given where m/s2 is meant?"
        )


def _select_finite(x: Array, y: Array) -> tuple[Array, Array]:
    known: Mask = np.isfinite(x) & np.isfinite(y)
    return x[known], y[known]


def _refuse_mixed_units(table: Table, ratio: float, other: str) -> None:
    for factor in (*MIXUPS, *(1 / factor for factor in MIXUPS)):
        if factor / MIXUP_FACTOR < ratio < factor * MIXUP_FACTOR:
            raise _make_contradiction(table, ratio, "gyro_angle", other, "about 1", 1.0)


def _make_contradiction(
    table: Table, ratio: float, field: str, other: str, expected: str, usual: float
) -> LogError:
    """The error that asks for the mix-up nearest to the ratio's departure from the usual one."""
    name, departure = BY_FIELD[field].name, abs(math.log(ratio / usual))
    nearest = min(MIXUPS, key=lambda factor: abs(departure - math.log(factor)))
    return LogError(
        f"{table.source}: column {name}: turns {ratio:.3g} times as far as {other}; "
        f"expected {expected}: {MIXUPS[nearest]}"
    )
