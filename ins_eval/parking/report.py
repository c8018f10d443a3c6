"""A comparison in words, as a figure and as files."""

import json
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.common.metrics import median_interval
from ins_eval.parking.gyro import CASES
from ins_eval.parking.study import Comparison, compare_with_first_case
from ins_eval.parking.triad import RECORDS
from ins_eval.results.compared_growth import TABLE, draw_growth, write_growth
from ins_eval.results.png import save_png
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, NAUTICAL_MILE

COLORS = ("black", "tab:blue", "tab:orange", "tab:red", "tab:green")


def plot_comparison(result: Comparison) -> Figure:
    """Growth of the position error by case, and ratios to the first case."""
    figure = Figure(figsize=(11, 5), layout="constrained")
    growth, ratios = figure.subplots(1, 2, width_ratios=(1.5, 1))
    _draw_growth(growth, result)
    _draw_ratios(ratios, result)
    n = result.radial.shape[1]
    title = f"Patterns of level gyros parked at power-on: {n} triads on {result.mission}"
    figure.suptitle(title, parse_math=False)  # a mission's name is no formula
    return figure


def _draw_growth(axes: Axes, result: Comparison) -> None:
    cases = zip(COLORS, result.radial, strict=True)
    draw_growth(axes, result.time, ((color, None, radial) for color, radial in cases))
    axes.set_ylim(bottom=np.median(result.radial[:, :, -1], axis=1).min() / NAUTICAL_MILE / 30)


def _draw_ratios(axes: Axes, result: Comparison) -> None:
    rows = np.arange(len(CASES))
    kinds = (
        (result.final, -0.15, "o", f"at {result.hours:g} h"),
        (result.greatest, 0.15, "s", f"greatest within {result.hours:g} h"),
    )
    for radial, beside, marker, name in kinds:
        for row, color, ratio in zip(
            rows + beside, COLORS, compare_with_first_case(radial), strict=True
        ):
            axes.plot([ratio.low, ratio.high], [row, row], color=color, linewidth=2)
            axes.plot(ratio.value, row, marker, color=color)
            text, above = f"{ratio.value:.2g}", 5 if beside < 0 else -14
            at = (ratio.value, row)
            axes.annotate(text, at, (0, above), textcoords="offset points", ha="center")
        axes.plot([], [], marker, color="0.4", label=name)
    axes.legend(loc="upper left", framealpha=0.95)
    axes.axvline(1.0, color="0.6", linewidth=1)
    axes.set_xscale("log")
    axes.set_yticks(rows, [case.label.replace(", ", ",\n") for case in CASES])
    for tick, color in zip(axes.get_yticklabels(), COLORS, strict=True):
        tick.set_color(color)
    axes.invert_yaxis()
    axes.margins(y=0.15)
    axes.set_xlabel("error over the first case's (line: 95 %), log axis")
    axes.grid(axis="x", which="both", alpha=0.25)


SCHEMA = "hrg-parking/1"
FILES = ("parking.json", TABLE, "parking.png")
USED = {
    "running": "all five minutes, of gyros that run already",
    "ready": "from when all gyros are ready",
    "valid": "from when all outputs are valid",
    "power_on": "all, from power-on",
}


def summarize(result: Comparison) -> str:
    """Position errors by case, and what start-up costs, in words."""
    n = result.radial.shape[1]
    ready = result.ready.max()
    return "\n".join(
        [
            f"Radial position error on {result.mission}, {n} triads, and its ratio to the first "
            f"case's (geometric mean over triads)",
            *_table(result.final, f"after {result.hours:g} h"),
            *_table(result.greatest, f"greatest within {result.hours:g} h"),
            "",
            "Rms heading error of the alignment, arcmin",
            "",
            *(
                f"{case.label:<45}{find_rms_arcmin(heading):9.3g}"
                for case, heading in zip(CASES, result.heading, strict=True)
            ),
            "",
            f"The last gyro is ready at most {ready:.1f} s after power-on. Rms heading error with "
            "whole maps taken out,\nby what alignment uses, arcmin",
            "",
            *(
                f"{USED[name]:<45}{find_rms_arcmin(errors):9.3g}"
                for name, errors in zip(RECORDS, result.start_up, strict=True)
            ),
        ]
    )


def _table(radial: Array, title: str) -> list[str]:
    """Lines about errors (cases, n), m."""
    lines = ["", f"{title:<42}{'median, nmi':>12}   {'95 %':<18}{'ratio':>7}   95 %"]
    for case, errors, ratio in zip(
        CASES, radial / NAUTICAL_MILE, compare_with_first_case(radial), strict=True
    ):
        low, high = median_interval(errors)
        between = f"{ratio.low:.3g} to {ratio.high:.3g}" if case is not CASES[0] else ""
        lines.append(
            f"{case.label:<42}{np.median(errors):12.3g}   {f'{low:.3g} to {high:.3g}':<18}"
            f"{ratio.value:7.3g}   {between}".rstrip()
        )
    return lines


def find_rms_arcmin(angle: Array) -> float:
    """Root mean square of angles (n,), rad, in arcmin."""
    return float(np.sqrt(np.mean(angle**2))) / DEG * 60


def write(result: Comparison, folder: Path) -> None:
    """Write `FILES` into an existing folder."""
    (folder / "parking.json").write_text(json.dumps(make_document(result), indent=2) + "\n")
    write_growth(folder, result.time, [case.name for case in CASES], result.radial)
    save_png(plot_comparison(result), folder / "parking.png")


def make_document(result: Comparison) -> dict[str, Any]:
    """Content of parking.json."""
    used = zip(RECORDS, result.start_up, strict=True)
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": result.seed,
        "hours": result.hours,
        "mission": result.mission,
        "device": result.device,
        "n": result.radial.shape[1],
        "cases": {case.name: _case(result, number) for number, case in enumerate(CASES)},
        "start_up": {
            "ready_s": [float(result.ready.min()), float(result.ready.max())],
            "heading_error_arcmin": {
                name: {"uses": USED[name], "rms": find_rms_arcmin(errors)} for name, errors in used
            },
        },
    }


def _case(result: Comparison, number: int) -> dict[str, Any]:
    case = CASES[number]
    return {
        "level_gyros_start": case.start.value,
        "taken_out": case.known.value,
        "final": _errors(result.final, number),
        "greatest": _errors(result.greatest, number),
        "heading_error_rms_arcmin": find_rms_arcmin(result.heading[number]),
        "heading_error_arcmin": (result.heading[number] / DEG * 60).tolist(),
    }


def _errors(radial: Array, number: int) -> dict[str, Any]:
    """One case of errors (cases, n), m."""
    own, ratio = radial[number] / NAUTICAL_MILE, compare_with_first_case(radial)[number]
    return {
        "radial_error_nmi": float(np.median(own)),
        "interval_95_nmi": list(median_interval(own)),
        "ratio": ratio.value,
        "ratio_interval_95": [ratio.low, ratio.high],
        "triads_nmi": own.tolist(),
    }
