"""Bias and scale factor over the temperature range: soaks over the circumference, and ramps.

Bias is fitted by pattern angle, by the resonator's temperature (its loop frequency tells how it
lags behind the case) and by the rate of the case's temperature, which ramps up and down tell apart.
"""

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.thermal.thermal_fit import (
    KIND,
    PER_KELVIN,
    PER_RATE,
    STEADY,
    Thermal,
    measured,
)
from pyhrg.bench.bias.thermal.thermal_scale_factor import scale_factor_findings
from pyhrg.bench.bias.thermal_programme import programme
from pyhrg.bench.estimation.spread import spread_finding
from pyhrg.bench.outcome import Finding, Outcome, pooled_deviation_finding
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

RUNS = 2


def record(bench: Bench) -> list[Test]:
    """Two power-ons through all temperatures."""
    course = programme(bench)
    return bench.run([PowerOn(f"thermal_{n + 1}", KIND, course) for n in range(RUNS)])


def evaluate(campaign: Campaign) -> Outcome:
    """Bias stability, bias over temperature, slopes, temperature-rate bias, lag, scale factor."""
    result = measured(campaign)
    logs = [test.log for test in tests_of(campaign, KIND)]
    scale, told = scale_factor_findings(campaign, logs, result.thermometers)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*_spreads(result), *_slopes(result), *_lag(result), *scale),
        verdict=_verdict(result),
        tables=(_table(result),),
        warnings=(*_warnings(result), *told),
        exclusions=exclusions_of(tests_of(campaign, KIND)),
        draw=lambda figure: draw(figure, result),
        values={"terms": dict(zip(result.fitted.names, result.fitted.values, strict=True))},
    )


def _spreads(result: Thermal) -> tuple[Finding, ...]:
    """Stability: of all data points. Over temperature: of the soaks' means. Repeatability: over
    power-ons, of a soak's means."""
    soaks = list(result.soaks().values())
    each = float(np.sqrt(np.mean([soak.deviation**2 for soak in soaks]))) if soaks else np.nan
    whole = "over the circumference" if all(s.whole for s in soaks) else "where the pattern was"
    return (
        spread_finding(
            "bias stability over temperature",
            result.points.rate,
            result.noise,
            result.fitted.freedom,
            "deg/h",
            "standard deviation of all 100 s means, soaks and ramps",
        ),
        spread_finding(
            "bias over temperature",
            [soak.mean for soak in soaks],
            each,
            sum(soak.freedom for soak in soaks),
            "deg/h",
            f"standard deviation of the means of {len(soaks)} soaks, {whole}",
        ),
        repeatability(result),
    )


def repeatability(result: Thermal) -> Finding:
    """Standard deviation over power-ons of a soak's mean, pooled over soaks."""
    name, runs = "bias repeatability over temperature", int(result.run.max()) + 1
    if runs < 2:
        return Finding(name, np.nan, "deg/h", note="one power-on: at least 2 are needed")
    means = [result.soaks(run) for run in range(runs)]
    common = [t for t in means[0] if all(t in other for other in means)]
    if not common:
        return Finding(name, np.nan, "deg/h", note="no soak that all power-ons have")
    groups = [[run[t].mean for run in means] for t in common]
    note = f"{runs} power-ons at {len(common)} soaks, each soak by itself"
    return pooled_deviation_finding(name, groups, "deg/h", note)


def _slopes(result: Thermal) -> tuple[Finding, ...]:
    """Of the bias by temperature and by its rate."""
    turning = [n for n in result.basis.columns if f"{PER_KELVIN} {n}" in result.fitted.names]
    units = {PER_KELVIN: "deg/h/K", PER_RATE: "deg/h/(K/min)"}
    units |= {f"{PER_KELVIN} {name}": "deg/h/K" for name in turning}
    found = []
    for name, unit in units.items():
        if name in result.fitted.names:
            low, high = result.fitted.interval(name)
            note = result.basis.place if name in (PER_KELVIN, PER_RATE) else ""
            value, n = result.fitted.value(name), len(result.points)
            found.append(Finding(name, value, unit, low, high, n, note))
        else:
            found.append(Finding(name, np.nan, unit, note=result.refused[name]))
    return tuple(found)


def _lag(result: Thermal) -> tuple[Finding, ...]:
    """Of the first power-on, by its loop frequency."""
    meter = result.thermometers[0]
    note = meter.note
    if not np.isnan(meter.lag):
        note += "; least squares of every row, no interval"
    return (
        Finding("thermal lag", meter.lag, "s", note=note),
        Finding("frequency per kelvin", meter.frequency_per_kelvin, "Hz/K", note=note),
    )


def _verdict(result: Thermal) -> str:
    span = np.ptp(result.temperature)
    spread = float(np.std(result.points.rate, ddof=1))
    ratio = spread / result.noise if result.noise > 0 else np.inf
    source = (
        "over the circumference" if result.basis.angle is None else "creep of the pattern included"
    )
    return (
        f"Bias stability {spread / DEG_PER_H:.2g} deg/h over {span:.3g} K, {source}: {ratio:.3g} "
        "times the noise that a fit by pattern angle and temperature leaves."
    )


def _warnings(result: Thermal) -> tuple[str, ...]:
    told = list(result.refused.values())
    if result.basis.angle is not None:
        told.append(
            f"figures hold {result.basis.place}: the pattern moved by "
            f"{np.degrees(np.ptp(result.points.pattern_angle)):.3g} deg only, and the deviations "
            "hold what it moved over"
        )
    if len(result.soaks()) < 3:
        told.append(f"{len(result.soaks())} soaks: their deviation says little")
    told += [f"thermal lag {m.note}" for m in result.thermometers if np.isnan(m.lag)]
    return tuple(dict.fromkeys(told))


def _table(result: Thermal) -> Table:
    rows = tuple(
        (f"{level:.1f}", f"{soak.mean / DEG_PER_H:.5f}", str(soak.n))
        for level, soak in result.soaks().items()
    )
    return Table("Soaks", ("temperature, degC", "mean bias, deg/h", "100 s means"), rows)


def draw(figure: Figure, result: Thermal) -> None:
    """Bias against the resonator's temperature: soaks, ramps up and down."""
    axes = figure.add_subplot()
    bias = (result.points.rate - result.of_pattern()) / DEG_PER_H
    resting, up = np.abs(result.rate) < STEADY, result.rate > 0
    groups = (
        ("case steady", resting, "#000000", "o"),
        ("ramp up", ~resting & up, "#D55E00", "^"),
        ("ramp down", ~resting & ~up, "#0072B2", "v"),
    )
    for label, chosen, colour, marker in groups:
        axes.plot(
            result.temperature[chosen], bias[chosen], marker, color=colour, label=label, ms=3.5
        )
    axes.set_xlabel("resonator above the reference temperature, K")
    axes.set_ylabel("bias, deg/h")
    axes.set_title(f"Bias over temperature, its map taken out ({result.basis.place})")
    axes.grid(alpha=0.3)
    axes.legend()


PROCEDURE = Procedure(
    name="full-temperature",
    group="bias",
    title="Bias and scale factor over temperature",
    rows=(
        "bias stability, full temperature",
        "bias repeatability, full temperature",
        "scale factor stability, full temperature",
        "scale factor repeatability, full temperature",
    ),
    source="paper Table 1; GJB 2426A and IEEE Std 1431, temperature tests: soaks and ramps",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
