"""The old bias test: the gyro rests, and the pattern stays where it is.

Procedure of the fibre-optic gyro standards, as the paper's sections 1.2 and 4.1 describe it. The
input axis is level and points east, so that no Earth rate moves the pattern during the hour.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, BiasTest, bias_test
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Segments, segment_means
from pyhrg.common.units import DEG, DEG_PER_H, MINUTE
from pyhrg.records.campaign import Campaign, Test

SEGMENTS = 36
"""Data points of a run: one hour."""
KIND = "static"


def programme(bench: Bench, segments: int = SEGMENTS) -> Programme:
    """One power-on: at rest, input axis east."""
    return bench.programme().attitude(0.0).rest(WARM_UP + segments * SEGMENT)


def power_ons(bench: Bench, runs: int = RUNS, segments: int = SEGMENTS) -> list[PowerOn]:
    """Seven of an hour each."""
    course = programme(bench, segments)
    return [PowerOn(f"fixed_{n + 1}", KIND, course) for n in range(runs)]


def record(bench: Bench) -> list[Test]:
    """Run them."""
    return bench.run(power_ons(bench))


def measured(campaign: Campaign) -> BiasTest:
    """Means, stability and repeatability of the campaign's static tests."""
    return bias_test(runs_of(campaign))


def runs_of(campaign: Campaign) -> list[Segments]:
    """Data points of each power-on.

    Raises:
        BenchError: there are none, or one has too few data points.
    """
    latitude = campaign.site.latitude
    logs = [test.log for test in tests_of(campaign, KIND)]
    runs = [segment_means(log, latitude, 0.0, warm_up=WARM_UP) for log in logs]
    for log, run in zip(logs, runs, strict=True):
        if len(run) < 2:
            raise BenchError(
                f"{log.source}: {len(run)} segment of {SEGMENT:g} s; expected 2 or more"
            )
    return runs


def evaluate(campaign: Campaign) -> Outcome:
    """The old figure, and over how little of the circumference it was taken."""
    runs = runs_of(campaign)
    test = bias_test(runs)
    logs = [test.log for test in tests_of(campaign, KIND)]
    swept = max(float(np.nanmax(log.wave_angle) - np.nanmin(log.wave_angle)) for log in logs)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=test.findings(),
        verdict=(
            f"Bias stability {test.stability / DEG_PER_H:.2g} deg/h at a fixed position: the "
            f"pattern moved over {swept / DEG:.2g} of the 90 deg of a period of the bias map, so "
            "that this figure says nothing of the rest."
        ),
        tables=(test.table(),),
        exclusions=exclusions_of(tests_of(campaign, KIND)),
        draw=lambda figure: draw(figure, runs),
    )


def draw(figure: Figure, runs: Sequence[Segments]) -> None:
    """Data points against time, a line a power-on."""
    axes = figure.add_subplot()
    for number, run in enumerate(runs, 1):
        axes.plot(run.time / MINUTE, run.rate / DEG_PER_H, ".-", lw=0.6, label=f"run {number}")
    axes.set_xlabel("time since power-on, min")
    axes.set_ylabel("bias, deg/h")
    axes.set_title(f"Fixed position, {SEGMENT:g} s means")
    axes.grid(alpha=0.3)
    axes.legend(ncols=2)


PROCEDURE = Procedure(
    name="fixed-position",
    group="bias",
    title="Bias at a fixed position (old method)",
    rows=("bias stability, room temperature", "bias repeatability, room temperature"),
    source="paper 4.1 (original method, Table 2); GJB 2426A, fibre-optic gyros",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
