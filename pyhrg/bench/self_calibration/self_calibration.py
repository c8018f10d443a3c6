"""Self-calibration by virtual rotation: its gain and its cost (paper 2.5 and 4.2).

The drives turn the pattern by whole periods of the bias map, one way and back. The mean of such a
cycle is the bias over the circumference. The harmonics average out, and so does the gain error of
the rotation, which changes its sign. Without rotation, the bias is that of the pattern's angle. The
cost is the noise of the rotation: an angle random walk of V sqrt(S).
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS
from pyhrg.bench.estimation import angle_fit
from pyhrg.bench.estimation.angle_fit import AngleFit, Record
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_deviation, estimate_mean
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.output_rows import read_bryan_factor
from pyhrg.bench.readings.turns import find_turns
from pyhrg.bench.scale_factor.scale_factor import fit_scale_factor_map
from pyhrg.bench.self_calibration import cycles
from pyhrg.bench.self_calibration.cycles import (
    BIAS,
    GAIN,
    SCALE,
    Cycle,
    Sweep,
    find_averaging_time,
    find_pooled_deviation,
    find_sweeps,
    select_orders,
)
from pyhrg.common.pages.svg import format_interval
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

KIND = "self_calibration"
KINDS = (KIND, "virtual_rotation", "static")
ROTATION = 1 * DEG
"""Virtual rotation, as an input rate, rad/s."""
TABLE_RATE = 5 * DEG
CYCLES = 3
WARM_UP = 30.0
MARGIN = 5.0
"""Time beyond a whole sweep, for settling, s."""
CREEP = 5 * DEG
"""Pattern angle beyond which a creeping pattern's bias is no cubic in time any more, rad."""
TURN = 200.0
"""Time of the table at one rate and one virtual rotation, s: more than 180 deg of pattern."""


def make_programme(bench: Bench, rotation: float, count: int = CYCLES) -> Programme:
    """One power-on, axis level: cycles at rest, then the table turns both ways.

    The rotation is in rad/s; 0 gives the same without virtual rotation.
    """
    sweep = float(np.ceil(180 * DEG / (bench.device.bryan_factor * ROTATION))) + MARGIN
    course = bench.programme().attitude(0.0).rest(WARM_UP)
    for _ in range(count):
        for sign in (1.0, -1.0):
            course.command(virtual_rotation=sign * rotation).rest(sweep)
    for rate in (TABLE_RATE, -TABLE_RATE):
        for sign in (1.0, -1.0):
            course.command(virtual_rotation=sign * rotation).spin(rate, TURN)
    return course


def record(bench: Bench, runs: int = RUNS, count: int = CYCLES) -> list[Test]:
    """Seven power-ons with virtual rotation and seven without, both left all around the
    circumference."""
    angles = bench.device.power_on_angle + np.arange(runs) * 180 * DEG / runs
    courses = {"on": make_programme(bench, ROTATION, count), "off": make_programme(bench, 0, count)}
    return bench.run(
        [
            PowerOn(f"self_calibration_{name}_{run}", KIND, course, float(angle))
            for name, course in courses.items()
            for run, angle in enumerate(angles, 1)
        ]
    )


GAIN_ERROR = "virtual rotation gain error"
HELD = "with the hold of the forces, -Ts/2 tau, and -(W_L/V)^2/2 of a large map"


def evaluate(campaign: Campaign) -> Outcome:
    """Bias, stability, repeatability, scale factor and random walk, on and off."""
    tests = require_tests(campaign, *KINDS)
    sweeps = [find_sweeps(test.log, campaign.site) for test in tests]
    rotating = [[s for s in log if s.virtual_rotation != 0.0] for log in sweeps]
    resting = [[s for s in log if s.virtual_rotation == 0.0 == s.table_rate] for log in sweeps]
    on = cycles.pair_cycles(rotating)
    off = cycles.cut_rests([log for log in resting if log], find_averaging_time(on))
    turning, rotation = _rotating_fit([s for log in rotating for s in log])
    still, rest = _resting_fit([s for log in resting for s in log])
    walks = angle_fit.estimate_walk(turning, rotation), angle_fit.estimate_walk(still, rest)
    ratio = angle_fit.estimate_walk_ratio("random walk on over off", *walks)
    bias = estimate_mean("bias on", [c.rate for run in on for c in run], "deg/h")
    gain = estimate_mean(GAIN_ERROR, [c.gain for r in on for c in r], "ppm", HELD)
    findings = (
        bias,
        *_scatter("on", on),
        *_scatter("off", off),
        gain,
        *_scale_factors(campaign, turning),
        angle_fit.make_walk_finding("angle random walk on", walks[0]),
        angle_fit.make_walk_finding("angle random walk off", walks[1]),
        ratio,
    )
    return Outcome(
        findings=findings,
        verdict=_verdict({finding.name: finding for finding in findings}),
        warnings=(*cycles.list_warnings(on), *_crept(resting)),
        draw=lambda figure: draw(figure, on, off),
        values={"bias_on": bias.si_value, "virtual_rotation_gain_error": gain.si_value},
    )


def _crept(resting: list[list[Sweep]]) -> tuple[str, ...]:
    most = max(np.ptp(sweep.pattern_angle) for log in resting for sweep in log)
    if most < CREEP:
        return ()
    return (
        f"without virtual rotation the pattern crept over {most / DEG:.2g} deg of the bias map: "
        "what a cubic in time leaves of that passes for random walk",
    )


def _scatter(name: str, runs: list[list[Cycle]]) -> tuple[Finding, ...]:
    """Stability and repeatability of means over a cycle."""
    rates = [[cycle.rate for cycle in run] for run in runs]
    means = [float(np.mean(run)) for run in rates]
    note = f"means of {find_averaging_time(runs):.0f} s within a power-on"
    return (
        find_pooled_deviation(f"bias stability {name}", rates, note),
        estimate_deviation(f"bias repeatability {name}", means, "deg/h", "between power-ons"),
    )


def _rotating_fit(sweeps: list[Sweep]) -> tuple[AngleFit, list[Record]]:
    kinds = [BIAS, GAIN] + ([SCALE] if any(s.table_rate != 0.0 for s in sweeps) else [])
    if len({np.sign(s.virtual_rotation) for s in sweeps}) < 2:
        raise BenchError(
            f"{', '.join(sorted({s.source for s in sweeps})) or 'campaign'}: virtual rotation "
            "is needed both ways, else its gain error looks like a bias"
        )
    orders = select_orders(sweeps, kinds)
    records = [sweep.record(orders, kinds) for sweep in sweeps]
    return angle_fit.fit_angles(records), records


def _resting_fit(sweeps: list[Sweep]) -> tuple[AngleFit, list[Record]]:
    """Each stretch has its own bias, which drifts as Earth carries the pattern over the map."""
    if not sweeps:
        raise BenchError("no stretch at rest without virtual rotation to compare with")
    records = []
    for number, sweep in enumerate(sweeps):
        time = (sweep.time - sweep.time[0]) / (sweep.time[-1] - sweep.time[0])
        powers = [(i, power) for i in range(len(sweeps)) for power in (1, 2, 3)]
        columns = {f"{i}, {power}": time**power * (i == number) for i, power in powers}
        records.append(Record(sweep.interval, sweep.excess, columns))
    return angle_fit.fit_angles(records), records


def _scale_factors(campaign: Campaign, turning: AngleFit) -> tuple[Finding, ...]:
    if SCALE not in turning.names:
        note = "no record with the table turning under virtual rotation"
        return (Finding("scale factor error on", np.nan, "ppm", note=note),)
    logs = [t for t in require_tests(campaign, KIND) if not np.any(t.log.virtual_rotation)]
    off = fit_scale_factor_map(
        [turn for test in logs for turn in find_turns(test.log, campaign.site)],
        read_bryan_factor(campaign),
    )
    return (
        turning.finding(SCALE, "scale factor error on", "ppm", note="first order in g and gd"),
        off.fit.finding(SCALE, "scale factor error off", "ppm", note="first order in g and gd"),
    )


def _verdict(findings: dict[str, Finding]) -> str:
    on, off = findings["bias repeatability on"], findings["bias repeatability off"]
    ratio = findings["random walk on over off"]
    text = (
        "Virtual rotation multiplies the angle random walk by "
        f"{format_interval(ratio.value, *ratio.interval)}"
    )
    if np.isnan(on.si_value) or np.isnan(off.si_value):
        return f"{text}; one power-on can't show what it gains in repeatability."
    gained = f"{off.si_value / DEG_PER_H:.2g} to {on.si_value / DEG_PER_H:.2g} deg/h"
    return f"{text}; repeatability over the power-on angles goes from {gained}."


def draw(figure: Figure, on: Sequence[Sequence[Cycle]], off: Sequence[Sequence[Cycle]]) -> None:
    axes = figure.add_subplot(title="Self-calibration by virtual rotation", xlim=(0, 180))
    for runs, mark, colour, label in (
        (off, "s", "#D55E00", "off: pattern left where it is"),
        (on, "o", "#0072B2", "on: one way and back"),
    ):
        points = [(c.pattern_angle, c.rate) for run in runs for c in run]
        angle, rate = np.array(points).T
        axes.plot(angle % np.pi / DEG, rate / DEG_PER_H, mark, color=colour, label=label)
    finish_axes(axes, "pattern angle at the beginning, deg", "mean output at rest, deg/h")


PROCEDURE: Procedure = Procedure(
    name="self-calibration",
    group="self-calibration",
    title="Self-calibration by virtual rotation: gained and lost",
    source="paper 2.5 and 4.2 (left open there)",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
    model="HRGSlow",
    step=0.1,
)
