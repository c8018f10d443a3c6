"""Figure of the dead zone: mean rate of the pattern against the input rate."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.bench.dead_zone.lock import Run
from pyhrg.bench.estimation.harmonics import MEAN, Fit
from pyhrg.common.units import DEG_PER_H
from pyhrg.theory.closed_forms import adler_mean_rate

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
    panels[0].set_title("Dead zone")
    panels[0].set_ylabel("mean rate of the pattern, -(d$\\theta$/dt)/k, deg/h")
    if turned:
        rotation = turned[0].rotation
        _panel(panels[1], turned, lock, mean, rotation)
        panels[1].set_title(f"Under virtual rotation, V = {rotation / DEG_PER_H:.4g} deg/h")
    panels[0].legend(loc="upper left")


def _panel(axes: Axes, runs: Sequence[Run], lock: float, mean: float, rotation: float) -> None:
    """Runs and curve over 2.5 W_L either side of the dead zone's middle."""
    net = np.linspace(-2.5, 2.5, 1001) * lock
    shown = (net + rotation) / DEG_PER_H
    axes.axvspan(
        (rotation - mean - lock) / DEG_PER_H, (rotation - mean + lock) / DEG_PER_H,
        color="0.9", label="dead zone",
    )  # fmt: skip
    axes.plot(shown, net / DEG_PER_H, "k:", lw=1, label="no dead zone")
    axes.plot(
        shown,
        adler_mean_rate(net + mean, lock) / DEG_PER_H,
        "k-",
        lw=1.2,
        label="Adler, of the map",
    )
    if runs:
        points = np.array([(run.rate, run.pattern_rate) for run in runs]) / DEG_PER_H
        axes.plot(*points.T, "o", color=BLUE, label="free runs")
    axes.set_xlabel("input rate W, deg/h")
    axes.grid(alpha=0.3)
