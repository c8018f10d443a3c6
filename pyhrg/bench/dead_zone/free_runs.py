"""Free runs of the pattern against Adler's closed form, and what compensation leaves."""

import math
from collections.abc import Sequence

import numpy as np

from pyhrg.bench.dead_zone.lock import Run
from pyhrg.bench.dead_zone.turning import FOURTH
from pyhrg.bench.estimation.harmonics import MEAN, Fit
from pyhrg.bench.outcome import Finding, estimate_mean
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H
from pyhrg.theory.closed_forms import adler_lock_angle, adler_mean_rate


def compare_with_adler(plain: Sequence[Run], fitted: Fit, lock: float) -> tuple[Finding, ...]:
    """Free runs against Adler's closed form with the map's terms."""
    mean = fitted.value(MEAN)
    free = [run for run in plain if not run.locked and run.rotation == 0.0]
    held = [run for run in plain if run.locked and run.rotation == 0.0]
    moved = [run for run in plain if not run.locked and run.rotation != 0.0]
    return (
        _mean(
            "lock rate from mean rates",
            [math.sqrt(max(0.0, (r.net + mean) ** 2 - r.pattern_rate**2)) for r in free],
            "deg/h",
        ),
        _mean("lock angle error", [_lock_angle_error(r, fitted, lock) for r in held], "deg"),
        _mean(
            "dead zone shift error",
            [r.net + mean - math.copysign(math.hypot(r.pattern_rate, lock), r.net) for r in moved],
            "deg/h",
        ),
    )


def _lock_angle_error(run: Run, fitted: Fit, lock: float) -> float:
    """Angle at which the pattern rests less Adler's, within +-45 deg, rad."""
    axis = math.atan2(fitted.value(FOURTH[0]), -fitted.value(FOURTH[1])) / 4
    share = min(1.0, max(-1.0, (run.net + fitted.value(MEAN)) / lock))
    error = run.angle - adler_lock_angle(share, 1.0, axis)
    return math.remainder(error, math.pi / 2)


def find_residual_dead_zone(
    compensated: Sequence[Run], cancelled: Sequence[Run]
) -> tuple[Finding, ...]:
    """What Eqs. (5) and (7) leave of the dead zone: output less input."""
    held = [run.output - run.rate for run in compensated if run.locked]
    turned = [run.output - run.rate for run in cancelled if not run.locked]
    return (
        _mean("rate error by compensation while locked", held, "deg/h"),
        _mean("rate error under cancellation", turned, "deg/h"),
    )


def _mean(name: str, samples: Sequence[float], unit: str) -> Finding:
    if not samples:
        return Finding(name, np.nan, unit, note="no such run in the records")
    return estimate_mean(name, samples, unit)


def tabulate_runs(everything: Sequence[Run], fitted: Fit, lock: float) -> Table:
    """Every run, its input and what became of it."""
    header = ("run", "W - V, deg/h", "V, deg/h", "pattern, deg/h", "Adler, deg/h", "output, deg/h")
    mean = fitted.value(MEAN)
    rows = []
    for run in everything:
        adler = float(adler_mean_rate(run.net + mean, lock))
        values = (run.net, run.rotation, run.pattern_rate, adler, run.output)
        rows.append((run.name, *(f"{value / DEG_PER_H:.5g}" for value in values)))
    return Table("Free runs", header, tuple(rows))
