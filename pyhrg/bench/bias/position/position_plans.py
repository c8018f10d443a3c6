"""Aliasing of the fourth harmonic: bias stability that four plans report, against the start angle.

Positions 45 deg of pattern angle apart (the paper's 8 over 360 deg) sample the fourth harmonic at
two phases, 180 deg apart. Their standard deviation is A |sin 4(th_0 - th_tau)| sqrt(8/7): anything
from 0 to 1.07 A. At 22.5 or 11.25 deg it is A / sqrt 2 times sqrt(n/(n-1)) for every start angle.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.position.full_circumference import SETTLE, make_programme
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.estimation.harmonics import fit, make_columns, name_terms
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.readings.segments import Points, read_segments
from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

KIND = "position_plans"
PLANS = tuple(
    Plan(positions, step * DEG)
    for positions, step in ((8, 45.0), (8, 22.5), (8, 11.25), (16, 22.5))
)
STARTS = np.arange(0.0, 90.0, 5.625) * DEG


@dataclass(frozen=True)
class PlanReport:
    """Bias stability (n,), rad/s, that a plan reports at start angles (n,), rad.

    Attributes:
        pattern_step: pattern angle between positions, rad.
    """

    positions: int
    pattern_step: float
    start: Array
    stability: Array

    @property
    def name(self) -> str:
        """Number and spacing of the positions, as in "8 x 45 deg"."""
        return f"{self.positions} x {self.pattern_step / DEG:g} deg"


def record(bench: Bench) -> list[Test]:
    """Tests of every plan from every start angle, with one data point at each position."""
    plans = [replace(plan, bryan_factor=bench.device.bryan_factor) for plan in PLANS]
    courses = [make_programme(bench, plan, 1) for plan in plans]
    return bench.run(
        [
            PowerOn(f"plan_{n}_start_{m:02}", KIND, course, float(start))
            for n, course in enumerate(courses, 1)
            for m, start in enumerate(STARTS, 1)
        ]
    )


def summarize_plans(runs: Sequence[Points]) -> list[PlanReport]:
    """Reports of the plans, to which runs belong by number and spacing of their positions."""
    plans: dict[tuple[int, float], list[tuple[float, float]]] = {}
    for run in runs:
        step = abs(float(np.median(np.diff(run.pattern_angle)))) / DEG
        key = (run.dwells, round(step * 4) / 4)
        start = float(run.pattern_angle[0] % (math.pi / 2))
        plans.setdefault(key, []).append((start, float(np.std(run.rate, ddof=1))))
    return [
        PlanReport(positions, step * DEG, *np.array(sorted(points)).T)
        for (positions, step), points in plans.items()
    ]


def evaluate(campaign: Campaign) -> Outcome:
    """Range of the bias stability that each plan reports, and the map fitted to all runs."""
    logs = [test.log for test in require_tests(campaign, KIND)]
    runs = [read_segments(log, campaign.site, SETTLE) for log in logs]
    pattern, rate = (
        np.concatenate([getattr(run, name) for run in runs]) for name in ("pattern_angle", "rate")
    )
    fitted = fit(make_columns(pattern, pattern, (4,), tilt=False), rate)
    amplitude = math.hypot(*(fitted.value(name) for name in name_terms(4)))
    reports = summarize_plans(runs)
    rows = tuple(
        (r.name, *(f"{x / DEG_PER_H:.4f}" for x in (r.stability.min(), r.stability.max())))
        for r in reports
    )
    ratios = [
        Finding(
            *(f"most over least, {r.name}", float(r.stability.max() / r.stability.min()), "1"),
            n=len(r.start),
            note="over start angles",
        )
        for r in reports
    ]
    aliased = [r.name for r, ratio in zip(reports, ratios, strict=True) if ratio.si_value > 2]
    return Outcome(
        findings=(
            Finding("fourth harmonic", amplitude, "deg/h", note="amplitude A, of all runs"),
            Finding("rms of the map", amplitude / math.sqrt(2), "deg/h", note="A / sqrt 2"),
            *ratios,
        ),
        verdict=(
            f"Figures of {', '.join(aliased)} depend on where the pattern starts: the fourth "
            "harmonic aliases."
            if aliased
            else "No plan's figure depends on where the pattern starts by more than a factor of 2."
        ),
        tables=(Table("Reported bias stability, deg/h", ("plan", "least", "most"), rows),),
        draw=lambda figure: draw(figure, reports, amplitude),
    )


def draw(figure: Figure, reports: Sequence[PlanReport], amplitude: float) -> None:
    axes = figure.add_subplot(xlim=(0, 90), title="Bias stability that a plan of positions reports")
    for report, mark in zip(reports, "osv^" * len(reports), strict=False):
        axes.plot(
            report.start / DEG, report.stability / DEG_PER_H, mark + "-", ms=4, lw=1,
            label=report.name,
        )  # fmt: skip
    rms = amplitude / math.sqrt(2) / DEG_PER_H
    axes.axhline(rms, color="black", ls="--", lw=1, label="A / √2 of the map")
    labels = ("pattern angle at power-on, deg", "reported bias stability, deg/h")
    finish_axes(axes, *labels, ylim=(0, None))


PROCEDURE: Procedure = Procedure(
    name="position-plans",
    group="bias",
    title="Bias stability that plans of positions report, by start angle",
    source=full_circumference.PROCEDURE.source,
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
    model="HRGSlow",
    step=0.1,
)
