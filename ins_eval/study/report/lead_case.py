"""The lead case in words and as a drawing: what each bench test promises, and what is flown."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ins_eval.common.metrics import MIN_SAMPLE_FOR_MEDIAN
from ins_eval.common.metrics import median_interval as find_median_interval
from ins_eval.study.predictors.stability_rule import DRIFT_PER_STABILITY
from ins_eval.study.report.distances import NMI, format_distance, format_range
from ins_eval.study.report.figures.parts import draw_axes
from ins_eval.study.study_data import LEAD_KEY
from pyhrg.common.arrays import Array
from pyhrg.common.pages import svg
from pyhrg.common.units import DEG_PER_H, HOUR, NAUTICAL_MILE

TESTS = ("fixed position", "full circumference")
"""Names of the two bench tests, in the order of their figures."""
ROOM = 1.5
"""Factor above the largest error up to which the axis goes, so that a name fits. Chosen."""


@dataclass(frozen=True)
class LeadCase:
    """Results of the lead case.

    Attributes:
        device, mission: names.
        fixed_stability, circumference_stability: bench figures, deg/h.
        time: (k,) s.
        flown: (n, k) horizontal errors, m.
    """

    device: str
    mission: str
    fixed_stability: float
    circumference_stability: float
    time: Array
    flown: Array

    @property
    def final(self) -> Array:
        """(n,) horizontal errors at the end, m."""
        return np.asarray(self.flown[:, -1])

    @property
    def median(self) -> float:
        """Median error at the end, m."""
        return float(np.median(self.final))

    @property
    def median_interval(self) -> tuple[float, float] | None:
        """95 % interval of the median by order statistics, m; None with too few flights."""
        return None if len(self.final) < MIN_SAMPLE_FOR_MEDIAN else find_median_interval(self.final)

    def _describe_interval(self) -> str:
        interval = self.median_interval
        return f" (95 %: {format_range(*interval)})" if interval else ""

    def promise(self, stability: float) -> Array:
        """(k,) error by the usual rule from a stability, deg/h; m."""
        return np.asarray(DRIFT_PER_STABILITY * stability * DEG_PER_H * self.time)

    @property
    def promised_fixed(self) -> float:
        """Error at the end that the fixed position promises, m."""
        return float(self.promise(self.fixed_stability)[-1])

    @property
    def promised_circumference(self) -> float:
        """Error at the end that the full circumference promises, m."""
        return float(self.promise(self.circumference_stability)[-1])

    @property
    def sentences(self) -> tuple[str, str, str]:
        """What the two tests promise, and what is flown."""
        median = self.median
        hours = self.time[-1] / HOUR
        over = median / self.promised_fixed
        against = self.promised_circumference / median
        size = f"{against:.2g} times as much" if against >= 1 else f"{against:.2g} of it"
        return (
            "The gyro of the paper's Table 2, its mean over the circumference taken out, has "
            f"{self.fixed_stability:.2g} deg/h at a fixed position, which promises "
            f"{format_distance(self.promised_fixed)} after {hours:g} h in a {self.mission}.",
            f"Over the full circumference it has {self.circumference_stability:.2g} deg/h, which "
            f"promises {format_distance(self.promised_circumference)}.",
            f"Three such gyros, co-simulated from {len(self.final)} start angles anywhere, err "
            f"by {format_distance(median)}, the median{self._describe_interval()} of flights from "
            f"{format_range(self.final.min(), self.final.max())}: {over:.2g} times what the fixed "
            f"position promises; the circumference promises {size}.",
        )

    @property
    def headline(self) -> str:
        """All of it in one sentence."""
        promised = (self.promised_fixed, self.promised_circumference, self.median)
        fixed, circumference, flown = map(format_distance, promised)
        ends = format_range(self.final.min(), self.final.max())
        return (
            f"After {self.time[-1] / HOUR:g} h in a {self.mission}, a navigator with three gyros "
            f"of the paper's Table 2 is {flown} off, the median of {len(self.final)} flights from "
            f"{ends}; the test at a fixed position promises {fixed}, the test over the full "
            f"circumference {circumference}."
        )

    @property
    def drawing(self) -> str:
        """Markup: errors over time, promised and flown, nmi on a log axis."""
        hours, flown = self.time / HOUR, self.flown / NAUTICAL_MILE
        promised = [
            self.promise(stability) / NAUTICAL_MILE
            for stability in (self.fixed_stability, self.circumference_stability)
        ]
        largest = max(line.max() for line in (*promised, *flown))
        x = svg.make_horizontal_scale(0.0, float(hours[-1]), log=False)
        y = svg.make_vertical_scale(
            *svg.find_decades(np.concatenate([*promised, *flown, [ROOM * largest]]))
        )
        lines = "".join(
            f'<path class="flight" d="{svg.draw_line(x(hours), y(each))}"/>' for each in flown
        )
        lines += _draw_median(x(hours), y(np.median(flown, axis=0)), len(flown))
        for test, line, colour in zip(TESTS, promised, ("c1", "c0"), strict=True):
            lines += _draw_named(x(hours), y(line), f"promised: {test}", colour)
        return draw_axes(
            x,
            y,
            ("time since alignment, h", f"error, {NMI}"),
            lines,
            " ".join(self.sentences),
        )


def read_lead_case(about: Mapping[str, Any]) -> LeadCase | None:
    """The lead case of a study's facts; None where the study has none."""
    case = about.get(LEAD_KEY)
    if not case:
        return None
    return LeadCase(
        device=case["device"],
        mission=case["mission"],
        fixed_stability=case["fixed_stability_deg_h"],
        circumference_stability=case["circumference_stability_deg_h"],
        time=np.array(case["time_s"]),
        flown=np.array(case["flown_m"]),
    )


def _draw_median(across: Array, up: Array, count: int) -> str:
    """The median of the flown errors; its name stands with a piece of it in the upper left corner,
    which is free since errors grow."""
    left, top = svg.LEFT + 10, svg.TOP + 14
    return (
        f'<g class="lead flown"><path d="{svg.draw_line(across, up)}"/>'
        f'<path d="M{left} {top}h24"/>'
        f'<text x="{left + 30}" y="{top + 5}">flown, median of {count}</text></g>'
    )


def _draw_named(across: Array, up: Array, name: str, colour: str) -> str:
    """A line with its name above its end."""
    return (
        f'<g class="lead {colour}"><path d="{svg.draw_line(across, up)}"/>'
        f'<text x="{across[-1] - 4:.0f}" y="{up[-1] - 8:.0f}" text-anchor="end">{name}</text></g>'
    )
