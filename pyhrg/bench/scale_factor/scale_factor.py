"""Tests at constant table rates in both directions (their programmes and their turns), and the fit
of the scale-factor map, which methods A and B share.

The output rate at an input rate W (Earth included) and a pattern angle th is

    W (1 + s + sum over h of c_h cos h th + s_h sin h th) + B + the same harmonics of the bias

(paper, Eq. 2, in the rate form: a gain mismatch g of the pick-offs is c_4 = -g, a non-orthogonality
d is s_4 = -d). Its integral is fitted to the output angle, so that no smoothing is needed and the
encoder, not the clock, is the reference. Turns in both directions separate the parts that are
proportional to the rate from the bias; in one direction at one rate they are confounded.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.angle_fit import AngleFit, Record, compute_largest_inflation, fit_angles
from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, TILT, name_terms
from pyhrg.bench.estimation.sizes import estimate_magnitude
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.procedure import require_tests
from pyhrg.bench.readings.turns import PERIOD, Turn, find_turns, list_short_turns
from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG, PPM
from pyhrg.records.campaign import Campaign

KIND = "rate"
RUNS = 7
"""Power-ons in each direction."""
FASTEST_RATE_A = 20 * DEG
"""Largest table rate for method A, rad/s; method B takes those above."""
WARM_UP = 10.0
"""Time at rest before the table turns, s."""
INTERVAL = 0.1
"""Length of a row, s."""


def read_rate_turns(campaign: Campaign, slow: bool) -> list[Turn]:
    """Turns of the campaign's rate tests at rates up to `FASTEST_RATE_A` (`slow`), or above."""
    tests, site = require_tests(campaign, KIND), campaign.site
    turns = [turn for test in tests for turn in find_turns(test.log, site)]
    chosen = [turn for turn in turns if (abs(turn.table_rate) <= FASTEST_RATE_A) == slow]
    if not chosen:
        rates = ", ".join(f"{turn.table_rate / DEG:.3g}" for turn in turns)
        side = "up to" if slow else "above"
        raise BenchError(
            f"{campaign.device}: no rate test {side} {FASTEST_RATE_A / DEG:g} deg/s; "
            f"there are {rates} deg/s"
        )
    return chosen


def list_unused_turns(campaign: Campaign, kind: str) -> tuple[str, ...]:
    """A sentence on each turn in the tests of a kind that is too short to be used."""
    tests, site = require_tests(campaign, kind), campaign.site
    return tuple(text for test in tests for text in list_short_turns(test.log, site))


def make_turn_power_ons(bench: Bench, rate: float, periods: int, runs: int = RUNS) -> list[PowerOn]:
    """Power-ons, `runs` in each direction, in which the table turns at a rate, rad/s, until the
    pattern has turned by a number of periods of the scale-factor map."""
    tasks = []
    for way, sign in (("pos", 1), ("neg", -1)):
        course = bench.programme(INTERVAL).rest(WARM_UP)
        duration = PERIOD * periods / (bench.device.bryan_factor * rate) + 3.0
        course.spin(sign * rate, np.ceil(duration / INTERVAL) * INTERVAL)
        name = f"rate_{rate / DEG:g}dps_{way}"
        tasks += [PowerOn(f"{name}_{run + 1}", KIND, course) for run in range(runs)]
    return tasks


def draw_both_ways(
    axes: Axes, turns: Sequence[Turn], points: Sequence[tuple[Array, Array]]
) -> None:
    """Draw the points of turns on axes, with one label for each direction.

    `points` has pattern angles (m,), rad, and values (m,) of each turn.
    """
    for positive, mark, colour in ((True, ".", "C0"), (False, "x", "C1")):
        chosen = [i for i, turn in enumerate(turns) if (turn.table_rate > 0) == positive]
        angle = np.concatenate([points[i][0] for i in chosen]) % np.pi / DEG
        values = np.concatenate([points[i][1] for i in chosen])
        rate = np.mean([turns[i].table_rate for i in chosen]) / DEG
        label = f"{rate:+.3g} deg/s"
        axes.plot(angle, values, mark, color=colour, ms=2.5, label=label, alpha=0.5)
    axes.set(xlabel="pattern angle, deg", xlim=(0, 180))
    axes.grid(alpha=0.3)


SCALE = "scale factor"
BIAS = "bias"
SECOND_ORDER = "of the nominal Bryan factor, with -g (g + gd)/4 of pick-offs and drives"
"""The amplitude force makes the true amplitude follow the gain, and is misaimed by g and gd."""
ORDERS = (4, 2, 8)
"""Harmonics of the map, the most important first."""


@dataclass(frozen=True)
class ScaleFactorMap:
    """Fit of the map to all turns of a test.

    Attributes:
        orders: harmonics that the turns can separate.
        refused: a sentence on each term that they can't.
    """

    turns: tuple[Turn, ...]
    orders: tuple[int, ...]
    fit: AngleFit
    refused: tuple[str, ...]

    def harmonics(self, kind: str = SCALE) -> tuple[str, ...]:
        """Names of the harmonics' terms, of the scale factor or of the bias (`kind`)."""
        return tuple(f"{kind} {name}" for order in self.orders for name in name_terms(order))

    def evaluate(self, pattern_angle: Array) -> Array:
        """Scale-factor error less its mean, at pattern angles, rad; of the shape of the angles."""
        phase = np.multiply.outer(pattern_angle, self.orders)
        waves = np.stack([np.cos(phase), np.sin(phase)], axis=-1).reshape(*phase.shape[:-1], -1)
        return np.asarray(waves @ np.array([self.fit.value(name) for name in self.harmonics()]))

    def findings(self) -> tuple[Finding, ...]:
        """Findings: scale factor, its variation, pick-off errors, other harmonics, bias."""
        names = [name for name in self.harmonics() if not name.endswith("4")]
        fastest = max(abs(turn.table_rate) for turn in self.turns) / DEG
        note = (
            f"part that is even in the rate, up to {fastest:.3g} deg/s: the bias map and errors of "
            "the loops in proportion to the square of the rate"
        )
        make = self.fit.finding
        return (
            make(SCALE, "scale factor error", "ppm", note=SECOND_ORDER),
            self.variation(),
            make(f"{SCALE} cos4", "pick-off gain mismatch", "ppm", -1.0),
            make(f"{SCALE} sin4", "pick-off non-orthogonality", "ppm", -1.0),
            *(make(name, name, "ppm") for name in names),
            make(BIAS, "bias", "deg/h"),
            *(make(name, name, "deg/h", note=note) for name in self.harmonics(BIAS)),
        )

    def variation(self) -> Finding:
        """Standard deviation of the scale factor over the circumference."""
        chosen = [self.fit.names.index(name) for name in self.harmonics()]
        covariance = self.fit.covariance[np.ix_(chosen, chosen)] / 2
        value, low, high = estimate_magnitude(self.fit.values[chosen] / np.sqrt(2), covariance)
        note = f"standard deviation, harmonics {', '.join(map(str, sorted(self.orders)))}"
        n = len(self.fit.residual)
        return Finding("scale factor variation", value, "ppm", low, high, n, note)

    def verdict(self) -> str:
        """Variation of the scale factor over the circumference in words, without a full stop."""
        variation = self.variation()
        low, high = variation.interval
        if not low > 0:
            return (
                "No variation of the scale factor is significant: its standard deviation is "
                f"{high:.2g} ppm at most"
            )
        largest = float(np.max(np.abs(self.evaluate(np.linspace(0.0, np.pi, 721))))) / PPM
        return (
            f"The scale factor varies by {variation.value:.3g} ppm over the circumference "
            f"(standard deviation; {largest:.3g} ppm at most)"
        )


def fit_scale_factor_map(turns: Sequence[Turn], bryan_factor: float) -> ScaleFactorMap:
    """Fit of the terms that the turns can separate."""
    ways = {np.sign(turn.table_rate) for turn in turns}
    if len(ways) < 2:
        rates = ", ".join(sorted({f"{turn.table_rate / DEG:.3g}" for turn in turns}))
        raise BenchError(
            f"{', '.join(sorted({turn.source for turn in turns}))}: rates of {rates} deg/s; the "
            "table must turn both ways, else bias and scale-factor error are confounded"
        )
    orders: list[int] = []
    tilt, refused = False, []
    for order in (*ORDERS, None):
        trial = orders if order is None else [*orders, order]
        worst = compute_largest_inflation(
            [_make_record(turn, bryan_factor, trial, order is None) for turn in turns]
        )
        if order != 4 and worst > LARGEST_INFLATION:
            refused.append(_describe_refusal(order, worst, turns))
        elif order is None:
            tilt = True
        else:
            orders.append(order)
    records = [_make_record(turn, bryan_factor, orders, tilt) for turn in turns]
    return ScaleFactorMap(tuple(turns), tuple(orders), fit_angles(records), tuple(refused))


def _describe_refusal(order: int | None, worst: float, turns: Sequence[Turn]) -> str:
    size = f"variance inflated {worst:.3g} times" if np.isfinite(worst) else "the same columns"
    if order is None:
        swept = max(float(np.ptp(turn.table_angle)) for turn in turns) / (2 * np.pi)
        return (
            f"{swept:.2g} turns of the table can't separate the tilt of the input axis, once a "
            f"turn, from the bias ({size}); 10 turns can"
        )
    swept = max(float(np.ptp(turn.pattern_angle)) for turn in turns) / DEG
    return (
        f"{swept:.3g} deg of pattern can't separate harmonic {order} from the other terms ({size})"
    )


def _make_record(turn: Turn, bryan_factor: float, orders: Sequence[int], tilt: bool) -> Record:
    rate = turn.input_rate
    columns = {SCALE: turn.input_angle, BIAS: turn.time}
    for order in orders:
        phase, factor = order * turn.pattern_angle, 1 / (order * bryan_factor)
        integrals = (-factor * np.sin(phase), factor * np.cos(phase))
        for name, integral in zip(name_terms(order), integrals, strict=True):
            columns[f"{SCALE} {name}"] = integral
            columns[f"{BIAS} {name}"] = integral / rate
    if tilt:
        columns[TILT[0]] = np.sin(turn.table_angle) / turn.table_rate
        columns[TILT[1]] = -np.cos(turn.table_angle) / turn.table_rate
    return Record(turn.interval, turn.excess, columns)


def make_period_table(turns: Sequence[Turn]) -> Table:
    """Rate, number of periods and scale-factor error over whole periods of each turn."""
    rows = []
    for turn in turns:
        _, angle, excess = turn.whole_periods()
        error = (excess[-1] - excess[0]) / (angle[-1] - angle[0])
        rate = f"{turn.table_rate / DEG:.4g}"
        rows.append((turn.source, rate, f"{turn.periods:.3g}", f"{error * 1e6:.4f}"))
    return Table("Turns", ("power-on", "rate, deg/s", "periods", "error, ppm"), tuple(rows))
