"""The scale-factor map: what methods A and B share.

The output rate of a gyro that turns at W (Earth included) with its pattern at th is

    W (1 + s + sum over h of c_h cos h th + s_h sin h th) + B + the same harmonics of the bias

(paper, Eq. 2, in the rate form: a gain mismatch g of the pick-offs is c_4 = -g, a non-orthogonality
d is s_4 = -d). Its integral is fitted to the angle, so that nothing is lost by smoothing and the
encoder, not the clock, is the reference. Turning both ways separates what is proportional to the
rate from the bias: at one rate they look the same.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.angle_fit import AngleFit, Record, fit_angles, inflation
from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, TILT, harmonic
from pyhrg.bench.estimation.magnitude import magnitude_interval
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.readings.turns import Turn
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG, PPM

Array = NDArray[np.float64]

SCALE = "scale factor"
BIAS = "bias"
ORDERS = (4, 2, 8)
"""Harmonics of the map in the order in which they are asked of the records."""


@dataclass(frozen=True)
class ScaleFactorMap:
    """Fit of all turns of a test.

    orders: harmonics that could be told apart; refused: a sentence on each that could not.
    """

    turns: tuple[Turn, ...]
    orders: tuple[int, ...]
    fit: AngleFit
    refused: tuple[str, ...]

    def harmonics(self, kind: str = SCALE) -> tuple[str, ...]:
        """Names of the harmonics' terms."""
        return tuple(f"{kind} {name}" for order in self.orders for name in harmonic(order))

    def at(self, pattern_angle: Array) -> Array:
        """Scale-factor error without its mean at pattern angles, rad."""
        phase = np.multiply.outer(pattern_angle, self.orders)
        waves = np.stack([np.cos(phase), np.sin(phase)], axis=-1).reshape(*phase.shape[:-1], -1)
        values = [self.fit.value(name) for name in self.harmonics()]
        return np.asarray(waves @ np.array(values))

    def findings(self) -> tuple[Finding, ...]:
        """Scale factor, its variation, pick-off errors, the other harmonics, bias."""
        orders = [order for order in self.orders if order != 4]
        names = [f"{SCALE} {name}" for order in orders for name in harmonic(order)]
        return (
            self.finding(SCALE, "scale factor error", "ppm", note="of the nominal Bryan factor"),
            self.variation(),
            self.finding(f"{SCALE} cos4", "pick-off gain mismatch", "ppm", -1.0),
            self.finding(f"{SCALE} sin4", "pick-off non-orthogonality", "ppm", -1.0),
            *(self.finding(name, name, "ppm") for name in names),
            self.finding(BIAS, "bias", "deg/h"),
            *(self.finding(name, name, "deg/h", note=self.even()) for name in self.harmonics(BIAS)),
        )

    def even(self) -> str:
        """What the bias's harmonics hold besides the bias."""
        fastest = max(abs(turn.table_rate) for turn in self.turns) / DEG
        return (
            f"what is even in the rate, up to {fastest:.3g} deg/s: the bias map and what the loops "
            "add with the square of the rate"
        )

    def finding(
        self, term: str, name: str, unit: str, sign: float = 1.0, note: str = ""
    ) -> Finding:
        """One term."""
        low, high = sorted(sign * bound for bound in self.fit.interval(term))
        n = len(self.fit.residual)
        return Finding(name, sign * self.fit.value(term), unit, low, high, n, note)

    def variation(self) -> Finding:
        """Standard deviation of the scale factor over the circumference."""
        chosen = [self.fit.names.index(name) for name in self.harmonics()]
        covariance = self.fit.covariance[np.ix_(chosen, chosen)] / 2
        value, low, high = magnitude_interval(self.fit.values[chosen] / np.sqrt(2), covariance)
        note = f"standard deviation, harmonics {', '.join(map(str, sorted(self.orders)))}"
        n = len(self.fit.residual)
        return Finding("scale factor variation", value, "ppm", low, high, n, note)

    def verdict(self) -> str:
        """How much the scale factor varies over the circumference, without the full stop."""
        variation = self.variation()
        low, high = variation.interval_shown
        if not low > 0:
            return (
                f"No variation of the scale factor is seen: its deviation is {high:.2g} ppm at most"
            )
        largest = float(np.max(np.abs(self.at(np.linspace(0.0, np.pi, 721))))) / PPM
        return (
            f"The scale factor varies by {variation.shown:.3g} ppm over the circumference "
            f"(standard deviation; {largest:.3g} ppm at most)"
        )


def fitted(found: Sequence[Turn], bryan_factor: float) -> ScaleFactorMap:
    """Fit the map by what the turns can tell apart.

    Args:
        found: at one or several rates, in both directions.
        bryan_factor: nominal.

    Raises:
        BenchError: one direction only.
    """
    ways = {np.sign(turn.table_rate) for turn in found}
    if len(ways) < 2:
        rates = ", ".join(sorted({f"{turn.table_rate / DEG:.3g}" for turn in found}))
        raise BenchError(
            f"{', '.join(sorted({turn.source for turn in found}))}: rates of {rates} deg/s; the "
            "table must turn both ways, else a bias looks like a scale-factor error"
        )
    orders: list[int] = []
    tilt, refused = False, []
    for order in (*ORDERS, None):
        trial = orders if order is None else [*orders, order]
        worst = inflation([_record(turn, bryan_factor, trial, order is None) for turn in found])
        if order != 4 and worst > LARGEST_INFLATION:
            refused.append(_refusal(order, worst, found))
        elif order is None:
            tilt = True
        else:
            orders.append(order)
    records = [_record(turn, bryan_factor, orders, tilt) for turn in found]
    return ScaleFactorMap(tuple(found), tuple(orders), fit_angles(records), tuple(refused))


def _refusal(order: int | None, worst: float, found: Sequence[Turn]) -> str:
    size = f"variance inflated {worst:.3g} times" if np.isfinite(worst) else "the same columns"
    if order is None:
        swept = max(float(np.ptp(turn.table_angle)) for turn in found) / (2 * np.pi)
        return (
            f"{swept:.2g} turns of the table can't tell the tilt of the input axis, once a turn, "
            f"from the bias ({size}); 10 turns can"
        )
    swept = max(float(np.ptp(turn.pattern_angle)) for turn in found) / DEG
    return f"{swept:.3g} deg of pattern can't tell harmonic {order} from the other terms ({size})"


def _record(turn: Turn, bryan_factor: float, orders: Sequence[int], tilt: bool) -> Record:
    rate = turn.input_rate
    columns = {SCALE: turn.input_angle, BIAS: turn.time}
    for order in orders:
        phase, factor = order * turn.pattern_angle, 1 / (order * bryan_factor)
        integrals = (-factor * np.sin(phase), factor * np.cos(phase))
        for name, integral in zip(harmonic(order), integrals, strict=True):
            columns[f"{SCALE} {name}"] = integral
            columns[f"{BIAS} {name}"] = integral / rate
    if tilt:
        columns[TILT[0]] = np.sin(turn.table_angle) / turn.table_rate
        columns[TILT[1]] = -np.cos(turn.table_angle) / turn.table_rate
    return Record(turn.interval, turn.excess, columns)


def period_table(found: Sequence[Turn]) -> Table:
    """Each turn: rate, periods, and the output's error over whole periods."""
    rows = []
    for turn in found:
        _, angle, excess = turn.whole_periods()
        error = (excess[-1] - excess[0]) / (angle[-1] - angle[0])
        rate = f"{turn.table_rate / DEG:.4g}"
        rows.append((turn.source, rate, f"{turn.periods:.3g}", f"{error * 1e6:.4f}"))
    return Table("Turns", ("power-on", "rate, deg/s", "periods", "error, ppm"), tuple(rows))
