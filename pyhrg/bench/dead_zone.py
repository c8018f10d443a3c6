"""Dead zone: damping anisotropy locks a free pattern while the input rate is small.

The pattern obeys Adler's equation: below W_L, the amplitude of the bias map, it comes to rest where
its bias balances the input, within 1/D, hours; above, it turns at sqrt(W^2 - W_L^2) on average. The
map, measured with the table turning, gives W_L without waiting for that. Eq. (5) takes the map out
of the output, and the input is seen although the pattern rests; Eq. (7) cancels the damping by
force, and the pattern turns again. A virtual rotation V moves the dead zone to V -+ W_L.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.dead_zone_figure import draw
from pyhrg.bench.harmonics import MEAN, Fit
from pyhrg.bench.lock import Run, run_of
from pyhrg.bench.magnitude import magnitude_finding
from pyhrg.bench.outcome import BenchError, Finding, Outcome, Table, mean_finding
from pyhrg.bench.procedure import Procedure, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.turning import FOURTH, fitted_turning, turning
from pyhrg.campaign import Campaign, Test
from pyhrg.theory import adler_lock_angle, adler_mean_rate
from pyhrg.units import DEG, DEG_PER_H, HOUR

MAP, PLAIN = "dead_zone_map", "dead_zone"
COMPENSATED, CANCELLED = "dead_zone_compensated", "dead_zone_cancelled"
MAP_RATE = 0.1 * DEG
MAP_INTERVAL = 10.0
NET_RATES = (-2.0, -1.5, -1.1, -0.9, -0.5, 0.0, 0.5, 0.9, 1.1, 1.5, 2.0)
"""Over W_L."""
FEWER = (-1.5, -1.2, -0.7, -0.3, 0.3, 0.7, 1.2, 1.5)
ROTATION = 10.0
"""Virtual rotation over W_L."""
CAPTURES = 30.0
"""Length of a run over the capture time 1/(4 k W_L)."""
ROWS = 1000
LONGEST = 48 * HOUR


def spin(
    bench: Bench, interval: float, rate: float, duration: float, turn: float = 0.0
) -> Programme:
    """One power-on, input axis east: a constant rate under a virtual rotation."""
    course = bench.programme(interval).attitude(0.0).command(virtual_rotation=turn)
    return course.spin(rate, math.ceil(duration / interval) * interval)


def map_runs(bench: Bench) -> list[PowerOn]:
    """A turn of the pattern either way."""
    duration = 2 * math.pi / (bench.device.bryan_factor * MAP_RATE)
    return [
        PowerOn(f"{MAP}_{name}", MAP, spin(bench, MAP_INTERVAL, rate, duration))
        for name, rate in (("positive", MAP_RATE), ("negative", -MAP_RATE))
    ]


def record(bench: Bench, longest: float = LONGEST) -> list[Test]:
    """The map; then, where the pattern is captured in reasonable time, free runs at rates around
    W_L: plain, under virtual rotation, with Eq. (5) and with Eq. (7), both of the measured map."""
    tests = bench.run(map_runs(bench))
    fitted, _ = fitted_turning([test.log for test in tests], bench.site.latitude)
    lock = math.hypot(*map(fitted.value, FOURTH))
    duration = CAPTURES / (4 * bench.device.bryan_factor * lock) if lock > 0 else math.inf
    if duration > longest:
        return tests
    interval = max(1, math.ceil(duration / ROWS / bench.step)) * bench.step
    calibrations = {
        (PLAIN, 0.0, NET_RATES): {},
        (PLAIN, ROTATION, FEWER): {},
        (COMPENSATED, 0.0, FEWER): bias_map(fitted),
        (CANCELLED, 0.0, FEWER): cancellation(fitted, bench.device.bryan_factor),
    }
    for (kind, turn, rates), model in calibrations.items():
        device = replace(bench.device, model={**bench.device.model, **model})
        courses = {
            r: spin(bench, interval, (r + turn) * lock, duration, turn * lock) for r in rates
        }
        tests += replace(bench, device=device).run(
            [PowerOn(f"{kind}_{turn:g}_{rate:g}", kind, c) for rate, c in courses.items()]
        )
    return tests


def bias_map(fitted: Fit) -> dict[str, float]:
    """Parameters of the FMU's compensation of the output (paper, Eq. 5)."""
    return {f"controller.biasMap.{name}": fitted.value(name) for name in (MEAN, *FOURTH)}


def cancellation(fitted: Fit, bryan_factor: float) -> dict[str, float]:
    """Parameters of the FMU's cancellation by force (paper, Eq. 7, factors mended); the mean bias
    is no damping's and is taken out of the output."""
    cosine, sine = map(fitted.value, FOURTH)
    return {
        "controller.cancellation.dampingAnisotropy": 4 * bryan_factor * math.hypot(cosine, sine),
        "controller.cancellation.dampingAxis": math.atan2(cosine, -sine) / 4,
        "controller.biasMap.mean": fitted.value(MEAN),
    }


def runs(campaign: Campaign, kind: str) -> tuple[list[Run], list[str]]:
    """Free runs of a kind, and a sentence on each that is left out."""
    found, excluded = [], []
    for test in campaign.tests:
        if test.kind == kind:
            try:
                latitude, factor = campaign.site.latitude, campaign.nominal["coriolis_factor"]
                found.append(run_of(test.log, latitude, factor))
            except BenchError as error:
                excluded.append(str(error))
    return found, excluded


def evaluate(campaign: Campaign) -> Outcome:
    """W_L of the map; and of free runs what locks, where, and what compensation leaves."""
    maps = [test.log for test in tests_of(campaign, MAP, "rate") if turning(test.log)]
    if not maps:
        raise BenchError(f"{campaign.device}: no log turns the pattern by 90 deg below 10 deg/s")
    fitted, refused = fitted_turning(maps, campaign.site.latitude)
    lock = magnitude_finding("lock rate", fitted, FOURTH, "deg/h")
    plain, excluded = runs(campaign, PLAIN)
    compensated, more = runs(campaign, COMPENSATED)
    cancelled, most = runs(campaign, CANCELLED)
    everything = [*plain, *compensated, *cancelled]
    capture = 1 / (4 * campaign.nominal["coriolis_factor"] * lock.value)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(
            lock,
            *adler_findings(plain, fitted, lock.value),
            *remedy_findings(compensated, cancelled),
        ),
        verdict=_verdict(plain, lock, capture),
        tables=(_table(everything, fitted, lock.value),) if everything else (),
        warnings=tuple(refused),
        exclusions=(*excluded, *more, *most, *(x for log in maps for x in log.exclusions)),
        draw=lambda figure: draw(figure, plain, cancelled, fitted, lock.value),
        values={"capture_time": capture},
    )


def _verdict(plain: Sequence[Run], lock: Finding, capture: float) -> str:
    text = (
        f"The pattern locks in below {lock.shown:.4g} deg/h, captured within {capture / HOUR:.3g} h"
    )
    caught = [run for run in plain if run.locked]
    if not caught:
        return f"{text}; no run was long enough to show it."
    return f"{text}; {len(caught)} of {len(plain)} free runs are locked."


def adler_findings(plain: Sequence[Run], fitted: Fit, lock: float) -> tuple[Finding, ...]:
    """Free runs against Adler's closed form with the map's terms."""
    mean = fitted.value(MEAN)
    free = [run for run in plain if not run.locked and run.rotation == 0.0]
    held = [run for run in plain if run.locked and run.rotation == 0.0]
    moved = [run for run in plain if not run.locked and run.rotation != 0.0]
    return (
        _mean(
            "lock rate from mean rates",
            [math.sqrt(max(0.0, (r.net + mean) ** 2 - r.pattern_rate**2)) for r in free],
            "deg/h",
        ),
        _mean("lock angle error", [_lock_angle_error(r, fitted, lock) for r in held], "deg"),
        _mean(
            "dead zone shift error",
            [r.net + mean - math.copysign(math.hypot(r.pattern_rate, lock), r.net) for r in moved],
            "deg/h",
        ),
    )


def _lock_angle_error(run: Run, fitted: Fit, lock: float) -> float:
    """Angle at which the pattern rests less Adler's, within +-45 deg, rad."""
    axis = math.atan2(fitted.value(FOURTH[0]), -fitted.value(FOURTH[1])) / 4
    share = min(1.0, max(-1.0, (run.net + fitted.value(MEAN)) / lock))
    error = run.angle - adler_lock_angle(share, 1.0, axis)
    return math.remainder(error, math.pi / 2)


def remedy_findings(compensated: Sequence[Run], cancelled: Sequence[Run]) -> tuple[Finding, ...]:
    """What Eqs. (5) and (7) leave of the dead zone: output less input."""
    held = [run.output - run.rate for run in compensated if run.locked]
    turned = [run.output - run.rate for run in cancelled if not run.locked]
    return (
        _mean("rate error by compensation while locked", held, "deg/h"),
        _mean("rate error under cancellation", turned, "deg/h"),
    )


def _mean(name: str, samples: Sequence[float], unit: str) -> Finding:
    if not samples:
        return Finding(name, np.nan, unit, note="no such run in the records")
    return mean_finding(name, samples, unit)


def _table(everything: Sequence[Run], fitted: Fit, lock: float) -> Table:
    header = ("run", "W - V, deg/h", "V, deg/h", "pattern, deg/h", "Adler, deg/h", "output, deg/h")
    mean = fitted.value(MEAN)
    rows = []
    for run in everything:
        adler = float(adler_mean_rate(run.net + mean, lock))
        values = (run.net, run.rotation, run.pattern_rate, adler, run.output)
        rows.append((run.name, *(f"{value / DEG_PER_H:.5g}" for value in values)))
    return Table("Free runs", header, tuple(rows))


PROCEDURE = Procedure(
    name="dead-zone",
    group="dead zone",
    title="Dead zone, its compensation and its cancellation",
    rows=("threshold",),
    source="paper 2.4, Eqs. 4 to 7; Adler 1946",
    kinds=(MAP, PLAIN, COMPENSATED, CANCELLED, "rate"),
    record=record,
    evaluate=evaluate,
)
