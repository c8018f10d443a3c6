"""Method B (paper 4.2): scale factor over the circumference from the rate error in fast turns.

The table turns at 100 deg/s in both directions. The rate error of short averages, against the
encoder, is the scale-factor error at the pattern angle. An average over T reduces harmonic h of the
pattern angle by the factor sinc(h k W T / 2): at 100 deg/s an average over 0.3 s reduces the fourth
by 1.4 %, one over 1 s by 15 %. The paper's figure is given as it is and corrected for this; the fit
to the angle (`scale_factor`) needs no average.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_pooled_deviation
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.output_rows import read_bryan_factor
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor import scale_factor
from pyhrg.bench.scale_factor.scale_factor import (
    KIND,
    RUNS,
    ScaleFactorMap,
    fit_scale_factor_map,
    make_period_table,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

RATE = 100 * DEG
"""Table rate, rad/s."""
PERIODS = 12
"""Periods of the scale-factor map in a power-on."""
SMOOTHING = 0.3
"""Longest average, s."""


def record(
    bench: Bench, runs: int = RUNS, periods: int = PERIODS, rate: float = RATE
) -> list[Test]:
    """Tests of `runs` power-ons in each direction at a table rate, rad/s."""
    return bench.run(scale_factor.make_turn_power_ons(bench, rate, periods, runs))


def compute_rate_error(turn: Turn) -> tuple[Array, Array]:
    """Pattern angle, rad, and relative rate error of averages, (m,) each, over whole periods."""
    rows = round(SMOOTHING / turn.interval)
    if rows < 1:
        raise BenchError(
            f"{turn.source}: rows of {turn.interval:g} s; method B averages at most {SMOOTHING:g} s"
        )
    moved = np.abs(turn.pattern_angle - turn.pattern_angle[0])
    last = int(np.searchsorted(moved, np.floor(turn.periods + 1e-6) * np.pi / 2 + 1e-9))
    excess, angle = turn.excess[:last], turn.input_angle[:last]
    error = (excess[rows:] - excess[:-rows]) / (angle[rows:] - angle[:-rows])
    pattern = (turn.pattern_angle[rows:last] + turn.pattern_angle[: last - rows]) / 2
    return pattern, np.asarray(error)


def estimate_stability(turns: Sequence[Turn]) -> Finding:
    """Standard deviation of the scale factor over the periods of a turn, pooled over the turns.

    Every second period is used, so that no two share the angle noise of a common bound.
    """
    name, groups = "scale factor stability in run", []
    for turn in turns:
        _, angle, excess = turn.whole_periods(each=1)
        groups.append((np.diff(excess) / np.diff(angle))[::2])
    if max(map(len, groups)) < 2:
        return Finding(name, np.nan, "ppm", note="needs 3 periods of the pattern in one turn")
    note = "standard deviation of whole periods of the pattern"
    pooled = estimate_pooled_deviation(name, groups, "ppm", note)
    return replace(pooled, n=sum(len(group) - 1 for group in groups) + 1)


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, its map over the circumference, its stability in run, and the bias."""
    k = read_bryan_factor(campaign)
    fitted = fit_scale_factor_map(scale_factor.read_rate_turns(campaign, slow=False), k)
    errors = [compute_rate_error(turn) for turn in fitted.turns]
    durations = (round(SMOOTHING / turn.interval) * turn.interval for turn in fitted.turns)
    shares = [
        float(np.sinc(4 * k * turn.input_rate * duration / (2 * np.pi)))
        for turn, duration in zip(fitted.turns, durations, strict=True)
    ]
    return Outcome(
        findings=(
            *fitted.findings(),
            *_summarize_averages(errors, shares),
            estimate_stability(fitted.turns),
        ),
        verdict=(
            f"{fitted.verdict()}; averages of at most {SMOOTHING:g} s keep {min(shares):.1%} of "
            "the fourth harmonic."
        ),
        tables=(make_period_table(fitted.turns),),
        warnings=(*fitted.refused, _describe_lag(fitted, k)),
        exclusions=scale_factor.list_unused_turns(campaign, KIND),
        draw=lambda figure: draw(figure, fitted, errors),
        values={"scale_factor_map": fitted.fit.terms},
    )


def _describe_lag(fitted: ScaleFactorMap, k: float) -> str:
    rate = max(abs(turn.table_rate) for turn in fitted.turns)
    return (
        f"at {rate / DEG:.3g} deg/s the fourth harmonic has a frequency of {4 * k * rate:.2g} "
        "rad/s: loops lag behind it, which changes bias, pick-off errors and the eighth harmonic; "
        "in the slow turns of method A the lag is smaller"
    )


def _summarize_averages(
    errors: list[tuple[Array, Array]], shares: list[float]
) -> tuple[Finding, ...]:
    """The paper's own figure of the rate error, as it is, and corrected for the averages."""
    rows = np.concatenate([error - error.mean() for _, error in errors])
    deviation, n = float(np.std(rows, ddof=1)), len(rows)
    kept = float(np.mean(shares))
    note = "standard deviation with the noise and the bias over the rate: no interval"
    correction = f"over {kept:.4f}, what the averages keep of the fourth harmonic; no interval"
    return (
        Finding("smoothed rate residual", deviation, "ppm", n=n, note=note),
        Finding("corrected rate residual", deviation / kept, "ppm", n=n, note=correction),
    )


def draw(figure: Figure, fitted: ScaleFactorMap, errors: list[tuple[Array, Array]]) -> None:
    axes = figure.add_subplot(
        title=f"Scale factor over the circumference, averages of {SMOOTHING:g} s"
    )
    scale_factor.draw_both_ways(
        axes, fitted.turns, [(pattern, error * 1e6) for pattern, error in errors]
    )
    grid = np.linspace(0.0, np.pi, 361)
    curve = (fitted.fit.value("scale factor") + fitted.evaluate(grid)) * 1e6
    axes.plot(grid / DEG, curve, "k-", lw=1.2, label="fit to the angle")
    axes.set_ylabel("rate error over rate, ppm")
    axes.legend(markerscale=3)


PROCEDURE: Procedure = Procedure(
    name="scale-factor-rate",
    group="scale factor",
    title="Scale factor over the circumference, method B (100 deg/s, rate)",
    source="paper 4.2, second method, and Eqs. 2 and 3; both directions: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
