"""Calibration: bias and scale-factor map fitted, applied by the electronics, and what they leave.

The gyro is measured (positions, and turns both ways), its maps are exported, and the same gyro is
measured again with the maps in its electronics, in power-ons of their own. The control applies the
maps of a gyro whose pattern axes lie 45 deg away: the fourth harmonic doubles.
"""

from collections.abc import Sequence

from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, bias_test
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.position.full_circumference import SEGMENTS, power_ons, runs_of
from pyhrg.bench.bias.position.position_variances import within_finding
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration_figure import draw
from pyhrg.bench.calibration.calibration_maps import (
    Calibration,
    angle_map,
    calibrated,
    calibration,
    plain,
    turned,
)
from pyhrg.bench.calibration.stages import of_stage, stage_bench, staged
from pyhrg.bench.outcome import Finding, Outcome, mean_finding
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.readings.segments import Segments
from pyhrg.bench.scale_factor import rate_tests
from pyhrg.bench.scale_factor.rate_tests import exclusions, turn_power_ons
from pyhrg.bench.scale_factor.scale_factor import SCALE
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

AFTER = "calibrated"
CONTROL = "wrong_map"
STAGES = {AFTER: "after", CONTROL: "with a wrong map"}
AWAY = 45 * DEG
"""Pattern axes of the gyro whose maps the control applies, from those of this one, rad."""
RATE = 15 * DEG
"""Of the turns, rad/s: fast enough that the random walk hardly disturbs the angle."""
PERIODS = 8
"""Of a turn each way: seven turns of the table tell its tilt from the bias."""
KINDS = (full_circumference.KIND, rate_tests.KIND)


def record(
    bench: Bench, plan: Plan | None = None, runs: int = RUNS, segments: int = SEGMENTS
) -> list[Test]:
    """The gyro as it is, with its maps, and with wrong ones: positions and turns both ways."""
    before = measure(bench, plan, runs, segments)
    found = calibration(bench.campaign(before))
    tests = list(before)
    for stage, angle in ((AFTER, 0.0), (CONTROL, AWAY)):
        device = applied(bench.device, found, angle)
        after = measure(stage_bench(bench, device, stage), plan, runs, segments)
        tests += staged(after, stage)
    return tests


def measure(bench: Bench, plan: Plan | None, runs: int, segments: int) -> list[Test]:
    """Make the power-ons of `measurements`."""
    return bench.run(measurements(bench, plan, runs, segments))


def measurements(bench: Bench, plan: Plan | None, runs: int, segments: int) -> list[PowerOn]:
    """Positions, and turns both ways."""
    turns = turn_power_ons(bench, RATE, PERIODS, runs)
    return [*power_ons(bench, plan, runs, segments), *turns]


def applied(device: Device, found: Calibration, angle: float = 0.0) -> Device:
    """The gyro with the maps found in its electronics, turned by an angle of pattern, rad."""
    maps = [turned(angle_map(m), angle) for m in (found.bias_map, found.scale_factor_map)]
    return calibrated(device, maps[0], maps[1], found.scale_factor)


def exported(campaign: Campaign, device: Device) -> Device:
    """The gyro with the maps that its tests give."""
    return applied(device, calibration(campaign))


def evaluate(campaign: Campaign) -> Outcome:
    """Maps with intervals; stability over the circumference before and after."""
    found = calibration(campaign)
    stages = [(name, of_stage(campaign, stage)) for stage, name in STAGES.items()]
    measured = {"before": campaign, **{name: tests for name, tests in stages if tests}}
    results = {
        name: (found if tests is campaign else calibration(tests), runs_of(tests))
        for name, tests in measured.items()
    }
    missing = () if "after" in results else (_not_applied(),)
    findings = [left(name, *result) for name, result in results.items()]
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(
            *found.bias_map.values(),
            *found.scale_factor_map.values(),
            found.rates.finding(SCALE, "scale factor error", "ppm"),
            *(finding for group in findings for finding in group),
        ),
        verdict=_verdict({f.name: f for group in findings for f in group}),
        warnings=(*found.refused, *missing),
        exclusions=tuple(text for tests in measured.values() for text in _exclusions(tests)),
        draw=lambda figure: draw_stages(figure, results),
        values={
            "bias_map": plain(angle_map(found.bias_map)),
            "scale_factor_map": plain(angle_map(found.scale_factor_map)),
            "scale_factor": found.scale_factor,
        },
    )


def _exclusions(tests: Campaign) -> tuple[str, ...]:
    """Only a rate test is asked for whole periods: between positions the table turns less."""
    positions = tests_of(tests, full_circumference.KIND)
    return (*exclusions_of(positions), *exclusions(tests, rate_tests.KIND))


def left(stage: str, found: Calibration, runs: Sequence[Segments]) -> tuple[Finding, ...]:
    """What varies over the circumference."""
    test = bias_test(runs)
    variation = found.rates.variation()
    return (
        mean_finding(
            f"bias stability {stage}",
            [run.deviation for run in test.runs],
            "deg/h",
            "with the tilt of the input axis, which is none of the map's",
        ),
        within_finding(f"within positions {stage}", runs),
        Finding(
            f"scale factor variation {stage}",
            variation.value,
            "ppm",
            variation.low,
            variation.high,
            variation.n,
            variation.note,
        ),
    )


def _not_applied() -> str:
    return "no test with the maps applied: what they leave was not measured"


def _verdict(found: dict[str, Finding]) -> str:
    before, variation = found["bias stability before"], found["scale factor variation before"]
    text = f"Bias stability {before.shown:.2g} deg/h, scale factor variation {variation.shown:.2g}"
    if "bias stability after" not in found:
        return f"{text} ppm over the circumference; maps are fitted, not verified."
    after, noise = found["bias stability after"], found["within positions after"]
    return (
        f"{text} ppm over the circumference as it is; with its maps {after.shown:.2g} deg/h (noise "
        f"alone {noise.shown:.2g}) and {found['scale factor variation after'].shown:.2g} ppm."
    )


def draw_stages(figure: Figure, results: dict[str, tuple[Calibration, list[Segments]]]) -> None:
    """Before and after, over the pattern angle."""
    shown = {name: result for name, result in results.items() if name in ("before", "after")}
    draw(figure, shown)


PROCEDURE = Procedure(
    name="calibration",
    group="calibration",
    title="Bias map and scale-factor map: fitted, applied, and what they leave",
    rows=("bias stability, room temperature", "scale factor stability, room temperature"),
    source="paper Eqs. 2, 3 and 5; tests as full-circumference and scale-factor-angle",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
    model="HRGSlow",
    step=0.1,
    exported=exported,
)
