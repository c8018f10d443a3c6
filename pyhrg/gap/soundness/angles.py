"""Checks of the three angles of a log against each other.

The gyro's output angle is -(wave angle - its start - k V) / k, with the nominal angular gain k and
the commanded rotation V. This holds to the rounding of the log, whatever is wrong with the gyro.
Output angle and table angle agree to the errors that a gyro can have.
"""

import itertools

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.gap.soundness.exclusion import Exclusion, NominalEstimate, exclude_columns
from pyhrg.records import Log

ANGLE_TOLERANCE = 0.1 * DEG
"""Departure of the wave angle above which neither noise nor a coarse log explains it, rad.
Chosen."""
TIMING_TOLERANCE = 0.01
"""Time between the sampling of two angles that is allowed for, s. Chosen."""
WRAP_TOLERANCE = 0.05
"""Departure from whole periods, in periods, up to which an angle counts as wrapped. Chosen."""
ROUNDED_GAIN_TOLERANCE = 2e-3
"""Relative departure of an angular gain that a rounded nominal value explains. Chosen."""
MAX_STRAY_SHARE = 0.05
"""Share of rows up to which wrong angles are left out row by row. Chosen."""
SCALE_TOLERANCE = 0.05
"""Relative departure from the table, or of an angular gain, above which no gyro explains it.
Chosen."""
DRIFT_TOLERANCE = 1000 * DEG_PER_H
"""Rate at rest, with the drive on, above which no gyro explains it, rad/s. Chosen."""
MIN_WAVE_TURN = 1 * DEG
"""Turn of the pattern above which its angular gain is estimated, rad. Chosen."""
ANGLES = ("table_angle", "gyro_angle", "wave_angle")


def check_angles(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude angles that contradict each other."""
    exclusions = []
    if log.has_values("wave_angle", "gyro_angle"):
        exclusions = _check_wave(log, nominal)
    if exclusions and exclusions[0].rows is None:
        return exclusions
    return exclusions + _check_table(log, nominal)


def find_column_orders(log: Log, nominal: Device) -> dict[str, float]:
    """Orders of the three angle columns that fit, with their largest departure, 0 to 1.

    An order is named by the columns that change places, and is empty if none does. The result is
    empty if a column is missing.
    """
    fits: dict[str, float] = {}
    if not log.has_values(*ANGLES):
        return fits
    k = nominal.bryan_factor
    for order in itertools.permutations(ANGLES):
        table, gyro, wave = (getattr(log, field) for field in order)
        departure = float(np.nanmax(np.abs(compute_departure(log, k, gyro, wave)), initial=0.0))
        if departure <= 1 and not _contradicts_table(log, gyro, table):
            names = [real for real, field in zip(ANGLES, order, strict=True) if real != field]
            fits[" and ".join(names)] = departure
    return fits


def estimate_bryan_factor(log: Log, nominal: Device) -> list[NominalEstimate]:
    """Estimate of the angular gain: slope of wave angle over output angle, where that is a line."""
    slope, residual = _fit_line(_compute_rotation(log, log.gyro_angle), log.wave_angle)
    known = np.isfinite(residual)
    turned = np.ptp(log.wave_angle[known]) if known.any() else 0.0
    allowed = ANGLE_TOLERANCE + ROUNDED_GAIN_TOLERANCE * turned
    if turned < MIN_WAVE_TURN or np.nanmax(np.abs(residual)) > allowed:
        return []
    k = nominal.bryan_factor
    limits = k * (1 - SCALE_TOLERANCE), k * (1 + SCALE_TOLERANCE)
    return [NominalEstimate("coriolis_factor", "wave_angle", log.source, k, slope, *limits)]


def _compute_rotation(log: Log, gyro: Array) -> Array:
    """(n,) rotation, commanded less measured, that turns the pattern by the angular gain, rad."""
    return np.cumsum(np.nan_to_num(log.virtual_rotation)) * log.interval - gyro


def _fit_line(rotation: Array, wave: Array) -> tuple[float, Array]:
    """Slope of a straight line and its (n,) residual; both NaN where nothing turned."""
    known = np.isfinite(rotation) & np.isfinite(wave)
    if np.sum(known) < 2 or np.ptp(rotation[known]) == 0:
        return np.nan, np.full(len(wave), np.nan)
    x, y = rotation - np.mean(rotation[known]), wave - np.mean(wave[known])
    slope = float(np.sum((x * y)[known]) / np.sum(x[known] ** 2))
    return slope, y - slope * x


def compute_departure(log: Log, k: float, gyro: Array, wave: Array) -> Array:
    """(n,) departure of the wave angle from the output's definition, in units of what rounding and
    timing explain, about its median.

    The fitted slope replaces k if the two differ only by the rounding of k.
    """
    rotation = _compute_rotation(log, gyro)
    slope, residual = _fit_line(rotation, wave)
    if not abs(slope / k - 1) < ROUNDED_GAIN_TOLERANCE:
        residual = wave - k * rotation
    if not np.isfinite(residual).any():
        return residual
    fastest = np.max(np.nan_to_num(np.abs(np.diff(wave))), initial=0.0) / log.interval
    allowed = ANGLE_TOLERANCE + TIMING_TOLERANCE * fastest
    return np.asarray((residual - np.nanmedian(residual)) / allowed)


def _check_wave(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude wave or output angles that contradict the output's definition, and guess why."""
    k = nominal.bryan_factor
    departs = np.abs(compute_departure(log, k, log.gyro_angle, log.wave_angle)) > 1
    if not departs.any():
        return []
    pair = ("gyro_angle", "wave_angle")
    start = log.time[int(np.argmax(departs))]
    trouble = f"from time_s {start:g} on, gyro is not -(wave - start - commanded) / {k:g}"
    if np.mean(departs) < MAX_STRAY_SHARE:
        columns = exclude_columns(log, pair, f"{trouble}; {np.sum(departs)} rows left out")
        return [Exclusion(pair, columns.sentence, departs)]
    rotation = _compute_rotation(log, log.gyro_angle)
    period = _find_wrap_period(log.wave_angle - k * rotation)
    if period:
        jumps = f"it jumps by {period:g} deg, is it wrapped? A mapping says so by wraps_every"
        return [exclude_columns(log, ("wave_angle",), f"{trouble}: {jumps}")]
    fits = find_column_orders(log, nominal)
    if fits:
        guess = f"are columns {min(fits, key=lambda names: fits[names])} swapped?"
        return [exclude_columns(log, ANGLES, f"{trouble}: {guess}")]
    slope, _ = _fit_line(rotation, log.wave_angle)
    return [exclude_columns(log, pair, f"{trouble}: the factor is {slope:.4g}; expected {k:g}")]


def _find_wrap_period(departure: Array) -> float:
    """Period, deg, by which a wave angle jumps while it is right otherwise; 0: none."""
    departure = departure[np.isfinite(departure)] - departure[np.isfinite(departure)][0]
    for period in (360.0, 180.0, 90.0):
        unwrapped = departure - period * DEG * np.round(departure / (period * DEG))
        is_whole = np.max(np.abs(unwrapped)) < WRAP_TOLERANCE * period * DEG
        if np.ptp(departure) > period / 2 * DEG and is_whole:
            return period
    return 0.0


def _check_table(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude all angles if gyro and table differ by more than any error of a gyro."""
    k = nominal.bryan_factor
    gyro = log.gyro_angle
    if not log.has_values("gyro_angle"):
        if not log.has_values("wave_angle"):
            return []
        gyro = _compute_rotation(log, log.wave_angle / k)
    if not _contradicts_table(log, gyro, log.table_angle):
        return []
    by_gyro, by_table = (_compute_path(log, angle)[-1] / DEG for angle in (gyro, log.table_angle))
    trouble = (
        f"gyro turns by {by_gyro:.4g} deg; expected {by_table:.4g} deg as the table, plus Earth's "
        "rotation"
    )
    is_reversed = not _contradicts_table(log, gyro, -log.table_angle)
    trouble += ": is a sign reversed?" if is_reversed else ""
    return [exclude_columns(log, ANGLES, trouble)]


def _contradicts_table(log: Log, gyro: Array, table: Array) -> bool:
    """Whether gyro and table differ by more than scale factor and drift allow, with the drive
    on."""
    apart = np.abs(_compute_path(log, gyro - table))
    path = np.sum(np.abs(np.diff(table[np.isfinite(table)])))
    commanded = np.nansum(np.abs(log.virtual_rotation)) * log.interval
    duration = log.time[-1] - log.time[0]
    allowed = SCALE_TOLERANCE * (path + commanded) + DRIFT_TOLERANCE * duration + ANGLE_TOLERANCE
    return bool(np.max(apart, initial=0.0) > allowed)


def _compute_path(log: Log, angle: Array) -> Array:
    """(n - 1,) change of an angle since the first row, over rows with the drive on."""
    steps = np.diff(angle)
    return np.cumsum(np.where(np.isfinite(steps) & log.is_driven[1:], steps, 0.0))
