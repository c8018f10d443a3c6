"""Method A (paper 4.2): scale factor over the circumference from the angle error in slow turns.

The table turns at 5 deg/s in both directions, by whole periods of the pattern. The detected pattern
angle is fitted by a line against the encoder; the residual r is the error of the angle. A fourth
harmonic of r is one of the scale factor that is four times as large: 4 std(r).
"""

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.output_rows import read_bryan_factor
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor import scale_factor
from pyhrg.bench.scale_factor.scale_factor import (
    BIAS,
    KIND,
    RUNS,
    ScaleFactorMap,
    fit_scale_factor_map,
    make_period_table,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records.campaign import Campaign, Test

RATE = 5 * DEG
"""Table rate, rad/s."""
PERIODS = 2
"""Periods of the scale-factor map in a power-on."""


def record(
    bench: Bench, runs: int = RUNS, periods: int = PERIODS, rate: float = RATE
) -> list[Test]:
    """Tests of `runs` power-ons in each direction at a table rate, rad/s."""
    return bench.run(scale_factor.make_turn_power_ons(bench, rate, periods, runs))


def compute_residual(turn: Turn, k: float) -> Array:
    """(n,) error of the pattern angle, rad, within whole periods: residual of a line against the
    encoder."""
    whole = float(np.floor(turn.periods + 1e-6)) * np.pi / 2
    rows = np.abs(turn.pattern_angle - turn.pattern_angle[0]) <= whole
    excess, table = turn.excess[rows], turn.table_angle[rows]
    # over both directions, a line through whole periods has the slope of the mean scale factor
    _, angle, error = turn.whole_periods()
    slope = (error[-1] - error[0]) / (angle[-1] - angle[0])
    residual = excess - slope * (table - table[0])
    return np.asarray(-k * (residual - residual.mean()))


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, its map over the circumference, and the bias."""
    k = read_bryan_factor(campaign)
    fitted = fit_scale_factor_map(scale_factor.read_rate_turns(campaign, slow=True), k)
    residuals = [compute_residual(turn, k) for turn in fitted.turns]
    return Outcome(
        findings=(*fitted.findings(), *_summarize_residuals(residuals)),
        verdict=_describe_verdict(fitted),
        tables=(make_period_table(fitted.turns),),
        warnings=fitted.refused,
        exclusions=scale_factor.list_unused_turns(campaign, KIND),
        draw=lambda figure: draw(figure, fitted, residuals),
        values={"scale_factor_map": fitted.fit.terms},
    )


def _summarize_residuals(residuals: list[Array]) -> tuple[Finding, ...]:
    """The paper's own figures of the angle error, without correction for noise."""
    rows = np.concatenate(residuals)
    deviation, largest, n = float(np.std(rows, ddof=1)), float(np.max(np.abs(rows))), len(rows)
    note = "as read, with the noise and the bias over the rate: no interval"
    return (
        Finding("angle residual", deviation, "arcsec", n=n, note=f"standard deviation, {note}"),
        Finding("largest angle residual", largest, "arcsec", n=n, note=note),
        Finding("four angle residuals", 4 * deviation, "ppm", n=n, note=f"4 std(r), {note}"),
        Finding("four largest angle residuals", 4 * largest, "ppm", n=n, note=f"4 max|r|, {note}"),
    )


def _describe_verdict(fitted: ScaleFactorMap) -> str:
    rate = float(np.mean([abs(turn.table_rate) for turn in fitted.turns]))
    harmonics = [fitted.fit.value(name) for name in fitted.harmonics(BIAS)]
    share = float(np.linalg.norm(harmonics)) / np.sqrt(2) / rate
    return (
        f"{fitted.verdict()}; one way alone the bias would have added {share * 1e6:.3g} ppm at "
        f"{rate / DEG:.3g} deg/s."
    )


def draw(figure: Figure, fitted: ScaleFactorMap, residuals: list[Array]) -> None:
    axes = figure.add_subplot(title="Angle residual; where both ways differ, the bias shows")
    pairs = zip(fitted.turns, residuals, strict=True)
    points = [(turn.pattern_angle[: len(values)], values / ARCSEC) for turn, values in pairs]
    scale_factor.draw_both_ways(axes, fitted.turns, points)
    axes.set_ylabel("error of the pattern angle, arcsec")
    axes.legend(markerscale=3)


PROCEDURE: Procedure = Procedure(
    name="scale-factor-angle",
    group="scale factor",
    title="Scale factor over the circumference, method A (5 deg/s, angle)",
    source="paper 4.2, first method, and Eqs. 2 and 3; both directions: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
