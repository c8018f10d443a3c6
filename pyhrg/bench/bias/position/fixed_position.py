"""The conventional bias test: the gyro rests and the pattern stays at one angle.

This is the procedure of the fibre-optic gyro standards, which the paper describes in 1.2 and 4.1.
The input axis is level and points east, so that Earth's rate doesn't move the pattern.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, BiasTest
from pyhrg.bench.bias.position.positions import estimate_within
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Points, read_segments
from pyhrg.common.units import DEG, DEG_PER_H, MINUTE
from pyhrg.records.campaign import Campaign, Test

SEGMENTS = 36
"""Data points of a run: one hour."""
KIND = "static"


def make_power_ons(bench: Bench, runs: int = RUNS, segments: int = SEGMENTS) -> list[PowerOn]:
    """Power-ons at rest, input axis east, by default seven of an hour each."""
    course = bench.programme().attitude(0.0).rest(WARM_UP + segments * SEGMENT)
    return [PowerOn(f"fixed_{n + 1}", KIND, course) for n in range(runs)]


def record(bench: Bench) -> list[Test]:
    return bench.run(make_power_ons(bench))


def read_runs(campaign: Campaign) -> list[Points]:
    """Data points of each power-on."""
    runs = []
    for test in require_tests(campaign, KIND):
        runs.append(read_segments(test.log, campaign.site, 0.0))
        if len(runs[-1]) < 2:
            raise BenchError(f"{test.log.source}: 1 segment of {SEGMENT:g} s; expected 2 or more")
    return runs


def evaluate(campaign: Campaign) -> Outcome:
    """Bias, stability and repeatability, and the range of pattern angle that they are taken at."""
    runs, tests = read_runs(campaign), require_tests(campaign, KIND)
    result = BiasTest(runs)
    angles = [test.log.wave_angle for test in tests]
    swept = max(float(np.nanmax(angle) - np.nanmin(angle)) for angle in angles)
    return Outcome(
        findings=result.findings(),
        verdict=(
            f"Bias stability {result.stability / DEG_PER_H:.2g} deg/h at a fixed position: the "
            f"pattern moved over {swept / DEG:.2g} deg, and the figure holds there alone. A period "
            "of the bias map has 90 deg."
        ),
        tables=(result.table(),),
        draw=lambda figure: draw(figure, runs),
        points=result.tabulate_points(estimate_within("", runs)),
    )


def draw(figure: Figure, runs: Sequence[Points]) -> None:
    axes = figure.add_subplot(title=f"Fixed position, {SEGMENT:g} s means")
    for number, run in enumerate(runs, 1):
        axes.plot(run.time / MINUTE, run.rate / DEG_PER_H, ".-", lw=0.6, label=f"run {number}")
    finish_axes(axes, "time since power-on, min", "bias, deg/h")
    axes.legend(ncols=2)


PROCEDURE: Procedure = Procedure(
    name="fixed-position",
    group="bias",
    title="Bias at a fixed position (old method)",
    source="paper 4.1 (original method, Table 2); GJB 2426A, fibre-optic gyros",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
