"""Values under another unit than the header says, found where two columns contradict each other."""

import math

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.table import Array, Table
from pyhrg.records.timing import even_steps

NEAR = 1.2
"""Factor within which a ratio is a known mix-up."""
BRYAN_FACTORS = (0.1, 0.6)
"""Wave over gyro angle of any shell or ring; twice the most a hemisphere has."""
LEAST_TURN = 1e-3 * DEG
"""Turn that two columns must show before they are compared, rad."""
LEAST_REST = 100.0
"""Time at rest over which Earth's rate is looked for, s."""
SLOW = 3 * DEG
"""Rate of the table up to which Earth's is looked for beside it, rad/s."""
LEAST_SLOW = 30.0
"""Time of such turning over which it is, s."""
LEAST_EARTH_RATE = 0.2 * EARTH_RATE
"""Component on the axis that is looked for, rad/s."""


def check_units(table: Table, interval: float) -> None:
    """Hold the gyro's angle to the table's, the wave's to the gyro's, gravity to 1 g.

    Raises:
        LogError: a ratio that only another unit or sign explains.
    """
    steps = _steps(table, interval)
    _check_table(table, steps, interval)
    _check_wave(table, steps)
    _check_gravity(table)


def check_earth_rate(table: Table, interval: float, latitude: float) -> None:
    """Hold the gyro to Earth's rate; the only witness where every angle is in radians.

    At rest the gyro's rate is looked at; where the table turns, its rate less the table's. At up to
    `SLOW` only a scale-factor error of hundreds of ppm could make that look like Earth's rate in
    radians.

    Args:
        table: as it was read.
        interval: sampling interval, s.
        latitude: of the site, rad.

    Raises:
        LogError: the gyro's rate is Earth's in another unit, or its angle never changes at rest.
    """
    columns = table.columns
    earth = columns["axis_up"][1:] * EARTH_RATE * math.sin(latitude)
    by_table = np.diff(columns["table_angle"])
    beyond = np.diff(columns["gyro_angle"]) - by_table
    free = (
        (columns["drive_on"][1:] == 1)
        & (np.abs(earth) > LEAST_EARTH_RATE)
        & np.isfinite(beyond)
        & even_steps(columns["time"], interval)
    )
    rest, slow = by_table == 0, (by_table != 0) & (np.abs(by_table) < SLOW * interval)
    for rows, least in ((free & rest, LEAST_REST), (free & slow, LEAST_SLOW)):
        if np.sum(rows) * interval < least:
            continue
        if not beyond[rows].any():
            raise LogError(
                f"{table.source}: column {BY_FIELD['gyro_angle'].name}: stands still throughout; "
                "expected Earth's rate"
            )
        asked = float(np.sum(np.abs(earth[rows])) * interval)
        ratio = float(np.sum(np.sign(earth) * beyond * rows)) / asked
        _refuse(table, ratio, "gyro_angle", "Earth's rate asks for", 1.0)


def _steps(table: Table, interval: float) -> dict[str, Array]:
    """(m,) turns of table, gyro, wave and virtual rotation over steps of one interval, rad."""
    columns = table.columns
    steps = {
        name: np.diff(columns[f"{name}_angle"])[even_steps(columns["time"], interval)]
        for name in ("table", "gyro", "wave")
    }
    virtual = np.nan_to_num(columns["virtual_rotation"][1:]) * interval
    return steps | {"virtual": virtual[even_steps(columns["time"], interval)]}


def _check_table(table: Table, steps: dict[str, Array], interval: float) -> None:
    """Steps are weighed by the table's, so that Earth's rate can be bounded and hardly counts."""
    turned, gyro = _both(steps["table"], steps["gyro"])
    weight = float(np.sum(turned**2))
    earth = EARTH_RATE * interval * float(np.sum(np.abs(turned)))
    if np.sum(np.abs(turned)) < LEAST_TURN or earth > (NEAR - 1) * weight:
        return
    ratio = float(np.sum(turned * gyro)) / weight
    if 1 / NEAR < -ratio < NEAR:
        raise LogError(
            f"{table.source}: column {BY_FIELD['gyro_angle'].name}: turns {ratio:.3g} times as far "
            "as table_angle turns; expected about 1: is a sign reversed?"
        )
    _refuse(table, ratio, "gyro_angle", "table_angle turns", 1.0)


def _check_wave(table: Table, steps: dict[str, Array]) -> None:
    """Wave against gyro less virtual rotation: a straight line whose slope is -k."""
    felt, wave = (np.cumsum(x) for x in _both(steps["virtual"] - steps["gyro"], steps["wave"]))
    if len(felt) < 2 or min(np.ptp(felt), np.ptp(wave)) < LEAST_TURN:
        return
    felt = felt - np.mean(felt)
    slope = abs(float(np.sum(felt * wave) / np.sum(felt**2)))
    low, high = BRYAN_FACTORS
    names = "wave_angle", "gyro_angle and virtual_rotation turn"
    if low * DEG < slope < high * DEG or low / DEG < slope < high / DEG:
        raise _contradiction(table, slope, *names, f"a Bryan factor, {low:g} to {high:g}")


def _check_gravity(table: Table) -> None:
    force = np.stack([table.columns[f"acceleration_{axis}"] for axis in "xyz"])
    known = force[:, np.isfinite(force).all(axis=0)]
    if not known.size:
        return
    size = float(np.median(np.linalg.norm(known, axis=0)))
    if 1 / NEAR < size < NEAR:
        name = BY_FIELD["acceleration_z"].name
        raise LogError(
            f"{table.source}: column {name} and its like: {size:.3g} in all; "
            "expected about 9.8: is g given where m/s2 is meant?"
        )


def _both(x: Array, y: Array) -> tuple[Array, Array]:
    known: NDArray[np.bool_] = np.isfinite(x) & np.isfinite(y)
    return x[known], y[known]


def _refuse(table: Table, ratio: float, field: str, other: str, expected: float) -> None:
    for factor in (DEG, 1 / DEG):
        if factor / NEAR < ratio / expected < factor * NEAR:
            raise _contradiction(table, ratio, field, other, f"about {expected:g}")


def _contradiction(table: Table, ratio: float, field: str, other: str, expected: str) -> LogError:
    name = BY_FIELD[field].name
    return LogError(
        f"{table.source}: column {name}: turns {ratio:.3g} times as far as {other}; "
        f"expected {expected}: are radians given where degrees are meant?"
    )
