"""A comparison of schedules in words, as a figure and as files."""

import json
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.common.metrics import PairedRatio, compute_paired_ratio, median_interval
from ins_eval.error_model.error_budget import BODY
from ins_eval.results.compared_growth import TABLE, draw_growth, write_growth
from ins_eval.results.png import save_png
from ins_eval.schedules.comparison import CASES, CHOICES, UNSCHEDULED, Comparison
from ins_eval.schedules.families import FAMILIES
from ins_eval.schedules.schedule import Schedule, Sweep
from pyhrg.common.units import DEG

SCHEMA = "hrg-schedule/1"
FILES = ("schedule.json", TABLE, "schedule.png")
COLORS = ("black", "0.45", "tab:blue", "tab:orange", "tab:green")
NAMES = [case.name for case in CASES]


def summarize(result: Comparison) -> str:
    """Position errors by case, flown and predicted, and their ratios."""
    n = result.rms.shape[1]
    return "\n".join(
        [
            f"Rms horizontal position error within {result.hours:g} h on {result.mission}, {n} "
            "triads: median, and ratio to that without a schedule (geometric mean over triads)",
            "",
            f"{'':<66}{'flown, m':>9}   {'95 %':<16}{'predicted, m':>12}{'ratio':>9}   95 %",
            *(_describe_case(result, number) for number in range(len(CASES))),
            "",
            "Ratio of the chosen schedule's error to those of the controls",
            "",
            *(
                f"{family.label:<40}{f'to {words}':<22}"
                f"{result.compare(f'{family.name}_chosen', f'{family.name}_{choice}')}"
                for family in FAMILIES
                for choice, words in list(CHOICES.items())[1:]
            ),
        ]
    )


def _describe_case(result: Comparison, number: int) -> str:
    case, rms = CASES[number], result.rms[number]
    low, high = median_interval(rms)
    line = (
        f"{case.label:<66}{np.median(rms):9.4g}   {f'{low:.3g} to {high:.3g}':<16}"
        f"{np.median(result.predicted[number]):12.4g}"
    )
    if case is UNSCHEDULED:
        return line
    ratio = result.compare(case.name, UNSCHEDULED.name)
    return f"{line}{ratio.value:9.3g}   {ratio.low:.3g} to {ratio.high:.3g}"


def plot_comparison(result: Comparison) -> Figure:
    """Errors that were predicted and flown, and the growth of the error by schedule."""
    figure = Figure(figsize=(11, 5), layout="constrained")
    growth, agreement = figure.subplots(1, 2, width_ratios=(1.2, 1))
    shown = [0, 1, *(NAMES.index(f"{family.name}_chosen") for family in FAMILIES)]
    _draw_growth(growth, result, shown)
    _draw_agreement(agreement, result, shown)
    title = f"Schedules chosen by the gyros' maps: {result.rms.shape[1]} triads on {result.mission}"
    figure.suptitle(title, parse_math=False)  # a mission's name is no formula
    return figure


def _draw_growth(axes: Axes, result: Comparison, shown: list[int]) -> None:
    cases = (
        (color, CASES[number].label.removesuffix(": chosen"), result.radial[number])
        for color, number in zip(COLORS, shown, strict=True)
    )
    draw_growth(axes, result.time, cases)
    axes.legend(loc="lower right", fontsize=8, framealpha=0.95)


def _draw_agreement(axes: Axes, result: Comparison, shown: list[int]) -> None:
    markers = dict(zip(CHOICES, ("o", "x", "+"), strict=True))
    for color, number in zip(COLORS, shown, strict=True):
        family = NAMES[number].removesuffix("_chosen")
        for choice, marker in markers.items() if family != NAMES[number] else [("", "o")]:
            at = NAMES.index(f"{family}_{choice}" if choice else family)
            axes.plot(result.predicted[at], result.rms[at], marker, color=color, markersize=4)
    for choice, marker in markers.items():
        axes.plot([], [], marker, color="0.4", markersize=4, label=CHOICES[choice])
    bounds = [min(x.min() for x in (result.predicted, result.rms)), result.predicted.max()]
    axes.plot(bounds, bounds, color="0.6", linewidth=1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("predicted rms error within the mission, m (linear model)")
    axes.set_ylabel("flown, m (a point is a triad)")
    axes.grid(which="both", alpha=0.25)
    axes.legend(loc="upper left", title="schedule", framealpha=0.95)


def write(result: Comparison, folder: Path) -> None:
    """Write `FILES` into an existing folder."""
    (folder / "schedule.json").write_text(json.dumps(make_document(result), indent=2) + "\n")
    write_growth(folder, result.time, NAMES, result.radial)
    save_png(plot_comparison(result), folder / "schedule.png")


def make_document(result: Comparison) -> dict[str, Any]:
    """Content of schedule.json."""
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": result.seed,
        "hours": result.hours,
        "mission": result.mission,
        "device": result.device,
        "n": result.rms.shape[1],
        "cases": {name: _list_case(result, number) for number, name in enumerate(NAMES)},
    }


def _list_case(result: Comparison, number: int) -> dict[str, Any]:
    rms, final, reference = result.rms[number], result.final[number], NAMES.index(UNSCHEDULED.name)
    ratios = {
        "rms": compute_paired_ratio(rms, result.rms[reference]),
        "final": compute_paired_ratio(final, result.final[reference]),
    }
    return {
        "label": CASES[number].label,
        "rms_m": rms.tolist(),
        "final_m": final.tolist(),
        "predicted_rms_m": result.predicted[number].tolist(),
        "ratio_to_unscheduled": {name: _list_ratio(ratio) for name, ratio in ratios.items()},
        "schedules": [describe(schedule) for schedule in result.schedules[number]],
    }


def _list_ratio(ratio: PairedRatio) -> dict[str, Any]:
    return {"value": ratio.value, "interval_95": [ratio.low, ratio.high]}


def describe(schedule: Schedule) -> dict[str, Any]:
    """A schedule's commands, as in files: angles in deg, rates in deg/s."""
    starts = schedule.start_angles
    return {
        "start_angles_deg": [None if angle is None else angle / DEG for angle in starts],
        "virtual_rotation": [_describe_sweep(sweep) for sweep in schedule.virtual_rotation],
        "case": _describe_sweep(schedule.case),
        "taken_out": ["mean" if mean else "bias at start" for mean in schedule.takes_mean],
    }


def _describe_sweep(sweep: Sweep) -> dict[str, Any]:
    span = float(sweep.span / DEG) if sweep.rate else None
    return {
        "start_deg": float(sweep.start / DEG),
        "rate_deg_per_s": float(sweep.rate / DEG),
        "turns_back_after_deg": span,
    }


def summarize_choice(document: dict[str, Any]) -> str:
    """The schedules that `ChosenSchedules.document` holds, in words."""
    families = document["families"]
    parked, indexed, turned = (families[family.name] for family in FAMILIES)
    return "\n".join(
        [
            f"Rms horizontal position error within {document['hours']:g} h on "
            f"{document['mission']}, predicted by the linear model, m",
            "",
            f"{document['unscheduled_rms_m']:8.4g}   without a schedule",
            f"{parked['rms_m']:8.4g}   patterns parked: {_describe_parking(parked)}",
            f"{indexed['rms_m']:8.4g}   case turned: {_describe_motion(indexed['case'])}",
            f"{turned['rms_m']:8.4g}   patterns turned by virtual rotation:",
            *(
                f"{'':13}{axis}: {_describe_motion(sweep)}; {taken} taken out"
                for axis, sweep, taken in zip(
                    BODY, turned["virtual_rotation"], turned["taken_out"], strict=True
                )
            ),
            "",
            "Elsewhere the map's value at the start is taken out of the gyros forward and right, "
            "its mean of the gyro down.",
        ]
    )


def _describe_parking(parked: dict[str, Any]) -> str:
    given = zip(BODY, parked["start_angles_deg"], strict=True)
    return ", ".join(f"{axis} at {angle:g} deg" for axis, angle in given if angle is not None)


def _describe_motion(sweep: dict[str, Any]) -> str:
    start = f"from {sweep['start_deg']:g} deg on, " if sweep["start_deg"] else ""
    if not sweep["rate_deg_per_s"]:
        return f"{start}not at all"
    return (
        f"{start}at {sweep['rate_deg_per_s']:.3g} deg/s, back after "
        f"{sweep['turns_back_after_deg']:.4g} deg"
    )
