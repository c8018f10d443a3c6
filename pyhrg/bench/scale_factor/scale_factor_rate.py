"""Method B (paper 4.2): fast turning, the error of the rate.

The table turns at 100 deg/s both ways; the rate error over short averages, against the encoder, is
the scale factor at the pattern's position. Averaging over T shrinks a harmonic h of the pattern by
sinc(h k W T / 2): at 100 deg/s 0.3 s cost the fourth 1.4 %, 1 s 15 %. The paper's figure is given
as read and corrected; the fit of the angle (`scale_factor`) smooths nothing.
"""

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy import stats

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.output_rows import bryan_factor
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor.both_ways import draw_both_ways
from pyhrg.bench.scale_factor.rate_tests import KIND, RUNS, exclusions, rate_turns, record_turns
from pyhrg.bench.scale_factor.scale_factor import ScaleFactorMap, fitted, period_table
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]

RATE = 100 * DEG
PERIODS = 12
SMOOTHING = 0.3
"""Longest average, s."""


def record(
    bench: Bench, runs: int = RUNS, periods: int = PERIODS, rate: float = RATE
) -> list[Test]:
    """Seven power-ons each way."""
    return record_turns(bench, rate, periods, runs)


def rate_error(turn: Turn) -> tuple[Array, Array]:
    """Pattern angle, rad, and relative rate error (m,) of averages, over whole periods.

    Raises:
        BenchError: the rows are longer than the average may be.
    """
    rows = round(SMOOTHING / turn.interval)
    if rows < 1:
        raise BenchError(
            f"{turn.source}: rows of {turn.interval:g} s; method B averages at most {SMOOTHING:g} s"
        )
    gone = np.abs(turn.pattern_angle - turn.pattern_angle[0])
    last = int(np.searchsorted(gone, np.floor(turn.periods + 1e-6) * np.pi / 2 + 1e-9))
    excess, angle = turn.excess[:last], turn.input_angle[:last]
    error = (excess[rows:] - excess[:-rows]) / (angle[rows:] - angle[:-rows])
    pattern = (turn.pattern_angle[rows:last] + turn.pattern_angle[: last - rows]) / 2
    return pattern, np.asarray(error)


def smoothing_loss(turn: Turn, k: float) -> float:
    """Share that remains of the fourth harmonic."""
    duration = round(SMOOTHING / turn.interval) * turn.interval
    return float(np.sinc(4 * k * turn.input_rate * duration / (2 * np.pi)))


def stability(found: ScaleFactorMap) -> Finding:
    """Standard deviation of a turn's scale factor between periods, pooled over the turns.

    Of every second period, so that no two share the angle noise of a bound.
    """
    name, groups = "scale factor stability in run", []
    for turn in found.turns:
        _, angle, excess = turn.whole_periods(each=1)
        groups.append((np.diff(excess) / np.diff(angle))[::2])
    freedom = sum(len(group) - 1 for group in groups)
    if freedom < 1:
        return Finding(name, np.nan, "ppm", note="needs 3 periods of the pattern in one turn")
    square = sum(float(np.sum((group - group.mean()) ** 2)) for group in groups)
    low, high = np.sqrt(square / stats.chi2.ppf([0.975, 0.025], freedom))
    note = "standard deviation of whole periods of the pattern"
    value = float(np.sqrt(square / freedom))
    return Finding(name, value, "ppm", float(low), float(high), freedom + 1, note)


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, its map over the circumference, its stability within a run."""
    k = bryan_factor(campaign)
    found = fitted(rate_turns(campaign, slow=False), k)
    errors = [rate_error(turn) for turn in found.turns]
    losses = [smoothing_loss(turn, k) for turn in found.turns]
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*found.findings(), *_smoothed(errors, losses), stability(found)),
        verdict=(
            f"{found.verdict()}; averages of at most {SMOOTHING:g} s keep {min(losses):.1%} of "
            "the fourth harmonic."
        ),
        tables=(period_table(found.turns),),
        warnings=(*found.refused, _lag(found, k)),
        exclusions=exclusions(campaign, KIND),
        draw=lambda figure: draw(figure, found, errors),
        values={"scale_factor_map": dict(zip(found.fit.names, found.fit.values, strict=True))},
    )


def _lag(found: ScaleFactorMap, k: float) -> str:
    rate = max(abs(turn.table_rate) for turn in found.turns)
    return (
        f"at {rate / DEG:.3g} deg/s the fourth harmonic passes at {4 * k * rate:.2g} rad/s: what "
        "loops that lag behind it add to bias, pick-off errors and the eighth harmonic can't be "
        "told from these; method A shows them slow"
    )


def _smoothed(errors: list[tuple[Array, Array]], losses: list[float]) -> tuple[Finding, ...]:
    """The paper's own figure, as it is, and with the loss made good."""
    rows = np.concatenate([error - error.mean() for _, error in errors])
    deviation, n = float(np.std(rows, ddof=1)), len(rows)
    kept = float(np.mean(losses))
    note = "standard deviation with the noise and the bias over the rate: no interval"
    made_good = f"over {kept:.4f}, what the averages keep of the fourth harmonic; no interval"
    return (
        Finding("smoothed rate residual", deviation, "ppm", n=n, note=note),
        Finding("corrected rate residual", deviation / kept, "ppm", n=n, note=made_good),
    )


def draw(figure: Figure, found: ScaleFactorMap, errors: list[tuple[Array, Array]]) -> None:
    """Averages of both ways and the fitted map against the pattern angle."""
    axes = figure.add_subplot()
    grid = np.linspace(0.0, np.pi, 361)
    points = [(pattern, error * 1e6) for pattern, error in errors]
    draw_both_ways(axes, found.turns, points)
    mean = found.fit.value("scale factor")
    axes.plot(grid / DEG, (mean + found.at(grid)) * 1e6, "k-", lw=1.2, label="fit to the angle")
    axes.set_ylabel("rate error over rate, ppm")
    axes.set_title(f"Scale factor over the circumference, averages of {SMOOTHING:g} s")
    axes.legend(markerscale=3)


PROCEDURE = Procedure(
    name="scale-factor-rate",
    group="scale factor",
    title="Scale factor over the circumference, method B (100 deg/s, rate)",
    rows=("scale factor stability, room temperature",),
    source="paper 4.2, second method, and Eqs. 2 and 3; both directions: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
