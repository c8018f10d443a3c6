"""Figures of position errors: the lead case over time, and all judged flights one by one."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.study.report.distances import NMI, format_distance
from ins_eval.study.report.figures.parts import name_calibration
from ins_eval.study.report.lead_case import LeadCase, read_lead_case
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_CLASS,
    FIXED_RULE,
)
from ins_eval.study.tables.score import ALL, FLIGHT_SPEARMAN, R2_RADIAL
from pyhrg.common.pages.svg import format_interval
from pyhrg.common.units import HOUR, NAUTICAL_MILE

FIXED_COLOUR, CIRCUMFERENCE_COLOUR, MAP_COLOUR = "#d55e00", "#0072b2", "#009e73"
"""Colours of the tests, those of the page."""
COLOURS = {
    FIXED_CLASS: FIXED_COLOUR,
    CIRCUMFERENCE_CLASS: CIRCUMFERENCE_COLOUR,
    FITTED_MAP: MAP_COLOUR,
}
NAMES = {
    FIXED_CLASS: "fixed position, class constant",
    CIRCUMFERENCE_CLASS: "full circumference, class constant",
    FITTED_MAP: "fitted map and trajectory",
}
RANKING = {FIXED_CLASS: FIXED_RULE, CIRCUMFERENCE_CLASS: CIRCUMFERENCE_RULE}
"""Bench figure that ranks the drawn flights as the predictor does, by the predictor."""
MARKERS = "o^sDvP*X<"


def draw_figure(data: StudyData, path: Path) -> None:
    """Write the figure as PNG: the lead case, if there is one, and the flights of the first
    calibration."""
    case, calibration = read_lead_case(data.about), data.calibrations[0]
    count = 1 if case is None else 2
    figure = Figure(figsize=(6.2 * count, 6.2), layout="constrained")
    axes: Sequence[Axes] = figure.subplots(1, count, squeeze=False)[0]
    if case is not None:
        draw_lead(axes[0], case)
    draw_scatter(axes[-1], data, calibration)
    figure.savefig(path, dpi=120, metadata={"Software": None})


def draw_lead(axes: Axes, case: LeadCase) -> None:
    """Flown and promised error of the lead case over time, nmi."""
    hours, flown = case.time / HOUR, case.flown / NAUTICAL_MILE
    label = f"flown, co-simulated, {len(flown)} start angles"
    for number, each in enumerate(flown):
        axes.plot(hours, each, color="0.7", linewidth=0.8, label=None if number else label)
    median = np.median(flown, axis=0)
    axes.plot(
        hours, median, color="black", linewidth=2.2, label=f"their median: {_format(median[-1])}"
    )
    for stability, name, colour in (
        (case.circumference_stability, "full circumference", CIRCUMFERENCE_COLOUR),
        (case.fixed_stability, "fixed position", FIXED_COLOUR),
    ):
        promised = case.promise(stability) / NAUTICAL_MILE
        label = f"promised by the {name}, {stability:.2g} deg/h: {_format(promised[-1])}"
        axes.plot(hours, promised, colour, linestyle="--", linewidth=2, label=label)
    axes.set_yscale("log")
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel(f"horizontal position error, {NMI}, log axis")
    axes.set_title(
        f"Gyro of the paper's Table 2 in a {case.mission}, circumference's mean removed",
        fontsize=11,
    )
    _finish(axes)


def draw_scatter(axes: Axes, data: StudyData, calibration: str) -> None:
    """Flown against predicted error of each judged triad at the end, in nmi on logarithmic axes; a
    marker for each mission class."""
    table = data.table
    judged = table[(table[c.ROLE] == TEST) & (table[c.CALIBRATION] == calibration)]
    classes = list(dict.fromkeys(judged[c.CLASS]))
    for key, colour in COLOURS.items():
        label = f"{NAMES[key]}: {_describe(data, calibration, key)}"
        for place, name in enumerate(classes):
            rows = judged[judged[c.CLASS] == name]
            predicted, flown = _read(rows, c.PREDICTOR_OF[key].median), _read(rows, c.FLOWN_RADIAL)
            axes.plot(
                predicted,
                flown,
                MARKERS[place % len(MARKERS)],
                color=colour,
                markersize=4,
                alpha=0.7,
                label=None if place else label,
            )
    flown = _read(judged, c.FLOWN_RADIAL)
    ends = np.array([flown.min() / 3, flown.max() * 3])
    axes.plot(ends, ends, color="black", linestyle=":", linewidth=1)
    for place, name in enumerate(classes):
        axes.plot([], [], MARKERS[place % len(MARKERS)], color="0.4", markersize=4, label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(f"predicted from the bench, {NMI}, log axis")
    axes.set_ylabel(f"flown, {NMI}, log axis")
    by = " and ".join(dict.fromkeys(judged[c.FLOWN_BY]))
    title = f"{len(judged)} flights, {by}; {name_calibration(calibration)}"
    axes.set_title(title, fontsize=11)
    _finish(axes)


def _describe(data: StudyData, calibration: str, key: str) -> str:
    """R2 of the drawn flights, and of a bench test their rank correlation with its figure."""
    kinds = [("R2", R2_RADIAL, key)]
    if key in RANKING:
        kinds.append(("rank", FLIGHT_SPEARMAN, RANKING[key]))
    return ", ".join(
        f"{word} {format_interval(each.value, each.low, each.high)}"
        for word, name, predictor in kinds
        for each in data.select(
            name, predictor=predictor, calibration=calibration, mission_class=ALL
        )
    )


def _format(miles: float) -> str:
    return format_distance(miles * NAUTICAL_MILE)


def _read(rows: pd.DataFrame, name: str) -> np.ndarray:
    return rows[name].to_numpy(float) / NAUTICAL_MILE


def _finish(axes: Axes) -> None:
    """Grid, and a legend below the axes, where it hides no point."""
    axes.grid(which="both", alpha=0.25)
    axes.legend(loc="upper left", bbox_to_anchor=(0.0, -0.12), frameon=False, fontsize=9)
