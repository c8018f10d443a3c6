"""Bias and scale factor over a year: one power-on a month, over the circumference and in spins.

In the model only the decay time ages, exponentially with time. A gyro of an age is simulated as one
with the decay time of that age. Axes, anisotropies, electrodes and the angular gain of a real gyro
age too, which this simulation doesn't show.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.circumference import fit_circumference
from pyhrg.bench.bias.thermal_programme import SPIN, SPIN_RATE, add_positions
from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.sizes import estimate_spread
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_pooled_deviation
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.bench.readings.turns import compute_scale_factor_error, find_spins, pair_spins
from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H, PPM, YEAR
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test

KIND = "annual"
MONTHS = 12
FEWEST_MONTHS = 4
"""Fewest months from which a drift and the scatter about it are estimated."""
MONTH = YEAR / 12
DRIFT_NOTE = "straight line, scatter about it independent"
AGEING = "resonator.material.decayTimeAgeing"
SEGMENTS = 2
PAIRS = 3


@dataclass(frozen=True)
class Months:
    """A quantity that is measured once a month.

    Attributes:
        values: (n,) SI.
        noise: standard deviation of a month's value by noise within the month, SI.
        freedom: degrees of freedom of `noise`.
    """

    values: Array
    noise: float
    freedom: int

    @property
    def age(self) -> Array:
        """(n,) age at each test, s, counted from the first."""
        return np.asarray(np.arange(len(self.values)) * MONTH, dtype=np.float64)

    @property
    def drift(self) -> Fit:
        """Straight line against the age, about its mean."""
        age = self.age
        return fit({MEAN: np.ones_like(age), "drift": age - np.mean(age)}, self.values)


def age_device(device: Device, age: float) -> Device:
    """The gyro at an age, s: its decay time is multiplied by exp(-decayTimeAgeing age)."""
    share = math.exp(-device.model.get(AGEING, 0.0) * age)
    return replace(device, decay_time=device.decay_time * share)


def make_programme(bench: Bench) -> Programme:
    """Programme of one month: eight positions, then spins in both directions."""
    course = bench.programme().rest(WARM_UP)
    add_positions(course, bench.device.bryan_factor, SEGMENTS)
    for rate in (SPIN_RATE, -SPIN_RATE) * PAIRS:
        course.spin(rate, SPIN).rest(course.interval)
    return course


def record(bench: Bench) -> list[Test]:
    """Tests at the beginning of each month."""
    course = make_programme(bench)
    ages = [age_device(bench.device, month * MONTH) for month in range(MONTHS)]
    return bench.run(
        [PowerOn(f"annual_{n:02d}", KIND, course, device=older) for n, older in enumerate(ages, 1)]
    )


def evaluate(campaign: Campaign) -> Outcome:
    """Standard deviation, range and drift of the monthly bias and scale factor.

    The campaign's tests are taken as a month apart, in their order.
    """
    tests = require_tests(campaign, KIND)
    if len(tests) < FEWEST_MONTHS:
        raise BenchError(
            f"{campaign.device}: {len(tests)} monthly tests; a year needs at least {FEWEST_MONTHS}"
        )
    fits = [fit_circumference(test, campaign.site).fitted for test in tests]
    noise = float(np.sqrt(np.mean([fit.deviation(MEAN) ** 2 for fit in fits])))
    means = np.array([fit.value(MEAN) for fit in fits])
    bias = Months(means, noise, sum(fit.freedom for fit in fits))
    scale = _measure_scale_factor(campaign, tests)
    months = np.array([bias.values / DEG_PER_H, scale.values / PPM]).T
    rows = tuple((str(month), f"{b:.5f}", f"{s:.4f}") for month, (b, s) in enumerate(months, 1))
    header = ("month", "mean bias, deg/h", "scale-factor error, ppm")
    return Outcome(
        findings=(
            *_make_findings("bias", bias, "deg/h"),
            *_make_findings("scale factor", scale, "ppm"),
        ),
        verdict=(
            f"Over {len(months)} months the bias varies by {np.std(months[:, 0], ddof=1):.2g} "
            f"deg/h and the scale factor by {np.std(months[:, 1], ddof=1):.2g} ppm (standard "
            "deviations)."
        ),
        tables=(Table("Months", header, rows),),
        warnings=(
            f"tests are taken as a month apart, in order: {tests[0].id} to {tests[-1].id}",
            "in the model only the decay time ages",
        ),
        draw=lambda figure: draw(figure, bias, scale),
    )


def _measure_scale_factor(campaign: Campaign, tests: Sequence[Test]) -> Months:
    """Monthly means over pairs of spins; the noise is from how the pairs of a month differ."""
    rate = campaign.site.vertical_rate
    pairs = [pair_spins(find_spins(test.log, rate), test.log.source) for test in tests]
    months = [list(map(compute_scale_factor_error, month)) for month in pairs]
    each, size = estimate_pooled_deviation("", months, "ppm").si_value, sum(map(len, months))
    noise = each * math.sqrt(len(months) / size)
    return Months(np.array([np.mean(month) for month in months]), noise, size - len(months))


def _make_findings(name: str, months: Months, unit: str) -> tuple[Finding, ...]:
    values, stability = months.values, f"{name} annual stability"
    note, whole = "standard deviation of the months", "of these, no interval"
    return (
        estimate_spread(stability, values, months.noise, months.freedom, unit, note),
        Finding(f"{name} annual range", float(np.ptp(values)), unit, n=len(values), note=whole),
        months.drift.finding("drift", f"{name} drift", f"{unit}/year", note=DRIFT_NOTE),
    )


def draw(figure: Figure, bias: Months, scale: Months) -> None:
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


PROCEDURE: Procedure = Procedure(
    name="annual",
    group="bias",
    title="Bias and scale factor over a year",
    source="paper Table 1; monthly power-ons, standard deviation and range",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
