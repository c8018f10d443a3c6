"""Method A (paper 4.2): slow turning, the error of the angle.

The table turns at 5 deg/s both ways by whole periods of the pattern; the detected angle is fitted
against the encoder. What is left, r, is the angle-measuring error; a fourth harmonic of r is one of
the scale factor four times as large: 4 std(r).
"""

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.output_rows import bryan_factor
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor.both_ways import draw_both_ways
from pyhrg.bench.scale_factor.rate_tests import KIND, RUNS, exclusions, rate_turns, record_turns
from pyhrg.bench.scale_factor.scale_factor import BIAS, ScaleFactorMap, fitted, period_table
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]

RATE = 5 * DEG
PERIODS = 2


def record(
    bench: Bench, runs: int = RUNS, periods: int = PERIODS, rate: float = RATE
) -> list[Test]:
    """Seven power-ons each way."""
    return record_turns(bench, rate, periods, runs)


def residual(turn: Turn, k: float) -> Array:
    """(n,) error of the pattern angle, rad: less a line against the encoder, at whole periods.

    Args:
        turn: of the table at one rate.
        k: Bryan factor.
    """
    rows = np.abs(turn.pattern_angle - turn.pattern_angle[0]) <= _whole(turn)
    excess, table = turn.excess[rows], turn.table_angle[rows]
    # both ways, the line that joins whole periods has the slope of the mean scale factor
    _, angle, error = turn.whole_periods()
    slope = (error[-1] - error[0]) / (angle[-1] - angle[0])
    left = excess - slope * (table - table[0])
    return np.asarray(-k * (left - left.mean()))


def _whole(turn: Turn) -> float:
    return float(np.floor(turn.periods + 1e-6)) * np.pi / 2


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, its map over the circumference, and the bias that only both ways separate."""
    k = bryan_factor(campaign)
    found = fitted(rate_turns(campaign, slow=True), k)
    left = [residual(turn, k) for turn in found.turns]
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*found.findings(), *_residuals(left)),
        verdict=_verdict(found),
        tables=(period_table(found.turns),),
        warnings=found.refused,
        exclusions=exclusions(campaign, KIND),
        draw=lambda figure: draw(figure, found, left),
        values={"scale_factor_map": dict(zip(found.fit.names, found.fit.values, strict=True))},
    )


def _residuals(left: list[Array]) -> tuple[Finding, ...]:
    """The paper's own figures, as they are."""
    rows = np.concatenate(left)
    deviation, largest = float(np.std(rows, ddof=1)), float(np.max(np.abs(rows)))
    note = "as read, with the noise and the bias over the rate: no interval"
    n = len(rows)
    return (
        Finding("angle residual", deviation, "arcsec", n=n, note=f"standard deviation, {note}"),
        Finding("largest angle residual", largest, "arcsec", n=n, note=note),
        Finding("four angle residuals", 4 * deviation, "ppm", n=n, note=f"4 std(r), {note}"),
        Finding("four largest angle residuals", 4 * largest, "ppm", n=n, note=f"4 max|r|, {note}"),
    )


def _verdict(found: ScaleFactorMap) -> str:
    rate = float(np.mean([abs(turn.table_rate) for turn in found.turns]))
    harmonics = [found.fit.value(name) for name in found.harmonics(BIAS)]
    share = float(np.linalg.norm(harmonics)) / np.sqrt(2) / rate
    return (
        f"{found.verdict()}; one way alone the bias would have added {share * 1e6:.3g} ppm at "
        f"{rate / DEG:.3g} deg/s."
    )


def draw(figure: Figure, found: ScaleFactorMap, left: list[Array]) -> None:
    """Residuals of both ways against the pattern angle."""
    axes = figure.add_subplot()
    angles = [
        turn.pattern_angle[: len(values)] for turn, values in zip(found.turns, left, strict=True)
    ]
    points = [(angle, values / ARCSEC) for angle, values in zip(angles, left, strict=True)]
    draw_both_ways(axes, found.turns, points)
    axes.set_ylabel("error of the pattern angle, arcsec")
    axes.set_title("Angle residual; where both ways differ, the bias shows")
    axes.legend(markerscale=3)


PROCEDURE = Procedure(
    name="scale-factor-angle",
    group="scale factor",
    title="Scale factor over the circumference, method A (5 deg/s, angle)",
    rows=("scale factor stability, room temperature",),
    source="paper 4.2, first method, and Eqs. 2 and 3; both directions: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
