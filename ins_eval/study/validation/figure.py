"""The figure of a validation: position error, promised and flown; by time, and triad by triad."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.tables import columns as c
from ins_eval.study.validation.outcome import CIRCUMFERENCE, FITTED, FIXED, Outcome
from pyhrg.common.units import HOUR, NAUTICAL_MILE

COLOURS = {FIXED: "tab:red", CIRCUMFERENCE: "tab:blue", FITTED: "tab:green"}
NAMES = {FIXED: "fixed position", CIRCUMFERENCE: "full circumference", FITTED: "fitted map"}
STABILITIES = {FIXED: c.FIXED_STABILITY, CIRCUMFERENCE: c.CIRCUMFERENCE_STABILITY}


def draw(told: Sequence[Outcome], path: Path) -> None:
    """Write the figure as PNG, a row a calibration."""
    figure = Figure(figsize=(11, 6 * len(told)), layout="constrained")
    rows = figure.subplots(len(told), 2, squeeze=False, width_ratios=(1.25, 1))
    for (growth, scatter), outcome in zip(rows, told, strict=True):
        _draw_growth(growth, outcome)
        _draw_scatter(scatter, outcome)
    figure.savefig(path, dpi=120, metadata={"Software": None})


def _draw_growth(axes: Axes, outcome: Outcome) -> None:
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
        label = f"promised by the {NAMES[key]} ({stability:.2g} deg/h)"
        promised = outcome.promised(key) / NAUTICAL_MILE
        axes.plot(hours, promised, COLOURS[key], linestyle="--", linewidth=2, label=label)
    axes.set_yscale("log")
    axes.set_ylim(bottom=min(outcome.promised(FIXED)[-1], outcome.flown.min()) / NAUTICAL_MILE / 10)
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("radial position error, nmi")
    axes.set_title(f"{outcome.mission}, {calibration_title(outcome.calibration)}", fontsize=11)
    axes.grid(which="both", alpha=0.25)
    _legend(axes)


def _draw_scatter(axes: Axes, outcome: Outcome) -> None:
    """Each triad at the end."""
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
    axes.set_title(f"Each of {len(flown)} triads; flown / predicted below", fontsize=11)
    axes.grid(which="both", alpha=0.25)
    _legend(axes)


def _legend(axes: Axes) -> None:
    """Below, where it hides no point."""
    axes.legend(loc="upper left", bbox_to_anchor=(0.0, -0.12), frameon=False, fontsize=9)
