"""The diagnosis of a static record."""

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd

from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.fit.unknowns import split_octaves
from pyhrg.gap.static_record.terms import GYRO

VERDICTS = ("no_gap", "explained", "ambiguous", "unexplained")
"""Verdicts in rising order; a record has the highest of its channels."""
SMALLEST_SHARE = 0.01
"""Share of the excess power below which an octave is not listed (chosen)."""

NOTED_P_VALUE = 0.01
"""Probability of equal halves below which an unexplained channel's line says it (chosen)."""


@dataclass(frozen=True)
class RecordDiagnosis:
    """The diagnosis of a static record of c channels.

    source: name of the record.
    notes: what was left out, a sentence each.
    channel_diagnoses: c diagnoses.
    shared: (c, k) share of each channel's power in each octave that the other channels show too.
    seed: of the importance samples.
    """

    source: str
    notes: tuple[str, ...]
    channel_diagnoses: tuple[ChannelDiagnosis, ...]
    shared: Array
    seed: int

    __repr__ = describe_briefly

    @property
    def verdict(self) -> str:
        """The highest verdict of all channels: `no_gap`, `explained`, `ambiguous` or
        `unexplained`."""
        return max((d.verdict for d in self.channel_diagnoses), key=VERDICTS.index)

    @property
    def channels(self) -> pd.DataFrame:
        """One row for each noise term that was found, and one for each channel without any.

        Columns: channel, verdict, effect, probability, parameter (its name ends with its unit),
        value, low_95, high_95, unknown_probability. The columns of a term are empty (None, NaN) in
        a channel without any.
        """
        rows: list[tuple[object, ...]] = []
        for d in self.channel_diagnoses:
            terms: list[tuple[object, ...]] = [
                (c.term.effect, c.probability, c.term.parameter, c.value, c.low, c.high)
                for c in d.causes
            ]
            empty = (None, math.nan, None, math.nan, math.nan, math.nan)
            for term in terms or [empty]:
                rows.append((d.channel.name, d.verdict, *term, d.ranking.unknown_probability))
        columns = ("channel", "verdict", "effect", "probability", "parameter", "value")
        return pd.DataFrame(rows, columns=[*columns, "low_95", "high_95", "unknown_probability"])

    @property
    def summary(self) -> str:
        """Verdicts, causes, motion and halves that differ, a line a channel."""
        lines = [f"{self.source}: {self.verdict.replace('_', ' ')}"]
        for d, shared in zip(self.channel_diagnoses, self.shared, strict=True):
            findings = [f"{c.term.effect} {c.probability:.3f}" for c in d.causes]
            if d.verdict != "no_gap":
                findings += _describe_motion(d, shared)
            if d.verdict == "unexplained" and d.holdout_p_value < NOTED_P_VALUE:
                findings.append(f"held-out half differs, p = {d.holdout_p_value:.1g}")
            verdict = d.verdict.replace("_", " ")
            lines.append(
                f"  {d.channel.name}: {verdict}{': ' if findings else ''}{', '.join(findings)}"
            )
        return "\n".join(lines)


def _describe_motion(d: ChannelDiagnosis, shared: Array) -> list[str]:
    outside = _name_motion(d)
    share = sum(size for coordinate, _, size in locate_excess(d, shared) if coordinate == outside)
    return [f"motion {share:.0%} (other channels show it)"] if share > 0 else []


def _name_motion(d: ChannelDiagnosis) -> str:
    """Coordinate of what moves all sensors."""
    return "rate" if d.channel.kind is GYRO else "acceleration"


def locate_excess(
    d: ChannelDiagnosis, shared: Array
) -> list[tuple[str, tuple[float, float], float]]:
    """Coordinate, band (Hz) and share of the power that differs from the believed noise, by octave.

    `shared` (k,) is the share of the channel's power that other channels show too. It is motion:
    its coordinate is the rate or the acceleration. The coordinate of the other power is the noise,
    or time where a change of the noise or a periodic signal is the most probable unknown.
    """
    n = len(d.channel.part(0, d.channel.half).angle) - 1
    bands = split_octaves(n)
    power = np.abs(d.fit.before.octaves - 1) * [b.stop - b.start for b in bands]
    motion = np.resize(np.concatenate([shared, np.zeros(len(bands))]), len(bands))
    likeliest = max(d.ranking.unknowns, key=lambda unknown: unknown.log_ratio)
    own = "noise" if d.causes else likeliest.coordinate
    outside = _name_motion(d)
    places = []
    for band, size, common in zip(bands, power / np.sum(power), motion, strict=True):
        hertz = tuple(x / (2 * (n + 1) * d.channel.interval) for x in (band.start, band.stop))
        for coordinate, share in ((outside, size * common), (own, size * (1 - common))):
            if share >= SMALLEST_SHARE:
                places.append((coordinate, (hertz[0], hertz[1]), float(share)))
    return places
