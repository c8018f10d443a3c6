"""The three angles of a log: the gyro's against the wave's, exactly; against the table's, coarsely.

The gyro's output is -(wave angle - its start - k V) / k with the nominal k and the commanded
rotation V: whatever is wrong with the gyro, this holds to the rounding of the log.
"""

import itertools

import numpy as np

from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.gap.soundness.doubt import Array, Believed, Doubt, Witness, doubt, has
from pyhrg.records import Log

ROUNDING = 0.1 * DEG
"""Departure of the wave's angle that neither noise nor a coarse log makes, rad."""
SKEW = 0.01
"""Time between the logging of two angles, s."""
WRAPPED = 0.05
"""Distance from whole periods, relative, at which an angle is taken to be wrapped."""
DIGITS = 2e-3
"""Relative departure of a Bryan factor that is stated in a few digits."""
STRAY = 0.05
"""Share of rows up to which angles are wrong here and there only."""
SCALE = 0.05
"""Relative departure from the table, or of a Bryan factor, that no gyro has."""
DRIFT = 1000 * DEG_PER_H
"""Rate that no gyro shows at rest, driven."""
LEAST_TURN = 1 * DEG
"""Of the wave, before its Bryan factor is looked at, rad."""
ANGLES = ("table_angle", "gyro_angle", "wave_angle")


def doubts_of_angles(log: Log, believed: Believed) -> list[Doubt]:
    """Angles that contradict each other."""
    doubts = _of_wave(log, believed) if has(log, "wave_angle", "gyro_angle") else []
    if doubts and doubts[0].rows is None:
        return doubts
    return doubts + _of_table(log, believed)


def arrangements(log: Log, believed: Believed) -> dict[str, float]:
    """Orders of the three angles that fit, by the names that change places (empty: as stated), and
    how well, 0 to 1; none where one of the angles is missing."""
    fits: dict[str, float] = {}
    if not has(log, *ANGLES):
        return fits
    k = believed.device.bryan_factor
    for order in itertools.permutations(ANGLES):
        table, gyro, wave = (getattr(log, field) for field in order)
        departure = float(np.nanmax(np.abs(_departure(log, k, gyro, wave)), initial=0.0))
        if departure <= 1 and not _contradicts_table(log, gyro, table):
            names = [real for real, field in zip(ANGLES, order, strict=True) if real != field]
            fits[" and ".join(names)] = departure
    return fits


def witnesses_of_bryan_factor(log: Log, believed: Believed) -> list[Witness]:
    """The slope of the wave's angle over the gyro's, where that is a straight line."""
    slope, left = _line(_felt(log, log.gyro_angle), log.wave_angle)
    turned = np.ptp(log.wave_angle[np.isfinite(left)]) if np.isfinite(left).any() else 0.0
    if turned < LEAST_TURN or np.nanmax(np.abs(left)) > ROUNDING + DIGITS * turned:
        return []
    k = believed.device.bryan_factor
    limits = k * (1 - SCALE), k * (1 + SCALE)
    return [Witness("coriolis_factor", "wave_angle", log.source, k, slope, *limits)]


def _felt(log: Log, gyro: Array) -> Array:
    """(n,) rotation that moves the pattern by the Bryan factor times it, rad."""
    return np.cumsum(np.nan_to_num(log.virtual_rotation)) * log.interval - gyro


def _line(felt: Array, wave: Array) -> tuple[float, Array]:
    """Slope of a straight line, and (n,) what it leaves; both NaN where nothing turned."""
    known = np.isfinite(felt) & np.isfinite(wave)
    if np.sum(known) < 2 or np.ptp(felt[known]) == 0:
        return np.nan, np.full(len(wave), np.nan)
    x, y = felt - np.mean(felt[known]), wave - np.mean(wave[known])
    slope = float(np.sum((x * y)[known]) / np.sum(x[known] ** 2))
    return slope, y - slope * x


def _departure(log: Log, k: float, gyro: Array, wave: Array) -> Array:
    """(n,) of the wave's angle from what defines the gyro's output, about its median, over what
    rounding and skew make.

    Where only the last digits of the Bryan factor differ, the line through both is taken.
    """
    felt = _felt(log, gyro)
    slope, left = _line(felt, wave)
    if not abs(slope / k - 1) < DIGITS:
        left = wave - k * felt
    if not np.isfinite(left).any():
        return left
    fastest = np.max(np.nan_to_num(np.abs(np.diff(wave))), initial=0.0) / log.interval
    allowed = ROUNDING + SKEW * fastest
    return np.asarray((left - np.nanmedian(left)) / allowed)


def _of_wave(log: Log, believed: Believed) -> list[Doubt]:
    k = believed.device.bryan_factor
    off = np.abs(_departure(log, k, log.gyro_angle, log.wave_angle)) > 1
    if not off.any():
        return []
    pair = ("gyro_angle", "wave_angle")
    start = log.time[int(np.argmax(off))]
    trouble = f"from time_s {start:g} on not -(wave - start - commanded) / {k:g} of each other"
    if np.mean(off) < STRAY:
        here = doubt(log, pair, f"{trouble}; {np.sum(off)} rows left out")
        return [Doubt(pair, here.sentence, off)]
    wraps = _wraps(log.wave_angle - k * _felt(log, log.gyro_angle))
    if wraps:
        jumps = f"it jumps by {wraps:g} deg, is it wrapped?"
        return [doubt(log, ("wave_angle",), f"{trouble}: {jumps}")]
    fits = arrangements(log, believed)
    if fits:
        guess = f"are columns {min(fits, key=lambda names: fits[names])} swapped?"
        return [doubt(log, ANGLES, f"{trouble}: {guess}")]
    slope, _ = _line(_felt(log, log.gyro_angle), log.wave_angle)
    return [doubt(log, pair, f"{trouble}, but {slope:.4g}; expected {k:g}")]


def _wraps(left: Array) -> float:
    """Period that a wave's angle jumps by while it is right otherwise, deg; 0: none."""
    left = left[np.isfinite(left)] - left[np.isfinite(left)][0]
    for period in (360.0, 180.0, 90.0):
        rest = left - period * DEG * np.round(left / (period * DEG))
        if np.ptp(left) > period / 2 * DEG and np.max(np.abs(rest)) < WRAPPED * period * DEG:
            return period
    return 0.0


def _of_table(log: Log, believed: Believed) -> list[Doubt]:
    """A gyro that turns otherwise than the table by more than any error of its own."""
    k = believed.device.bryan_factor
    gyro = log.gyro_angle
    if not has(log, "gyro_angle"):
        if not has(log, "wave_angle"):
            return []
        gyro = _felt(log, log.wave_angle / k)
    if not _contradicts_table(log, gyro, log.table_angle):
        return []
    found, turned = (_turn(log, angle) / DEG for angle in (gyro, log.table_angle))
    trouble = (
        f"turns by {found:.4g} deg; expected table_angle's {turned:.4g} deg, Earth's beside it"
    )
    reversed_sign = not _contradicts_table(log, gyro, -log.table_angle)
    return [doubt(log, ANGLES, trouble + (": is a sign reversed?" if reversed_sign else ""))]


def _contradicts_table(log: Log, gyro: Array, table: Array) -> bool:
    """Whether they part by more than scale factor and drift allow, while the drive is on."""
    apart = np.abs(_path(log, gyro - table))
    path = np.sum(np.abs(np.diff(table[np.isfinite(table)])))
    virtual = np.nansum(np.abs(log.virtual_rotation)) * log.interval
    allowed = SCALE * (path + virtual) + DRIFT * (log.time[-1] - log.time[0]) + ROUNDING
    return bool(np.max(apart, initial=0.0) > allowed)


def _path(log: Log, angle: Array) -> Array:
    """(n - 1,) an angle's way from the first row, over rows with the drive on."""
    steps = np.diff(angle)
    return np.cumsum(np.where(np.isfinite(steps) & (log.drive_on[1:] == 1), steps, 0.0))


def _turn(log: Log, angle: Array) -> float:
    return float(_path(log, angle)[-1])
