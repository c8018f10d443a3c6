"""The conventional bias test: the gyro rests and the pattern stays at one angle.

This is the procedure of the fibre-optic gyro standards, which the paper describes in 1.2 and 4.1.
The input axis is level and points east, so that Earth's rate doesn't move the pattern.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, summarize_runs
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, list_exclusions, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Points, read_segments
from pyhrg.common.units import DEG, DEG_PER_H, MINUTE
from pyhrg.records.campaign import Campaign, Test

SEGMENTS = 36
"""Data points of a run: one hour."""
KIND = "static"


def make_programme(bench: Bench, segments: int = SEGMENTS) -> Programme:
    """Programme of one power-on: at rest, input axis east."""
    return bench.programme().attitude(0.0).rest(WARM_UP + segments * SEGMENT)


def make_power_ons(bench: Bench, runs: int = RUNS, segments: int = SEGMENTS) -> list[PowerOn]:
    """Power-ons, by default seven of an hour each."""
    course = make_programme(bench, segments)
    return [PowerOn(f"fixed_{n + 1}", KIND, course) for n in range(runs)]


def record(bench: Bench) -> list[Test]:
    """Tests of the power-ons."""
    return bench.run(make_power_ons(bench))


def read_runs(campaign: Campaign) -> list[Points]:
    """Data points of each power-on."""
    latitude = campaign.site.latitude
    logs = [test.log for test in require_tests(campaign, KIND)]
    runs = [read_segments(log, latitude, 0.0) for log in logs]
    for log, run in zip(logs, runs, strict=True):
        if len(run) < 2:
            raise BenchError(
                f"{log.source}: {len(run)} segment of {SEGMENT:g} s; expected 2 or more"
            )
    return runs


def evaluate(campaign: Campaign) -> Outcome:
    """Bias, stability and repeatability, and the range of pattern angle that they are taken at."""
    runs = read_runs(campaign)
    test = summarize_runs(runs)
    tests = require_tests(campaign, KIND)
    logs = [test.log for test in tests]
    swept = max(float(np.nanmax(log.wave_angle) - np.nanmin(log.wave_angle)) for log in logs)
    return Outcome(
        findings=test.findings(),
        verdict=(
            f"Bias stability {test.stability / DEG_PER_H:.2g} deg/h at a fixed position: the "
            f"pattern moved over {swept / DEG:.2g} of the 90 deg of a period of the bias map, and "
            "the figure holds for that part alone."
        ),
        tables=(test.table(),),
        exclusions=list_exclusions(tests),
        draw=lambda figure: draw(figure, runs),
    )


def draw(figure: Figure, runs: Sequence[Points]) -> None:
    """Draw the data points against time, one line for each power-on."""
    axes = figure.add_subplot(title=f"Fixed position, {SEGMENT:g} s means")
    for number, run in enumerate(runs, 1):
        axes.plot(run.time / MINUTE, run.rate / DEG_PER_H, ".-", lw=0.6, label=f"run {number}")
    axes.set(xlabel="time since power-on, min", ylabel="bias, deg/h")
    axes.grid(alpha=0.3)
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
