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
from itertools import chain

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.dead_zone import free_runs
from pyhrg.bench.dead_zone.lock import FOURTH, Run, fit_turning, is_turning, read_run
from pyhrg.bench.estimation.harmonics import MEAN, Fit
from pyhrg.bench.estimation.sizes import estimate_amplitude
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests, select_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.output_rows import read_bryan_factor
from pyhrg.common.units import DEG, DEG_PER_H, HOUR
from pyhrg.device.device import AngleMap, Device
from pyhrg.records.campaign import Campaign, Test

MAP, PLAIN = "dead_zone_map", "dead_zone"
COMPENSATED, CANCELLED = "dead_zone_compensated", "dead_zone_cancelled"
MAP_RATE = 0.1 * DEG
MAP_INTERVAL = 5.0
NET_RATES = (-2.0, -1.5, -1.1, -0.9, -0.5, 0.0, 0.5, 0.9, 1.1, 1.5, 2.0)
"""Input rate less virtual rotation, over W_L."""
FEWER = (-1.5, -1.2, -0.7, -0.3, 0.3, 0.7, 1.2, 1.5)
ROTATION = 10.0
"""Virtual rotation over W_L."""
CAPTURES = 30.0
"""Length of a run over the capture time 1/(4 k W_L)."""
ROWS = 1000
LONGEST = 48 * HOUR


def make_spin(
    bench: Bench, interval: float, rate: float, duration: float, turn: float = 0.0
) -> Programme:
    """One power-on, input axis east: a constant rate under a virtual rotation."""
    course = bench.programme(interval).attitude(0.0).command(virtual_rotation=turn)
    return course.spin(rate, math.ceil(duration / interval) * interval)


def plan_map_runs(bench: Bench, rate: float = MAP_RATE) -> list[PowerOn]:
    """A turn of the pattern either way."""
    duration = 2 * math.pi / (bench.device.bryan_factor * rate)
    return [
        PowerOn(f"{MAP}_{name}", MAP, make_spin(bench, MAP_INTERVAL, signed, duration))
        for name, signed in (("positive", rate), ("negative", -rate))
    ]


def record(bench: Bench, longest: float = LONGEST) -> list[Test]:
    """The map; then, where the pattern is captured in reasonable time, free runs at rates around
    W_L: plain, under virtual rotation, with Eq. (5) and with Eq. (7), both of the measured map."""
    bench = replace(bench, device=replace(bench.device, bias_map=AngleMap()))
    tests = bench.run(plan_map_runs(bench))
    fitted, _ = fit_turning([test.log for test in tests], bench.device.site)
    lock = math.hypot(*map(fitted.value, FOURTH))
    duration = CAPTURES / (4 * bench.device.bryan_factor * lock) if lock > 0 else math.inf
    if duration > longest:
        return tests
    interval = max(1, math.ceil(duration / ROWS / bench.step)) * bench.step
    series = (
        (PLAIN, 0.0, NET_RATES, bench.device),
        (PLAIN, ROTATION, FEWER, bench.device),
        (COMPENSATED, 0.0, FEWER, compensate(bench.device, fitted)),
        (CANCELLED, 0.0, FEWER, cancel(bench.device, fitted)),
    )
    for kind, turn, rates, device in series:
        power_ons = []
        for rate in rates:
            course = make_spin(bench, interval, (rate + turn) * lock, duration, turn * lock)
            power_ons.append(PowerOn(f"{kind}_{turn:g}_{rate:g}", kind, course))
        tests += replace(bench, device=device).run(power_ons)
    return tests


def compensate(device: Device, fitted: Fit) -> Device:
    """A gyro with the map taken out of the output (paper, Eq. 5)."""
    cosine, sine = map(fitted.value, FOURTH)
    return replace(device, bias_map=AngleMap(mean=fitted.value(MEAN), cos4=cosine, sin4=sine))


def cancel(device: Device, fitted: Fit) -> Device:
    """A gyro with the map's fourth harmonic cancelled by force (paper, Eq. 7, factors
    corrected); the mean is taken out of the output."""
    cosine, sine = map(fitted.value, FOURTH)
    anisotropy = 4 * device.bryan_factor * math.hypot(cosine, sine)
    model = {
        "controller.cancellation.dampingAnisotropy": anisotropy,
        "controller.cancellation.dampingAxis": math.atan2(cosine, -sine) / 4,
    }
    mean = AngleMap(mean=fitted.value(MEAN))
    return replace(device, bias_map=mean, model={**device.model, **model})


def read_runs(campaign: Campaign, kind: str) -> tuple[list[Run], list[str]]:
    """Free runs of a kind, and a sentence on each that is left out."""
    runs, excluded = [], []
    for test in select_tests(campaign, kind):
        try:
            runs.append(read_run(test.log, campaign.site, read_bryan_factor(campaign)))
        except BenchError as error:
            excluded.append(str(error))
    return runs, excluded


def evaluate(campaign: Campaign) -> Outcome:
    """W_L of the map; and of free runs what locks, where, and what compensation leaves."""
    tests = [test for test in require_tests(campaign, MAP, "rate") if is_turning(test.log)]
    maps = [test.log for test in tests]
    if not maps:
        raise BenchError(f"{campaign.device}: no log turns the pattern by 90 deg below 10 deg/s")
    fitted, refused = fit_turning(maps, campaign.site)
    lock = estimate_amplitude("lock rate", fitted, FOURTH, "deg/h")
    groups = [read_runs(campaign, kind) for kind in (PLAIN, COMPENSATED, CANCELLED)]
    (plain, by_output, by_force), excluded = zip(*groups, strict=True)
    everything = [*plain, *by_output, *by_force]
    capture = (
        1 / (4 * read_bryan_factor(campaign) * lock.si_value) if lock.si_value > 0 else math.inf
    )
    return Outcome(
        findings=(
            lock,
            *free_runs.compare_with_adler(plain, fitted, lock.si_value),
            *free_runs.find_residual_dead_zone(by_output, by_force),
        ),
        verdict=_verdict(plain, lock, capture),
        tables=(free_runs.tabulate_runs(everything, fitted, lock.si_value),) if everything else (),
        warnings=tuple(refused),
        exclusions=tuple(chain(*excluded)),
        draw=lambda figure: free_runs.draw(figure, plain, by_force, fitted, lock.si_value),
        values={"capture_time": capture},
    )


def _verdict(plain: Sequence[Run], lock: Finding, capture: float) -> str:
    if not lock.si_low > 0:
        most = lock.si_high / DEG_PER_H
        return f"No dead zone is seen: the map's fourth harmonic is at most {most:.2g} deg/h."
    below, within = f"{lock.value:.4g} deg/h", f"{capture / HOUR:.3g} h"
    shown = f"{sum(run.locked for run in plain)} of {len(plain)} free runs are locked"
    if not any(run.locked for run in plain):
        shown = f"no free run shows it: each takes {CAPTURES:g} times that, and is simulated "
        shown += f"up to {LONGEST / HOUR:g} h"
    return f"The pattern locks in below {below}, captured within {within}; {shown}."


PROCEDURE: Procedure = Procedure(
    name="dead-zone",
    group="dead zone",
    title="Dead zone, its compensation and its cancellation",
    source="paper 2.4, Eqs. 4 to 7; Adler 1946",
    kinds=(MAP, PLAIN, COMPENSATED, CANCELLED, "rate"),
    record=record,
    evaluate=evaluate,
    model="HRGSlow",
    step=0.1,
)
