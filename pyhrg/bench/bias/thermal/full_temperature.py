"""Bias and scale factor over the temperature range: soaks over the circumference, and ramps.

The bias is fitted by pattern angle, by the resonator's temperature and by the rate of the case's
temperature, which ramps up and down separate. The loop frequency shows how the resonator's
temperature lags behind the case's.
"""

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.thermal.thermal_fit import (
    KIND,
    PER_KELVIN,
    PER_RATE,
    SOAK_RATE,
    Thermal,
    fit_temperature,
)
from pyhrg.bench.bias.thermal.thermal_scale_factor import estimate_scale_factor
from pyhrg.bench.bias.thermal_programme import make_programme
from pyhrg.bench.estimation.sizes import estimate_spread
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import Finding, Outcome, estimate_pooled_deviation
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

RUNS = 2


def record(bench: Bench) -> list[Test]:
    """Tests of two power-ons through all temperatures."""
    course = make_programme(bench)
    return bench.run([PowerOn(f"thermal_{n + 1}", KIND, course) for n in range(RUNS)])


def evaluate(campaign: Campaign) -> Outcome:
    """Bias stability, temperature coefficients, thermal lag and scale factor over temperature."""
    result = fit_temperature(campaign)
    logs = [test.log for test in require_tests(campaign, KIND)]
    scale, scale_warnings = estimate_scale_factor(campaign, logs, result.thermometers)
    meter, header = result.thermometers[0], ("temperature, degC", "mean bias, deg/h", "100 s means")
    note = meter.note
    note += "" if np.isnan(meter.lag) else "; least squares of every row, no interval"
    rows = tuple(
        (f"{level:.1f}", f"{soak.mean / DEG_PER_H:.5f}", str(soak.n))
        for level, soak in result.soaks().items()
    )
    return Outcome(
        findings=(
            *_estimate_spreads(result),
            *_make_slopes(result),
            Finding("thermal lag", meter.lag, "s", note=note),
            Finding("frequency per kelvin", meter.frequency_per_kelvin, "Hz/K", note=note),
            *scale,
        ),
        verdict=_describe_verdict(result),
        tables=(Table("Soaks", header, rows),),
        warnings=(*_list_warnings(result), *scale_warnings),
        draw=lambda figure: draw(figure, result),
        values={"terms": result.fitted.terms},
    )


def _estimate_spreads(result: Thermal) -> tuple[Finding, ...]:
    """Standard deviations of all data points (stability), of the soaks' means (over temperature)
    and of a soak's means over power-ons (repeatability)."""
    soaks = list(result.soaks().values())
    each = float(np.sqrt(np.mean([soak.deviation**2 for soak in soaks]))) if soaks else np.nan
    whole = "over the circumference" if all(s.whole for s in soaks) else "where the pattern was"
    return (
        estimate_spread(
            "bias stability over temperature",
            result.points.rate,
            result.noise,
            result.fitted.freedom,
            "deg/h",
            "standard deviation of all 100 s means, soaks and ramps",
        ),
        estimate_spread(
            "bias over temperature",
            [soak.mean for soak in soaks],
            each,
            sum(soak.freedom for soak in soaks),
            "deg/h",
            f"standard deviation of the means of {len(soaks)} soaks, {whole}",
        ),
        estimate_repeatability(result),
    )


def estimate_repeatability(result: Thermal) -> Finding:
    """Standard deviation of a soak's mean over power-ons, pooled over the soaks."""
    name, runs = "bias repeatability over temperature", int(result.run.max()) + 1
    if runs < 2:
        return Finding(name, np.nan, "deg/h", note="one power-on: at least 2 are needed")
    means = [result.soaks(run) for run in range(runs)]
    common = [t for t in means[0] if all(t in other for other in means)]
    if not common:
        return Finding(name, np.nan, "deg/h", note="no soak that all power-ons have")
    groups = [[run[t].mean for run in means] for t in common]
    note = f"{runs} power-ons at {len(common)} soaks, each soak by itself"
    return estimate_pooled_deviation(name, groups, "deg/h", note)


def _make_slopes(result: Thermal) -> tuple[Finding, ...]:
    """Coefficients of the bias by temperature and by its rate."""
    turning = [n for n in result.basis.columns if f"{PER_KELVIN} {n}" in result.fitted.names]
    units = {PER_KELVIN: "deg/h/K", PER_RATE: "deg/h/(K/min)"}
    units |= {f"{PER_KELVIN} {name}": "deg/h/K" for name in turning}
    findings = []
    for name, unit in units.items():
        if name in result.fitted.names:
            note = result.basis.place if name in (PER_KELVIN, PER_RATE) else ""
            findings.append(result.fitted.finding(name, name, unit, note=note))
        else:
            findings.append(Finding(name, np.nan, unit, note=result.refused[name]))
    return tuple(findings)


def _describe_verdict(result: Thermal) -> str:
    span = np.ptp(result.temperature)
    spread = float(np.std(result.points.rate, ddof=1))
    ratio = spread / result.noise if result.noise > 0 else np.inf
    whole = result.basis.angle is None
    source = "over the circumference" if whole else "creep of the pattern included"
    return (
        f"Bias stability {spread / DEG_PER_H:.2g} deg/h over {span:.3g} K, {source}: {ratio:.3g} "
        "times the residual of a fit by pattern angle and temperature."
    )


def _list_warnings(result: Thermal) -> tuple[str, ...]:
    sentences = list(result.refused.values())
    if result.basis.angle is not None:
        sentences.append(
            f"figures hold {result.basis.place}: the pattern moved by "
            f"{np.degrees(np.ptp(result.points.pattern_angle)):.3g} deg only, and the standard "
            "deviations hold the bias map over that range"
        )
    if len(result.soaks()) < 3:
        sentences.append(f"{len(result.soaks())} soaks: too few for a useful standard deviation")
    sentences += [f"thermal lag {m.note}" for m in result.thermometers if np.isnan(m.lag)]
    return tuple(dict.fromkeys(sentences))


def draw(figure: Figure, result: Thermal) -> None:
    axes = figure.add_subplot(
        title=f"Bias over temperature, without its map ({result.basis.place})"
    )
    bias = (result.points.rate - result.compute_map()) / DEG_PER_H
    resting, up = np.abs(result.rate) < SOAK_RATE, result.rate > 0
    groups = (
        ("case steady", resting, "#000000", "o"),
        ("ramp up", ~resting & up, "#D55E00", "^"),
        ("ramp down", ~resting & ~up, "#0072B2", "v"),
    )
    for label, chosen, colour, marker in groups:
        points = (result.temperature[chosen], bias[chosen], marker)
        axes.plot(*points, color=colour, label=label, ms=3.5)
    finish_axes(axes, "resonator above the reference temperature, K", "bias, deg/h")


PROCEDURE: Procedure = Procedure(
    name="full-temperature",
    group="bias",
    title="Bias and scale factor over temperature",
    source="paper Table 1; GJB 2426A and IEEE Std 1431, temperature tests: soaks and ramps",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
