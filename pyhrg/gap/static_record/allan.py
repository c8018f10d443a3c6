"""Bias, Allan deviation and noise coefficients of a static record."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import pandas as pd

from pyhrg.common.made_by import list_versions
from pyhrg.common.pages.svg import format_interval, format_number
from pyhrg.gap.static_record.record import Channel, StaticRecord
from pyhrg.gap.static_record.terms import Term
from pyhrg.noise.allan import AllanDeviation, estimate_allan_deviation
from pyhrg.noise.coefficients import (
    COEFFICIENT_NAMES,
    Coefficient,
    NoiseCoefficients,
    compute_allan_deviation,
)
from pyhrg.noise.fitting import NORMAL_QUANTILE, estimate_noise
from pyhrg.noise.ramp import estimate_rate_ramp

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SCHEMA = "hrg-allan/1"
FILES = RESULT, TABLE, PAGE = "allan.json", "allan.csv", "report.html"


@dataclass(frozen=True)
class ChannelNoise:
    """Noise of one sensor, SI.

    bias: mean of the readings with its 95 % interval; Earth's rate and gravity are in it. The
        interval is that of a normal estimate whose standard deviation is the Allan deviation that
        the fitted noise has over the whole record.
    ramp: change of the bias with time, which is no noise.
    """

    channel: Channel
    bias: Coefficient
    deviation: AllanDeviation
    noise: NoiseCoefficients
    ramp: Coefficient

    @property
    def coefficients(self) -> Mapping[Term, Coefficient]:
        """Fitted coefficients by term."""
        values = (getattr(self.noise, name) for name in COEFFICIENT_NAMES)
        return dict(zip(self.channel.kind.terms, values, strict=True))

    @property
    def rows(self) -> list[tuple[str, str, str, str]]:
        """Name, value with 95 % interval, unit and key of the bias, the coefficients and the ramp;
        an upper bound where the record does not show a noise."""
        kind = self.channel.kind
        rows = [("mean", _format(self.bias, kind.rate_scale), kind.rate_unit, "")]
        for term, c in self.coefficients.items():
            shown = _format(c, term.factor)
            if not c.present:
                shown = f"< {format_number(c.high / term.factor)}".replace("\N{MINUS SIGN}", "-")
            rows.append((term.effect.replace("_", " "), shown, term.unit, term.parameter))
        ramp = kind.ramp
        shown = _format(self.ramp, ramp.factor)
        return [*rows, (ramp.effect.replace("_", " "), shown, ramp.unit, ramp.parameter)]


@dataclass(frozen=True, repr=False)
class RecordNoise:
    """Noise of the sensors of a static record.

    source: name of the file; notes: a sentence on each thing that was left out of it.
    """

    source: str
    channels: tuple[ChannelNoise, ...]
    notes: tuple[str, ...] = ()

    @property
    def deviations(self) -> pd.DataFrame:
        """Allan deviation of each channel with 95 % intervals, in the unit of column `unit`."""
        frame = pd.concat([_tabulate(each) for each in self.channels], ignore_index=True)
        rate = frame["unit"].iloc[0] if frame["unit"].nunique() == 1 else "as in column unit"
        units = {"cluster_time_s": "s", "deviation": rate, "low_95": rate, "high_95": rate}
        frame.attrs["units"] = {name: units.get(name, "1") for name in frame.columns}
        return frame

    def plot(self, ax: "Axes | None" = None) -> "list[Axes]":
        """Draw each channel's Allan deviation with 95 % intervals and the noise fitted to it.

        Args:
            ax: of a grid (`plt.subplots`), whose place the figure takes; a figure of its own if
                None.

        Returns:
            The axes that were drawn, one a channel; their units are in the labels.

        Raises:
            HrgError: `ax` has no place in a grid.
        """
        from pyhrg.bench.figures import draw_in_place

        return draw_in_place(self._draw, ax)

    def _draw(self, figure: "Figure") -> None:
        """Draw the channels, up to three side by side."""
        from pyhrg.gap.static_record.allan_figure import plot_deviation, plot_fitted_noise

        columns = min(len(self.channels), 3)
        for number, each in enumerate(self.channels, 1):
            axes = figure.add_subplot(-(-len(self.channels) // columns), columns, number)
            kind = each.channel.kind
            plot_deviation(axes, each.deviation, kind)
            plot_fitted_noise(axes, each.deviation.tau, each.noise, each.ramp, kind)
            axes.set_title(each.channel.name)
            axes.legend()

    @property
    def document(self) -> dict[str, Any]:
        """Content of allan.json: coefficients in the units that their keys name."""
        return {
            "schema": SCHEMA,
            "made_by": list_versions(),
            "source": self.source,
            "channels": {each.channel.name: _describe(each) for each in self.channels},
            "notes": list(self.notes),
        }

    @property
    def summary(self) -> str:
        """Bias and coefficients of each channel, a line each."""
        lines = [self.source]
        for each in self.channels:
            n, interval = each.deviation.n, each.channel.interval
            lines += ["", f"{each.channel.name}: {n} readings, {n * interval:.6g} s"]
            lines += [f"  {name:<26} {value:<36} {unit}" for name, value, unit, _ in each.rows]
        return "\n".join([*lines, *(f"record: {note}" for note in self.notes)])

    def __repr__(self) -> str:
        return f"<RecordNoise of {self.source}: {len(self.channels)} channels>"


def measure_noise(record: StaticRecord) -> RecordNoise:
    """Bias, Allan deviation and noise coefficients (IEEE Std 952) of a record's channels."""
    return RecordNoise(record.source, tuple(map(_measure, record.channels)), record.notes)


def _measure(channel: Channel) -> ChannelNoise:
    noise = estimate_noise(channel.angle, channel.interval)
    duration = len(channel.angle) * channel.interval
    reach = NORMAL_QUANTILE * float(compute_allan_deviation(duration, noise))
    bias = Coefficient(channel.mean, channel.mean - reach, channel.mean + reach)
    deviation = estimate_allan_deviation(channel.angle, channel.interval)
    ramp = estimate_rate_ramp(channel.angle, channel.interval, noise)
    return ChannelNoise(channel, bias, deviation, noise, ramp)


def _format(c: Coefficient, factor: float) -> str:
    values = format_interval(c.value / factor, c.low / factor, c.high / factor)
    return values.replace("\N{MINUS SIGN}", "-")


def _tabulate(each: ChannelNoise) -> pd.DataFrame:
    measured, kind = each.deviation, each.channel.kind
    return pd.DataFrame(
        {
            "channel": each.channel.name,
            "cluster_time_s": measured.tau,
            "deviation": measured.deviation / kind.rate_scale,
            "low_95": measured.low / kind.rate_scale,
            "high_95": measured.high / kind.rate_scale,
            "unit": kind.rate_unit,
        }
    )


def _describe(each: ChannelNoise) -> dict[str, Any]:
    kind = each.channel.kind
    figures = {
        f"mean_{kind.rate_unit.replace('/', '_').replace('-', '_')}": (each.bias, kind.rate_scale)
    }
    terms = {**each.coefficients, kind.ramp: each.ramp}
    figures |= {term.parameter: (c, term.factor) for term, c in terms.items()}
    return {"n": each.deviation.n, "interval_s": each.channel.interval} | {
        key: {"value": c.value / factor, "interval_95": [c.low / factor, c.high / factor]}
        for key, (c, factor) in figures.items()
    }
