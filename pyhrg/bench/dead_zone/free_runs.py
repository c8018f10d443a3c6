"""Free runs compared with Adler's closed form, the dead zone after compensation, and the figure of
both."""

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.bench.dead_zone.lock import FOURTH, Run
from pyhrg.bench.estimation.harmonics import MEAN, Fit
from pyhrg.bench.outcome import Finding, estimate_mean
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H
from pyhrg.theory.closed_forms import adler_lock_angle, adler_mean_rate


def compare_with_adler(plain: Sequence[Run], fitted: Fit, lock: float) -> tuple[Finding, ...]:
    """Free runs against Adler's closed form with the map's terms."""
    mean = fitted.value(MEAN)
    still, turned = ([r for r in plain if (r.rotation != 0.0) == way] for way in (False, True))
    squares = [(r.net + mean) ** 2 - r.pattern_rate**2 for r in still if not r.locked]
    angles = [_lock_angle_error(r, fitted, lock) for r in still if r.locked]
    shifts = [
        r.net + mean - math.copysign(math.hypot(r.pattern_rate, lock), r.net)
        for r in turned
        if not r.locked
    ]
    return (
        _mean("lock rate from mean rates", [math.sqrt(max(0.0, x)) for x in squares], "deg/h"),
        _mean("lock angle error", angles, "deg"),
        _mean("dead zone shift error", shifts, "deg/h"),
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


BLUE, ORANGE = "#0072B2", "#D55E00"


def draw(
    figure: Figure, plain: Sequence[Run], cancelled: Sequence[Run], fitted: Fit, lock: float
) -> None:
    """Without and, where there are runs, with virtual rotation; Adler's curve by the map."""
    still = [run for run in plain if run.rotation == 0.0]
    turned = [run for run in plain if run.rotation != 0.0]
    panels = figure.subplots(1, 2 if turned else 1, squeeze=False, sharey=True)[0]
    mean = fitted.value(MEAN)
    _panel(panels[0], still, lock, mean, 0.0)
    if cancelled:
        rates = np.array([(run.rate, run.pattern_rate) for run in cancelled]) / DEG_PER_H
        panels[0].plot(*rates.T, "s", mfc="none", color=ORANGE, label="cancelled by Eq. 7")
    panels[0].set(title="Dead zone", ylabel="mean rate of the pattern, -(d$\\theta$/dt)/k, deg/h")
    if turned:
        rotation = turned[0].rotation
        _panel(panels[1], turned, lock, mean, rotation)
        panels[1].set_title(f"Under virtual rotation, V = {rotation / DEG_PER_H:.4g} deg/h")
    panels[0].legend(loc="upper left")


def _panel(axes: Axes, runs: Sequence[Run], lock: float, mean: float, rotation: float) -> None:
    """Runs and curve over 2.5 W_L either side of the dead zone's middle."""
    net = np.linspace(-2.5, 2.5, 1001) * lock
    shown = (net + rotation) / DEG_PER_H
    ends = ((rotation - mean + way * lock) / DEG_PER_H for way in (-1, 1))
    axes.axvspan(*ends, color="0.9", label="dead zone")
    axes.plot(shown, net / DEG_PER_H, "k:", lw=1, label="no dead zone")
    expected = adler_mean_rate(net + mean, lock) / DEG_PER_H
    axes.plot(shown, expected, "k-", lw=1.2, label="Adler, of the map")
    if runs:
        points = np.array([(run.rate, run.pattern_rate) for run in runs]) / DEG_PER_H
        axes.plot(*points.T, "o", color=BLUE, label="free runs")
    else:
        axes.plot([], [], " ", label="no free run")
    axes.set_xlabel("input rate W, deg/h")
    axes.grid(alpha=0.3)
