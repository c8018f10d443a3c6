"""Start-up: time from power-on to a valid output, and to an output within specification.

The output is within specification from the time at which its rate stays within 0.02 deg/h. The rate
is the mean over the last 10 s less Earth's rate and less the mean over the second half of the log,
which a constant bias is part of. The time is the end of the average, so that it is at least 10 s.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.pages.markup import Table
from pyhrg.common.site import Site
from pyhrg.common.units import DEG_PER_H
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "start_up"
AVERAGE = 10.0
"""Duration over which the rate is averaged, s."""
SPECIFICATION = 0.02 * DEG_PER_H
"""Largest error of the averaged rate within specification, rad/s."""
DURATION = 120.0
"""Length of a power-on, s."""
AMPLITUDE_TOLERANCE = 0.2
"""Largest relative deviation of the amplitude from its set point at which an output is valid, as in
the electronics; used where the log has no column `valid`."""
START = {"startAmplitude": 0.01, "controller.startUp.firstAmplitude": 0.1}
"""Parameters of the FMU that the device doesn't state: amplitude after the start burst, and
amplitude of the first of the paper's two stages (2.3)."""


@dataclass(frozen=True)
class StartUp:
    """Start-up of one power-on.

    Attributes:
        valid, within: time to valid output and to output within specification, s; NaN where it is
            not in the first half of the log.
        interval: length of the log's rows, s; the true times are up to this much earlier.
        time: (n,) end of the average, s.
        error: (n,) averaged rate less that over the second half of the log, rad/s.
        noise: standard deviation of the averaged rate in the second half of the log, rad/s.
    """

    valid: float
    within: float
    interval: float
    time: Array
    error: Array
    noise: float


def record(bench: Bench, runs: int = RUNS, duration: float = DURATION) -> list[Test]:
    """Tests of power-ons at rest, input axis east, that start at a small amplitude."""
    device = replace(bench.device, model={**START, **bench.device.model})
    course = bench.programme(bench.step).attitude(0.0).rest(duration)
    tasks = [PowerOn(f"start_up_{n + 1}", KIND, course) for n in range(runs)]
    return replace(bench, device=device).run(tasks)


def measure_start_up(log: Log, site: Site) -> StartUp:
    log.require("gyro_angle", "amplitude", "amplitude_setpoint", "axis_up")
    rows = round(AVERAGE / log.interval)
    n = len(log.time)
    if n < 4 * rows:
        raise BenchError(
            f"{log.source}: {n * log.interval:g} s; the start-up takes {4 * AVERAGE:g} s or more"
        )
    if log.time[0] > 2 * log.interval or len(log.stretches("gyro_angle", "amplitude")) > 1:
        raise BenchError(
            f"{log.source}: rows are missing; the start-up takes them from power-on on"
        )
    earth = site.vertical_rate * float(np.mean(log.axis_up))
    rate = (log.gyro_angle[rows:] - log.gyro_angle[:-rows]) / AVERAGE - earth
    half = n // 2
    span = log.time[-1] - log.time[half]
    settled = (log.gyro_angle[-1] - log.gyro_angle[half]) / span - earth
    error, time = rate - settled, log.time[rows:]
    late = error[half:]
    return StartUp(
        valid=_find_last_start(log.time, _is_valid(log), log.time[half]),
        within=_find_last_start(time, np.abs(error) <= SPECIFICATION, log.time[half]),
        interval=log.interval,
        time=time,
        error=error,
        noise=float(np.std(late)),
    )


def _is_valid(log: Log) -> Mask:
    if not np.isnan(log.valid).any():
        return np.asarray(log.valid > 1 - 1e-9)
    off = np.abs(log.amplitude - log.amplitude_setpoint)
    return np.asarray(off <= AMPLITUDE_TOLERANCE * log.amplitude_setpoint)


def _find_last_start(time: Array, good: Mask, latest: float) -> float:
    """Time, s, from which on `good` is true to the end; NaN if later than `latest`."""
    bad = np.flatnonzero(~good)
    first = bad[-1] + 1 if len(bad) else 0
    return float(time[first]) if first < len(time) and time[first] <= latest else np.nan


def evaluate(campaign: Campaign) -> Outcome:
    """Median and largest value of both times over the power-ons."""
    tests = require_tests(campaign, KIND)
    runs = [measure_start_up(test.log, campaign.site) for test in tests]
    findings = (
        *summarize_times("time to valid output", [run.valid for run in runs], runs[0].interval),
        *summarize_times("time to specification", [run.within for run in runs], runs[0].interval),
    )
    rows = [(str(i), f"{run.valid:.4g}", f"{run.within:.4g}") for i, run in enumerate(runs, 1)]
    return Outcome(
        findings=findings,
        verdict=(
            f"Valid after {findings[0].si_value:.3g} s, within {SPECIFICATION / DEG_PER_H:g} deg/h "
            f"({AVERAGE:g} s averages) after {findings[2].si_value:.3g} s, medians of {len(runs)} "
            "power-ons."
        ),
        tables=(Table("Power-ons", ("run", "valid, s", "to specification, s"), tuple(rows)),),
        warnings=_list_warnings(tests, runs),
        draw=lambda figure: draw(figure, runs),
    )


def summarize_times(
    name: str, samples: Sequence[float], interval: float
) -> tuple[Finding, Finding]:
    """Median and largest of times, s.

    Times are whole rows and may be skewed, so that Student's interval doesn't apply. The median of
    the population lies between the smallest and the largest of n times with the probability 1 -
    2^(1-n) for any distribution (sign test). The smallest is taken one row earlier. A time is NaN
    where the event is not in the record; `interval` is that of a row, s.
    """
    n, name_largest = len(samples), f"greatest {name}"
    smallest, middle, largest = (float(f(samples)) for f in (np.min, np.median, np.max))
    if np.isnan(samples).any():
        missing = f"{np.isnan(samples).sum()} of {n} not in the first half of the log"
        values = ((name, np.nan), (name_largest, largest))
        first, second = (Finding(label, x, "s", n=n, note=missing) for label, x in values)
        return first, second
    note = f"no interval: another power-on exceeds it with probability 1/{n + 1}"
    greatest = Finding(name_largest, largest, "s", n=n, note=note)
    coverage = 1 - 2.0 ** (1 - n)
    if coverage < 0.95:
        note = f"median; {n} of at least 6 power-ons: no interval"
        return Finding(name, middle, "s", n=n, note=note), greatest
    note = f"median; interval from smallest to largest of {n}, confidence {coverage:.1%}"
    return Finding(name, middle, "s", smallest - interval, largest, n, note), greatest


def _list_warnings(tests: Sequence[Test], runs: Sequence[StartUp]) -> tuple[str, ...]:
    sentences = []
    if any(np.isnan(test.log.valid).any() for test in tests):
        sentences.append("valid is missing: taken from the amplitude, within 20 % of its set point")
    noise = max(run.noise for run in runs)
    if 4 * noise > SPECIFICATION:
        sentences.append(
            f"the averages scatter by {noise / DEG_PER_H:.2g} deg/h: noise decides the time to "
            "specification"
        )
    return tuple(sentences)


def draw(figure: Figure, runs: Sequence[StartUp]) -> None:
    axes = figure.add_subplot(title="Start-up")
    for number, run in enumerate(runs):
        label = f"{len(runs)} power-ons" if number == 0 else None
        shown = np.maximum(np.abs(run.error) / DEG_PER_H, 1e-5)
        axes.semilogy(run.time, shown, lw=0.8, color="#0072B2", alpha=0.6, label=label)
    axes.axhline(SPECIFICATION / DEG_PER_H, color="k", ls="--", lw=1, label="specification")
    valid, within = (
        np.median([getattr(run, name) for run in runs]) for name in ("valid", "within")
    )
    axes.axvline(float(valid), color="#009E73", lw=1.5, label="median time to valid output")
    axes.axvline(float(within), color="#D55E00", lw=1.5, label="median time to specification")
    finish_axes(
        axes,
        "time since power-on, end of the average, s",
        f"|error of the {AVERAGE:g} s mean rate|, deg/h",
        grid="both",
        xlim=(0, 2.5 * within if np.isfinite(within) else None),
    )


PROCEDURE: Procedure = Procedure(
    name="start-up",
    group="dynamic",
    title="Start-up time, to valid output and to specification",
    source="paper 2.3, 3.2; IEEE Std 1431-2004, 5.3.6",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
