"""Figures of position errors, predicted and flown: over time, and triad by triad."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.summary.outcome import Outcome
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FITTED_MAP, FIXED_RULE
from pyhrg.common.units import HOUR, NAUTICAL_MILE

COLOURS = {FIXED_RULE: "tab:red", CIRCUMFERENCE_RULE: "tab:blue", FITTED_MAP: "tab:green"}
NAMES = {
    FIXED_RULE: "fixed position",
    CIRCUMFERENCE_RULE: "full circumference",
    FITTED_MAP: "fitted map",
}
STABILITIES = {FIXED_RULE: c.FIXED_STABILITY, CIRCUMFERENCE_RULE: c.CIRCUMFERENCE_STABILITY}


def draw_figure(outcomes: Sequence[Outcome], path: Path) -> None:
    """Write the figure as PNG; a row of two axes for each calibration."""
    figure = Figure(figsize=(11, 6 * len(outcomes)), layout="constrained")
    rows = figure.subplots(len(outcomes), 2, squeeze=False, width_ratios=(1.25, 1))
    for (growth, scatter), outcome in zip(rows, outcomes, strict=True):
        draw_growth(growth, outcome)
        draw_scatter(scatter, outcome)
    figure.savefig(path, dpi=120, metadata={"Software": None})


def draw_growth(axes: Axes, outcome: Outcome) -> None:
    """Flown and predicted error over time, for a single judged mission."""
    hours, flown = outcome.time / HOUR, outcome.growth / NAUTICAL_MILE
    n = len(flown)
    for number, triad in enumerate(flown):
        label = f"flown, {n} triads" if number == 0 else None
        axes.plot(hours, triad, color="0.75", linewidth=0.8, label=label)
    median = np.median(flown, axis=0)
    axes.plot(hours, median, color="black", linewidth=2.2, label="flown, median (band: 95 %)")
    band = np.array([median_interval(radial) for radial in flown.T])
    axes.fill_between(hours, band[:, 0], band[:, 1], color="black", alpha=0.15, linewidth=0)
    for key, column in STABILITIES.items():
        stability = outcome.flights[column].median()
        label = f"predicted from the {NAMES[key]} ({stability:.2g} deg/h)"
        predicted = outcome.predicted_growth(key) / NAUTICAL_MILE
        axes.plot(hours, predicted, COLOURS[key], linestyle="--", linewidth=2, label=label)
    smallest = min(outcome.predicted_growth(FIXED_RULE)[-1], outcome.flown.min())
    axes.set_yscale("log")
    axes.set_ylim(bottom=smallest / NAUTICAL_MILE / 10)
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("horizontal position error, nmi")
    title = f"{outcome.missions[0]}, {name_calibration(outcome.calibration)}"
    axes.set_title(title, fontsize=11)
    _finish(axes)


def draw_scatter(axes: Axes, outcome: Outcome) -> None:
    """Flown against predicted error of each triad at the end, in nmi on logarithmic axes."""
    flown = outcome.flown / NAUTICAL_MILE
    for key, name in NAMES.items():
        predicted, ratio = outcome.predicted(key) / NAUTICAL_MILE, outcome.ratio(key)
        label = f"{name}: {ratio}"
        axes.plot(predicted, flown, ".", color=COLOURS[key], alpha=0.75, label=label)
    ends = np.array([*axes.get_xlim(), *axes.get_ylim()])
    ends = np.array([max(ends.min(), flown.min() / 3), ends.max()])
    axes.plot(ends, ends, color="black", linestyle=":", linewidth=1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(f"predicted from the bench, nmi, at {outcome.hours:g} h")
    axes.set_ylabel("flown, nmi")
    axes.set_title(f"{len(flown)} flights; flown / predicted below", fontsize=11)
    _finish(axes)


def _finish(axes: Axes) -> None:
    """Grid, and a legend below the axes, where it hides no point."""
    axes.grid(which="both", alpha=0.25)
    axes.legend(loc="upper left", bbox_to_anchor=(0.0, -0.12), frameon=False, fontsize=9)
