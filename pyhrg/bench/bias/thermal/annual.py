"""Bias and scale factor over a year: a power-on a month, over the circumference and in spins.

The model ages by its decay time alone, exponentially, with the time since power-on; a gyro that is
m months old is one whose decay time is what is left of it. Axes, anisotropies, electrodes and the
Bryan factor don't age: what a year shows of a real gyro beyond the decay time, simulation can't
give.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.circumference import circumference
from pyhrg.bench.bias.thermal_programme import SPIN, SPIN_RATE, positions
from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.spread import spread_finding
from pyhrg.bench.outcome import BenchError, Finding, Outcome, pooled_deviation_finding
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.bench.readings.spins import pair_scale_factor, pairs, spins
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H, PPM, YEAR
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]

KIND = "annual"
MONTHS = 12
LEAST = 4
"""Months from which a drift and its scatter can be told apart."""
MONTH = YEAR / 12
STRAIGHT = "straight line, scatter about it independent"
AGEING = "resonator.material.decayTimeAgeing"
SEGMENTS = 2
PAIRS = 3


@dataclass(frozen=True)
class Months:
    """One figure a month.

    values: (n,), SI.
    noise: standard deviation of one month's by noise within it.
    freedom: degrees of freedom that the noise is known with.
    """

    values: Array
    noise: float
    freedom: int

    @property
    def age(self) -> Array:
        """(n,) s."""
        return np.asarray(np.arange(len(self.values)) * MONTH, dtype=np.float64)

    @property
    def drift(self) -> Fit:
        """Straight line over age, about the middle of it."""
        age = self.age
        return fit({MEAN: np.ones_like(age), "drift": age - np.mean(age)}, self.values)


def aged(device: Device, age: float) -> Device:
    """The gyro after `age` seconds: decay time exp(-decayTimeAgeing age) of what it was."""
    left = math.exp(-device.model.get(AGEING, 0.0) * age)
    return replace(device, decay_time=device.decay_time * left)


def programme(bench: Bench) -> Programme:
    """One month: eight positions, then spins each way."""
    course = bench.programme().rest(WARM_UP)
    positions(course, bench.device.bryan_factor, SEGMENTS)
    for rate in (SPIN_RATE, -SPIN_RATE) * PAIRS:
        course.spin(rate, SPIN).rest(course.interval)
    return course


def record(bench: Bench) -> list[Test]:
    """A power-on at the beginning of each month."""
    tests = []
    for month in range(MONTHS):
        older = replace(bench, device=aged(bench.device, month * MONTH))
        tests += older.run([PowerOn(f"annual_{month + 1:02d}", KIND, programme(older))])
    return tests


def evaluate(campaign: Campaign) -> Outcome:
    """Monthly figures, their deviation, range and drift; tests are a month apart, in order.

    Raises:
        BenchError: fewer than four months.
    """
    tests = tests_of(campaign, KIND)
    if len(tests) < LEAST:
        raise BenchError(
            f"{campaign.device}: {len(tests)} monthly tests; a year needs at least {LEAST}"
        )
    bias = _bias(campaign, tests)
    scale = _scale_factor_error(campaign, tests)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*_findings("bias", bias, "deg/h"), *_findings("scale factor", scale, "ppm")),
        verdict=_verdict(bias, scale),
        tables=(_table(bias, scale),),
        warnings=(
            f"tests are taken as a month apart, in order: {tests[0].id} to {tests[-1].id}",
            "of what ages, the model has the decay time alone",
        ),
        exclusions=exclusions_of(tests),
        draw=lambda figure: draw(figure, bias, scale),
    )


def _bias(campaign: Campaign, tests: Sequence[Test]) -> Months:
    """Means over the circumference; noise as the fits leave it."""
    runs = [circumference(test, campaign.site).fitted for test in tests]
    noise = np.sqrt(np.mean([run.deviation(MEAN) ** 2 for run in runs]))
    freedom = sum(run.freedom for run in runs)
    return Months(np.array([run.value(MEAN) for run in runs]), float(noise), freedom)


def _scale_factor_error(campaign: Campaign, tests: Sequence[Test]) -> Months:
    """Means over pairs of spins; noise as pairs of a month differ."""
    rate = campaign.site.vertical_rate
    months = [
        [pair_scale_factor(pair) for pair in pairs(spins(test.log, rate), test.log.source)]
        for test in tests
    ]
    each, size = pooled_deviation_finding("", months, "ppm").value, sum(map(len, months))
    noise = each * math.sqrt(len(months) / size)
    return Months(np.array([np.mean(month) for month in months]), noise, size - len(months))


def _findings(name: str, months: Months, unit: str) -> tuple[Finding, ...]:
    values, line, n = months.values, months.drift, len(months.values)
    stability, (low, high) = f"{name} annual stability", line.interval("drift")
    note = "standard deviation of the months"
    return (
        spread_finding(stability, values, months.noise, months.freedom, unit, note),
        Finding(
            f"{name} annual range", float(np.ptp(values)), unit, n=n, note="of these, no interval"
        ),
        Finding(f"{name} drift", line.value("drift"), f"{unit}/year", low, high, n, STRAIGHT),
    )


def _verdict(bias: Months, scale: Months) -> str:
    deviations = [float(np.std(months.values, ddof=1)) for months in (bias, scale)]
    return (
        f"Over {len(bias.values)} months the bias varies by {deviations[0] / DEG_PER_H:.2g} deg/h "
        f"and the scale factor by {deviations[1] / PPM:.2g} ppm (standard deviations)."
    )


def _table(bias: Months, scale: Months) -> Table:
    rows = tuple(
        (str(month), f"{b / DEG_PER_H:.5f}", f"{s / PPM:.4f}")
        for month, (b, s) in enumerate(zip(bias.values, scale.values, strict=True), 1)
    )
    return Table("Months", ("month", "mean bias, deg/h", "scale-factor error, ppm"), rows)


def draw(figure: Figure, bias: Months, scale: Months) -> None:
    """Bias and scale factor over the months, with their drifts."""
    panels = figure.subplots(2, 1, sharex=True)
    series = (
        (bias, DEG_PER_H, "bias, deg/h", "#0072B2"),
        (scale, PPM, "scale-factor error, ppm", "#D55E00"),
    )
    for panel, (months, unit, label, colour) in zip(panels, series, strict=True):
        age, line = months.age / MONTH, np.asarray(months.values - months.drift.residual)
        panel.plot(age, months.values / unit, "o", color=colour, ms=5, label="month")
        panel.plot(age, line / unit, "k-", lw=1, label="drift")
        panel.set_ylabel(label)
        panel.grid(alpha=0.3)
        panel.ticklabel_format(useOffset=False)
    panels[0].legend()
    panels[1].set_xlabel("age, months")
    figure.suptitle("A year: bias over the circumference, scale factor")


PROCEDURE = Procedure(
    name="annual",
    group="bias",
    title="Bias and scale factor over a year",
    rows=("annual bias stability", "annual scale factor stability"),
    source="paper Table 1; monthly power-ons, standard deviation and range",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
