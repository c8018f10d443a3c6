"""Calibration: maps of bias and scale factor are fitted, the electronics apply them, and the
calibration residual is measured.

The gyro is measured (positions, and turns both ways), its maps are exported, and the same gyro is
measured again with the maps in its electronics, in power-ons of their own. The control applies the
maps of a gyro whose pattern axes lie 45 deg away: the fourth harmonic doubles.
"""

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, BiasTest
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.position.full_circumference import SEGMENTS, make_power_ons, read_runs
from pyhrg.bench.bias.position.positions import Plan, estimate_within
from pyhrg.bench.calibration.calibration_maps import (
    Calibration,
    add_maps,
    fit_maps,
    make_angle_map,
    turn_map,
)
from pyhrg.bench.figures import COLOURS, finish_axes
from pyhrg.bench.outcome import Finding, Outcome, estimate_mean
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.segments import Points
from pyhrg.bench.scale_factor import scale_factor
from pyhrg.bench.scale_factor.scale_factor import list_unused_turns, make_turn_power_ons
from pyhrg.common.units import DEG, DEG_PER_H, PPM
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

AFTER = "calibrated"
CONTROL = "wrong_map"
STAGES = {AFTER: "after", CONTROL: "with a wrong map"}
AWAY = 45 * DEG
"""Pattern axes of the gyro whose maps the control applies, from those of this one, rad."""
RATE = 15 * DEG
"""Rate of the turns, rad/s: fast enough that the random walk hardly disturbs the angle."""
PERIODS = 8
"""Periods of a turn each way: over seven turns of the table its tilt separates from the bias."""
KINDS = tuple(
    f"{kind}{stage}"
    for stage in ("", *(f"_{name}" for name in STAGES))
    for kind in (full_circumference.KIND, scale_factor.KIND)
)


def record(
    bench: Bench, plan: Plan | None = None, runs: int = RUNS, segments: int = SEGMENTS
) -> list[Test]:
    """The gyro as it is, with its maps, and with wrong ones: positions and turns both ways."""
    before = bench.run(plan_power_ons(bench, plan, runs, segments))
    calibration = fit_maps(bench.campaign(before))
    tests = list(before)
    for stage, angle in ((AFTER, 0.0), (CONTROL, AWAY)):
        device = apply_maps(bench.device, calibration, angle)
        after = stage_bench(bench, device, stage)
        tests += label_stage(after.run(plan_power_ons(after, plan, runs, segments)), stage)
    return tests


def plan_power_ons(bench: Bench, plan: Plan | None, runs: int, segments: int) -> list[PowerOn]:
    """Positions, and turns both ways."""
    turns = make_turn_power_ons(bench, RATE, PERIODS, runs)
    return [*make_power_ons(bench, plan, runs, segments), *turns]


def calibrate_once(bench: Bench, plan: Plan | None = None) -> Calibration:
    """A maker's calibration: the maps of the gyro as it is, from one power-on at each position,
    one segment each, and one of each turn."""
    power_ons = plan_power_ons(bench, plan, runs=1, segments=1)
    return fit_maps(bench.campaign(bench.log_all(power_ons)))


def apply_maps(device: Device, calibration: Calibration, angle: float = 0.0) -> Device:
    """The gyro with the maps found in its electronics, turned by an angle of pattern, rad."""
    maps = [
        turn_map(make_angle_map(m), angle)
        for m in (calibration.bias_map, calibration.scale_factor_map)
    ]
    return add_maps(device, maps[0], maps[1], calibration.scale_factor)


def export_device(campaign: Campaign, device: Device) -> Device:
    """The gyro with the maps that its tests give."""
    return apply_maps(device, fit_maps(campaign))


def evaluate(campaign: Campaign) -> Outcome:
    """Maps with intervals; stability over the circumference before and after."""
    calibration = fit_maps(campaign)
    stages = [(name, select_stage(campaign, stage)) for stage, name in STAGES.items()]
    measured = {"before": campaign, **{name: tests for name, tests in stages if tests}}
    results = {
        name: (calibration if tests is campaign else fit_maps(tests), read_runs(tests))
        for name, tests in measured.items()
    }
    missing = "no test with the maps applied: what they leave was not measured"
    findings = [find_residual_variation(name, *result) for name, result in results.items()]
    return Outcome(
        findings=(
            *calibration.findings,
            *(finding for group in findings for finding in group),
        ),
        verdict=_verdict({f.name: f for group in findings for f in group}),
        warnings=calibration.refused if "after" in results else (*calibration.refused, missing),
        exclusions=tuple(
            text
            for tests in measured.values()
            for text in list_unused_turns(tests, scale_factor.KIND)
        ),
        draw=lambda figure: draw(figure, results),
        values={
            "bias_map": asdict(make_angle_map(calibration.bias_map)),
            "scale_factor_map": asdict(make_angle_map(calibration.scale_factor_map)),
            "scale_factor": calibration.scale_factor,
        },
    )


def find_residual_variation(
    stage: str, calibration: Calibration, runs: Sequence[Points]
) -> tuple[Finding, ...]:
    """What varies over the circumference."""
    deviations = BiasTest(runs).deviations
    note = "with the tilt of the input axis, which is none of the map's"
    return (
        estimate_mean(f"bias stability {stage}", deviations, "deg/h", note),
        estimate_within(f"within positions {stage}", runs),
        replace(calibration.rates.variation(), name=f"scale factor variation {stage}"),
    )


def _verdict(findings: dict[str, Finding]) -> str:
    before, variation = findings["bias stability before"], findings["scale factor variation before"]
    text = f"Bias stability {before.value:.2g} deg/h, scale factor variation "
    text += f"{variation.value:.2g}"
    if "bias stability after" not in findings:
        return f"{text} ppm over the circumference; maps are fitted, not verified."
    after, noise = findings["bias stability after"], findings["within positions after"]
    variation_after = findings["scale factor variation after"]
    return (
        f"{text} ppm over the circumference as it is; with its maps {after.value:.2g} "
        f"deg/h (noise alone {noise.value:.2g}) and {variation_after.value:.2g} "
        "ppm."
    )


def draw(figure: Figure, stages: Mapping[str, tuple[Calibration, Sequence[Points]]]) -> None:
    """Before and after: left the position test's points, right the fitted scale factor."""
    bias, scale = figure.subplots(1, 2)
    grid = np.linspace(0.0, np.pi, 361)
    for name, colour in (("before", COLOURS[1]), ("after", COLOURS[0])):
        if name in stages:
            calibration, runs = stages[name]
            angle = np.concatenate([run.pattern_angle for run in runs]) % np.pi / DEG
            rate = (
                np.concatenate([calibration.positions.remove_tilt(run) for run in runs]) / DEG_PER_H
            )
            bias.plot(angle, rate, ".", ms=3, color=colour, label=name)
            scale.plot(grid / DEG, calibration.rates.evaluate(grid) / PPM, color=colour, label=name)
    bias.set_title("Position test, tilt removed")
    scale.set_title("Turns both ways")
    for axes, label in ((bias, "bias, deg/h"), (scale, "scale factor less its mean, ppm")):
        finish_axes(axes, "pattern angle, deg", label, xlim=(0, 180))


def label_stage(tests: Sequence[Test], stage: str) -> list[Test]:
    """Tests under the name of a stage: kind and id carry it."""
    return [
        replace(
            test,
            id=f"{test.id}_{stage}",
            kind=f"{test.kind}_{stage}",
            recording=replace(test.log, source=f"{test.log.source}_{stage}"),
        )
        for test in tests
    ]


def select_stage(campaign: Campaign, stage: str) -> Campaign | None:
    """The tests of a stage alone, under their plain kinds; None where there are none."""
    suffix = f"_{stage}"
    staged = (test for test in campaign.tests if test.kind.endswith(suffix))
    tests = [replace(test, kind=test.kind.removesuffix(suffix)) for test in staged]
    return replace(campaign, tests=tuple(tests)) if tests else None


def stage_bench(bench: Bench, device: Device, stage: str) -> Bench:
    """The bench with another gyro on it, or the same one set otherwise, and noise of its own."""
    key = zlib.crc32(stage.encode())
    (seed,) = np.random.SeedSequence(bench.seed, spawn_key=(key,)).generate_state(1)
    return replace(bench, device=device, seed=int(seed) % 2**31)


PROCEDURE: Procedure = Procedure(
    name="calibration",
    group="calibration",
    title="Bias map and scale-factor map: fitted, applied, and what they leave",
    source="paper Eqs. 2, 3 and 5; tests as full-circumference and scale-factor-angle",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
    model="HRGSlow",
    step=0.1,
    export=export_device,
)
