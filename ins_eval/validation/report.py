"""A validation in words and as files."""

import csv
import json
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ins_eval.metrics import median_interval
from ins_eval.validation.figure import draw
from ins_eval.validation.study import Validation
from ins_eval.validation.verdict import Ratio, ratio, verdict
from pyhrg.units import DEG_PER_H, NAUTICAL_MILE

Array = NDArray[np.float64]

SCHEMA = "hrg-validation/1"
FILES = ("validation.json", "position_error.csv", "validation.png")


def ratios(result: Validation) -> tuple[Ratio, Ratio]:
    """Flown over promised at the mission's end: fixed position, full circumference."""
    flown = result.flown[:, -1]
    return (
        ratio(flown, float(result.predicted_fixed_position[-1])),
        ratio(flown, float(result.predicted_full_circumference[-1])),
    )


def summary(result: Validation) -> str:
    """What a person wants to read: the table, the figures and the verdict."""
    flown = result.flown[:, -1] / NAUTICAL_MILE
    low, high = median_interval(flown)
    fixed = result.predicted_fixed_position[-1] / NAUTICAL_MILE
    circumference = result.predicted_full_circumference[-1] / NAUTICAL_MILE
    heading = f"Median radial position error after {result.hours:g} h of {result.mission}, nmi"
    return "\n".join(
        [
            result.table,
            "",
            heading,
            f"{'promised by the fixed-position test':<45}{fixed:9.3g}",
            f"{'promised by the full-circumference test':<45}{circumference:9.3g}",
            f"{f'flown by {len(flown)} triads':<45}{np.median(flown):9.3g}"
            f"   (95 %: {low:.3g} to {high:.3g})",
            "",
            verdict(*ratios(result)),
        ]
    )


def write(result: Validation, folder: Path) -> None:
    """Write validation.json, position_error.csv and validation.png into an existing folder."""
    text = json.dumps(document(result), indent=2) + "\n"
    (folder / "validation.json").write_text(text)
    _write_errors(result, folder / "position_error.csv")
    draw(result, folder / "validation.png")


def document(result: Validation) -> dict[str, Any]:
    """Content of validation.json."""
    flown = result.flown[:, -1] / NAUTICAL_MILE
    fixed, circumference = ratios(result)

    def bench(name: str) -> dict[str, Any]:
        test = getattr(result, name)
        return {
            "bias_stability_deg_per_h": test.stability / DEG_PER_H,
            "bias_repeatability_deg_per_h": test.repeatability / DEG_PER_H,
            "bias_deg_per_h": test.bias / DEG_PER_H,
            "runs": [
                {
                    "mean_deg_per_h": run.mean / DEG_PER_H,
                    "standard_deviation_deg_per_h": run.deviation / DEG_PER_H,
                    "points": len(run.points),
                }
                for run in test.runs
            ],
        }

    def promise(radial: Array, kept: Ratio) -> dict[str, Any]:
        return {
            "radial_error_nmi": float(radial[-1]) / NAUTICAL_MILE,
            "flown_over_predicted": kept.value,
            "flown_over_predicted_interval_95": [kept.low, kept.high],
            "judged": kept.word,
        }

    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": result.seed,
        "hours": result.hours,
        "mission": result.mission,
        "calibration": "mean bias over the circumference, of each flown gyro",
        "bench": {name: bench(name) for name in ("fixed_position", "full_circumference")},
        "predicted": {
            "fixed_position": promise(result.predicted_fixed_position, fixed),
            "full_circumference": promise(result.predicted_full_circumference, circumference),
        },
        "flown": {
            "radial_error_nmi": float(np.median(flown)),
            "interval_95_nmi": list(median_interval(flown)),
            "n": len(flown),
            "triads_nmi": flown.tolist(),
        },
        "verdict": verdict(fixed, circumference),
    }


def _write_errors(result: Validation, path: Path) -> None:
    names = [f"triad_{i + 1:03}_m" for i in range(len(result.flown))]
    predicted = ["predicted_fixed_position_m", "predicted_full_circumference_m"]
    columns = np.column_stack(
        [
            result.time,
            result.predicted_fixed_position,
            result.predicted_full_circumference,
            np.median(result.flown, axis=0),
            result.flown.T,
        ]
    )
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time_s", *predicted, "flown_median_m", *names])
        writer.writerows([f"{value:.6g}" for value in row] for row in columns)
