"""Bias before, during and after vibration, and after shock, along the input axis and across it.

Each state is measured over the circumference in several power-ons, so that the power-on angle
has no effect. The case vibrates at the modal frequency, with a steady and a random part (the part
of a broadband vibration that excites the shell), and with a random low-frequency specific force.
The model itself keeps no effect of vibration or shock: a gyro that has changed is given as another
device for the power-ons afterwards.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.circumference import Circumference, fit_circumference
from pyhrg.bench.bias.environment.shock import add_pulses, find_pulses, read_quiet_changes
from pyhrg.bench.bias.thermal_programme import add_positions
from pyhrg.bench.estimation.harmonics import MEAN, name_terms
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests, select_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

BEFORE = "before_vibration"
"""Kind of the tests that the others are compared with."""
STATES = {
    "vibration_along": "during vibration along the input axis",
    "vibration_across": "during vibration across the input axis",
    "after_vibration": "after vibration",
    "after_shock": "after shock",
}
"""Kinds of tests that are compared with `BEFORE`, and their words in the findings' names."""
SHOCK = "shock"
KEPT_ANGLE = "angle kept after a pulse"
VIBRATION_AXIS = {"vibration_along": "z", "vibration_across": "x"}
"""Axis of the vibration, by kind of test."""
AFTER = [kind for kind in STATES if kind not in VIBRATION_AXIS]
RUNS = 4
SEGMENTS = 2
STEADY, RANDOM = 0.1, 0.1
"""Vibration at the modal frequency, m/s2: steady part, and rms of the part that is drawn anew in
each row."""
SHAKE = 1.0 * STANDARD_GRAVITY
"""Rms of the specific force that is drawn anew in each row, m/s2."""
ROW = 1e-3
"""Length of the shock test's rows, s, on a bench whose step is below `COARSE`."""
COARSE = 0.05
"""Communication step, s, from which on the bench keeps its own step in the shock test."""


def make_still_programme(bench: Bench) -> Programme:
    """Programme of one power-on over the circumference, without vibration."""
    course = bench.programme().rest(WARM_UP)
    add_positions(course, bench.device.bryan_factor, SEGMENTS)
    return course


def make_shock_programme(bench: Bench) -> Programme:
    """Programme of one power-on with three pulses in both directions of each axis."""
    course = bench.programme(ROW if bench.step < COARSE else bench.step).rest(WARM_UP)
    for axis in "xyz":
        for sign in (1.0, -1.0):
            add_pulses(course, axis, sign)
    return course


def make_power_ons(bench: Bench, kind: str, runs: int) -> list[PowerOn]:
    """Power-ons of one kind; vibration, along x or z, is drawn anew for each."""
    power_ons = []
    for run in range(runs):
        course = make_still_programme(bench)
        if axis := VIBRATION_AXIS.get(kind):
            generator, n = np.random.default_rng([bench.seed, ord(axis), run]), len(course)
            force = course.values(f"acceleration_{axis}") + SHAKE * generator.standard_normal(n)
            vibration = STEADY + RANDOM * generator.standard_normal(n)
            course.override(**{f"acceleration_{axis}": force, "vibration": vibration})
        power_ons.append(PowerOn(f"{kind}_{run + 1}", kind, course))
    return power_ons


def record(bench: Bench, changed: Device | None = None, runs: int = RUNS) -> list[Test]:
    """Tests of all kinds.

    `changed` is the gyro after vibration and shock (a mounting that has lost its torque has a
    larger `resonator.material.mountingDamping`); the same gyro if None.
    """
    after = replace(bench, device=changed or bench.device)
    fine = replace(bench, step=min(ROW, bench.step) if bench.step < COARSE else bench.step)
    return [
        *bench.run(
            [p for kind in (BEFORE, *VIBRATION_AXIS) for p in make_power_ons(bench, kind, runs)]
        ),
        *fine.run([PowerOn(SHOCK, SHOCK, make_shock_programme(fine))]),
        *after.run([p for kind in AFTER for p in make_power_ons(after, kind, runs)]),
    ]


def evaluate(campaign: Campaign) -> Outcome:
    """Changes of bias and bias map from before, and the response to pulses."""
    groups = {
        kind: [fit_circumference(test, campaign.site) for test in select_tests(campaign, kind)]
        for kind in (BEFORE, *STATES)
    }
    require_tests(campaign, BEFORE)
    if not any(groups[kind] for kind in STATES) and not select_tests(campaign, SHOCK):
        raise BenchError(f"{campaign.device}: nothing to compare with {BEFORE}")
    measured = {text: groups[kind] for kind, text in STATES.items() if groups[kind]}
    changes = [_estimate_changes(text, groups[BEFORE], runs) for text, runs in measured.items()]
    findings = list(chain(*changes))
    missing = [text for kind, text in STATES.items() if not groups[kind]]
    return Outcome(
        findings=(*findings, *_estimate_shock(campaign)),
        verdict=_describe_verdict(findings),
        warnings=(*(f"no record {text}" for text in missing), NO_MEMORY),
        draw=lambda figure: draw(figure, {"before": groups[BEFORE], **measured}),
    )


NO_MEMORY = (
    "vibration and shock leave no lasting change in the simulated gyro: records that differ "
    "significantly afterwards are of a device that was changed on purpose, or of a real gyro"
)


def _estimate_changes(
    text: str, before: Sequence[Circumference], after: Sequence[Circumference]
) -> tuple[Finding, ...]:
    terms = {MEAN: f"bias change {text}"}
    terms |= {name: f"bias {name} change {text}" for h in (2, 4) for name in name_terms(h)}
    changes = []
    for term, label in terms.items():
        first, second = ([r.fitted.value(term) for r in runs] for runs in (before, after))
        changes.append(estimate_change(label, first, second, "deg/h"))
    return (*changes, estimate_noise_ratio(f"noise ratio {text}", before, after))


def _estimate_shock(campaign: Campaign) -> tuple[Finding, ...]:
    logs, site = [test.log for test in select_tests(campaign, SHOCK)], campaign.site
    pulses = [pulse for log in logs for pulse in find_pulses(log, site)]
    quiet = [reading for log in logs for reading in read_quiet_changes(log, site)]
    if not pulses:
        return ()
    invalid = sum(not pulse.valid for pulse in pulses)
    note = f"{len(pulses)} pulses less {len(quiet)} readings without"
    note += f"; output invalid in {invalid}" if invalid else ""
    swing = max(pulse.swing for pulse in pulses)
    return (
        estimate_change(KEPT_ANGLE, quiet, [p.kept for p in pulses], "arcsec", note),
        Finding("largest swing of a pulse", swing, "arcsec", n=len(pulses), note="no interval"),
    )


def _describe_verdict(findings: Sequence[Finding]) -> str:
    changes = [f for f in findings if " change " in f.name]
    if not changes:
        return "The records hold pulses alone, which give no change of the bias."
    significant = [f for f in changes if f.si_low > 0 or f.si_high < 0]
    if not significant:
        return "No change of the bias or of its map is significant."
    largest = max(significant, key=lambda f: abs(f.si_value))
    term, state = largest.name.split(" change ")
    return (
        f"{len(significant)} of {len(changes)} changes are significant at 95 %, of which "
        f"{len(changes) / 20:.1g} are expected by chance; the largest is that of {term} {state}: "
        f"{largest.si_value / DEG_PER_H:.2g} deg/h."
    )


def draw(figure: Figure, groups: dict[str, Sequence[Circumference]]) -> None:
    axes = figure.add_subplot(title="Bias over the circumference before, during and after")
    colours = ("#000000", "#D55E00", "#E69F00", "#0072B2", "#009E73")
    for (text, runs), colour, marker in zip(groups.items(), colours, "o^vsD", strict=False):
        for number, run in enumerate(runs):
            angle = np.degrees(run.points.pattern_angle) % 180
            rate, label = run.points.rate / DEG_PER_H, None if number else text
            axes.plot(angle, rate, marker, color=colour, ms=3.5, alpha=0.8, label=label)
    finish_axes(axes, "pattern angle, deg", "bias, deg/h")


def estimate_change(
    name: str, before: ArrayLike, after: ArrayLike, unit: str, note: str = ""
) -> Finding:
    """Mean of `after` less mean of `before`, with Welch's interval."""
    x, y = np.asarray(before, dtype=float), np.asarray(after, dtype=float)
    value, n = float(np.mean(y) - np.mean(x)), len(x) + len(y)
    if min(len(x), len(y)) < 2:
        reason = f"{len(x)} and {len(y)} power-ons: at least 2 each for an interval"
        return Finding(name, value, unit, n=n, note=reason)
    parts = np.array([np.var(x, ddof=1) / len(x), np.var(y, ddof=1) / len(y)])
    total = float(np.sum(parts))
    if total == 0.0:
        return Finding(name, value, unit, value, value, n, note)
    freedom = total**2 / float(np.sum(parts**2 / [len(x) - 1, len(y) - 1]))
    reach = float(stats.t.ppf(0.975, freedom)) * np.sqrt(total)
    return Finding(name, value, unit, value - reach, value + reach, n, note)


def estimate_noise_ratio(
    name: str, before: Sequence[Circumference], during: Sequence[Circumference]
) -> Finding:
    """Ratio of the fits' residual standard deviations, during over before, with an F interval."""
    fits = [[run.fitted for run in runs] for runs in (before, during)]
    m, n = (sum(fit.freedom for fit in group) for group in fits)
    squares = (sum(float(fit.residual @ fit.residual) for fit in group) for group in fits)
    x, y = (square / freedom for square, freedom in zip(squares, (m, n), strict=True))
    if x <= 0:
        return Finding(name, np.nan, "1", note="no noise before")
    low, high = (np.sqrt(y / x / stats.f.ppf(p, n, m)) for p in (0.975, 0.025))
    value, size = float(np.sqrt(y / x)), sum(len(r.points) for r in (*before, *during))
    return Finding(name, value, "1", float(low), float(high), size, "of 100 s means")


PROCEDURE: Procedure = Procedure(
    name="vibration-shock",
    group="bias",
    title="Bias before, during and after vibration and shock",
    source="paper Table 1 and 2.2; GJB 2426A, vibration and shock tests",
    kinds=(BEFORE, *STATES, SHOCK),
    record=record,
    evaluate=evaluate,
)
