"""Bias before, during and after vibration, and after shock, along the input axis and across.

Each state is measured over the circumference in several power-ons, so that the power-on angle
doesn't matter. The case vibrates at the modal frequency, steadily and at random (the part of a
broadband vibration that the shell answers to), and with low-frequency specific force, held for a
row each. Nothing in the model remembers vibration or shock: a gyro that has changed is another
device, given for the power-ons afterwards.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.circumference import Circumference, circumference
from pyhrg.bench.bias.compare import change_finding, noise_ratio_finding
from pyhrg.bench.bias.environment.shock import found_pulses, pulses, readings_without
from pyhrg.bench.bias.thermal_programme import positions
from pyhrg.bench.estimation.harmonics import MEAN, harmonic
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of, usable
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

BEFORE = "before_vibration"
STATES = {
    "vibration_along": "during vibration along the input axis",
    "vibration_across": "during vibration across the input axis",
    "after_vibration": "after vibration",
    "after_shock": "after shock",
}
"""Kinds that are held against the one before, as findings name them."""
SHOCK = "shock"
KEPT = "angle kept after a pulse"
AXIS = {"vibration_along": "z", "vibration_across": "x"}
RUNS = 4
SEGMENTS = 2
STEADY, RANDOM = 0.1, 0.1
"""Vibration at the modal frequency, m/s2: steady part, and rms of what changes from row to row."""
SHAKE = 1.0 * STANDARD_GRAVITY
"""Specific force below the sampling rate, rms, m/s2."""
ROW = 1e-3
"""Rows of the shock test, s, where the gyro runs in steps below `COARSE`."""
COARSE = 0.05


def still(bench: Bench) -> Programme:
    """One power-on over the circumference."""
    course = bench.programme().rest(WARM_UP)
    positions(course, bench.device.bryan_factor, SEGMENTS)
    return course


def shaken(bench: Bench, axis: str, run: int) -> Programme:
    """The same under vibration along x or z, another in each run."""
    course, generator = still(bench), np.random.default_rng([bench.seed, ord(axis), run])
    n = len(course)
    force = course.held(f"acceleration_{axis}") + SHAKE * generator.standard_normal(n)
    vibration = STEADY + RANDOM * generator.standard_normal(n)
    course.override(**{f"acceleration_{axis}": force, "vibration": vibration})
    return course


def shocked(bench: Bench) -> Programme:
    """Three pulses both ways along each axis."""
    course = bench.programme(ROW if bench.step < COARSE else bench.step).rest(WARM_UP)
    for axis in "xyz":
        for sign in (1.0, -1.0):
            pulses(course, axis, sign)
    return course


def power_ons(bench: Bench, kind: str, runs: int) -> list[PowerOn]:
    """Of one state."""
    courses = [shaken(bench, AXIS[kind], n) if kind in AXIS else still(bench) for n in range(runs)]
    return [PowerOn(f"{kind}_{n + 1}", kind, course) for n, course in enumerate(courses)]


def record(bench: Bench, changed: Device | None = None, runs: int = RUNS) -> list[Test]:
    """All states.

    Args:
        bench: with the gyro as it was before.
        changed: the gyro as vibration and shock left it (a mounting that lost its torque adds
            `resonator.material.mountingDamping`); the same by default.
        runs: power-ons of each state.
    """
    after = replace(bench, device=changed or bench.device)
    tests = bench.run([p for kind in (BEFORE, *AXIS) for p in power_ons(bench, kind, runs)])
    fine = replace(bench, step=min(ROW, bench.step) if bench.step < COARSE else bench.step)
    tests += fine.run([PowerOn(SHOCK, SHOCK, shocked(fine))])
    kinds = [kind for kind in STATES if kind not in AXIS]
    return tests + after.run([p for kind in kinds for p in power_ons(after, kind, runs)])


def evaluate(campaign: Campaign) -> Outcome:
    """Changes of bias and of its map against before, and what pulses do.

    Raises:
        BenchError: no power-on before, or none of any other state.
    """
    groups = {
        kind: [circumference(test, campaign.site) for test in usable(campaign, kind)]
        for kind in (BEFORE, *STATES)
    }
    tests_of(campaign, BEFORE)
    if not any(groups[kind] for kind in STATES) and not usable(campaign, SHOCK):
        raise BenchError(f"{campaign.device}: nothing to compare with {BEFORE}")
    there = {text: groups[kind] for kind, text in STATES.items() if groups[kind]}
    findings = [f for text, runs in there.items() for f in _changes(text, groups[BEFORE], runs)]
    missing = [text for kind, text in STATES.items() if not groups[kind]]
    used = usable(campaign, BEFORE, *STATES, SHOCK)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*findings, *_shock(campaign)),
        verdict=_verdict(findings),
        warnings=(*(f"no record {text}" for text in missing), REMEMBERS_NOTHING),
        exclusions=exclusions_of(used),
        draw=lambda figure: draw(figure, {"before": groups[BEFORE], **there}),
    )


REMEMBERS_NOTHING = (
    "the simulated gyro remembers neither vibration nor shock: where records afterwards differ by "
    "more than their interval, they are of a device that was changed on purpose, or of a real one"
)


def _changes(
    text: str, before: Sequence[Circumference], after: Sequence[Circumference]
) -> tuple[Finding, ...]:
    terms = {MEAN: f"bias change {text}"}
    terms |= {name: f"bias {name} change {text}" for h in (2, 4) for name in harmonic(h)}
    changes = tuple(
        change_finding(label, [r.value(t) for r in before], [r.value(t) for r in after], "deg/h")
        for t, label in terms.items()
    )
    return (*changes, noise_ratio_finding(f"noise ratio {text}", before, after))


def _shock(campaign: Campaign) -> tuple[Finding, ...]:
    logs, site = [test.log for test in usable(campaign, SHOCK)], campaign.site
    found = [pulse for log in logs for pulse in found_pulses(log, site)]
    without = [reading for log in logs for reading in readings_without(log, site)]
    if not found:
        return ()
    lost = sum(not pulse.valid for pulse in found)
    note = f"{len(found)} pulses less {len(without)} readings without"
    note += f"; output invalid in {lost}" if lost else ""
    swing = max(pulse.swing for pulse in found)
    return (
        change_finding(KEPT, without, [p.kept for p in found], "arcsec", note),
        Finding("largest swing of a pulse", swing, "arcsec", n=len(found), note="no interval"),
    )


def _verdict(findings: Sequence[Finding]) -> str:
    changes = [f for f in findings if " change " in f.name]
    if not changes:
        return "Pulses alone: nothing is said of the bias."
    clear = [f for f in changes if f.low > 0 or f.high < 0]
    if not clear:
        return "No change of the bias or its map is clear of zero."
    worst = max(clear, key=lambda f: abs(f.value))
    term, state = worst.name.split(" change ")
    return (
        f"{len(clear)} of {len(changes)} changes are clear of zero, where {len(changes) / 20:.1g} "
        f"would be by chance; the largest is that of {term} {state}: "
        f"{worst.value / DEG_PER_H:.2g} deg/h."
    )


def draw(figure: Figure, groups: dict[str, Sequence[Circumference]]) -> None:
    """Bias over the circumference in each state."""
    axes = figure.add_subplot()
    colours = ("#000000", "#D55E00", "#E69F00", "#0072B2", "#009E73")
    for (text, runs), colour, marker in zip(groups.items(), colours, "o^vsD", strict=False):
        for number, run in enumerate(runs):
            angle = np.degrees(run.points.pattern_angle) % 180
            rate, label = run.points.rate / DEG_PER_H, None if number else text
            axes.plot(angle, rate, marker, color=colour, ms=3.5, alpha=0.8, label=label)
    axes.set_xlabel("pattern angle, deg")
    axes.set_ylabel("bias, deg/h")
    axes.set_title("Bias over the circumference before, during and after")
    axes.grid(alpha=0.3)
    axes.legend()


PROCEDURE = Procedure(
    name="vibration-shock",
    group="bias",
    title="Bias before, during and after vibration and shock",
    rows=("bias change before, during and after vibration", "shock resistance"),
    source="paper Table 1 and 2.2; GJB 2426A, vibration and shock tests",
    kinds=(BEFORE, *STATES, SHOCK),
    record=record,
    evaluate=evaluate,
)
