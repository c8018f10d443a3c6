"""The diagnosis of a static record as `diagnosis.json`."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.static_record.belief import TOLERANCE_PERCENT, Belief
from pyhrg.gap.static_record.fit.diagnosis import Cause, ChannelDiagnosis, Closing
from pyhrg.gap.static_record.fit.unknowns import Unknown, octaves
from pyhrg.gap.static_record.fit.whiteness import Whiteness
from pyhrg.gap.static_record.terms import GYRO

Array = NDArray[np.float64]

SCHEMA = "hrg-diagnosis/1"
VERDICTS = ("no_gap", "explained", "ambiguous", "unexplained")
"""The worst last."""
LEAST_SHARE = 0.01
DIGITS = 6


@dataclass(frozen=True)
class RecordDiagnosis:
    """Of a file; shared: (c, k) share of each channel's power that the others show too."""

    source: str
    notes: tuple[str, ...]
    channels: tuple[ChannelDiagnosis, ...]
    shared: Array
    seed: int

    @property
    def verdict(self) -> str:
        """The worst of all channels."""
        return max((c.verdict for c in self.channels), key=VERDICTS.index)


def as_json(result: RecordDiagnosis) -> dict[str, Any]:
    """With the keys of the schema; what a static record adds lies by channel."""
    parts = [
        _channel(c, s, result.source) for c, s in zip(result.channels, result.shared, strict=True)
    ]
    return {
        "schema": SCHEMA,
        "record": result.source,
        "seed": result.seed,
        "verdict": result.verdict,
        "causes": [{"channel": name, **x} for name, p in parts for x in p["causes"]],
        "unknown_probability": max(p["unknown_probability"] for _, p in parts),
        "where": [x for _, p in parts for x in p["where"]],
        "gap": {name: p["gap"] for name, p in parts},
        "next_test": _next_test(result),
        "channels": dict(parts),
        "notes": list(result.notes),
    }


def excess_shares(
    d: ChannelDiagnosis, shared: Array
) -> list[tuple[str, tuple[float, float], float]]:
    """Coordinate, band (Hz) and share of the excess power, where it is a hundredth and more.

    What other channels show too came from outside: it is the input's. The rest is noise, or time
    where power that changes or repeats is likelier than a steady spectrum.
    """
    n = len(d.channel.part(0, d.channel.half).angle) - 1
    bands = octaves(n)
    power = np.abs(d.fit.before.octaves - 1) * [b.stop - b.start for b in bands]
    motion = np.resize(np.concatenate([shared, np.zeros(len(bands))]), len(bands))
    inside = "noise" if d.causes else _coordinate(d.judgement.unknowns)
    outside = "rate" if d.channel.kind is GYRO else "acceleration"
    found = []
    for band, size, common in zip(bands, power / np.sum(power), motion, strict=True):
        hertz = tuple(x / (2 * (n + 1) * d.channel.interval) for x in (band.start, band.stop))
        for where, share in ((outside, size * common), (inside, size * (1 - common))):
            if share >= LEAST_SHARE:
                found.append((where, (hertz[0], hertz[1]), float(share)))
    return found


def _coordinate(unknowns: Sequence[Unknown]) -> str:
    return max(unknowns, key=lambda u: u.log_ratio).coordinate


def _channel(d: ChannelDiagnosis, shared: Array, source: str) -> tuple[str, dict[str, Any]]:
    where = [
        {
            "test": source,
            "channel": d.channel.name,
            "coordinate": coordinate,
            "band_hz": [_rounded(x) for x in band],
            "share": _rounded(share),
        }
        for coordinate, band, share in (excess_shares(d, shared) if d.verdict != "no_gap" else ())
    ]
    judgement = d.judgement
    return d.channel.name, {
        "verdict": d.verdict,
        "causes": [_cause(cause) for cause in d.causes],
        "unknown_probability": _rounded(judgement.unknown_probability),
        "log_evidence_ratio": _rounded(judgement.log_ratio),
        "unknowns": {u.name: _rounded(judgement.share_of(u.name)) for u in judgement.unknowns},
        "where": where,
        "gap": {"fit": _gap(d.fit), "holdout": _gap(d.holdout)} | _shrink(d.holdout),
        "belief": _belief(d.belief),
        "ceilings": {name: _rounded(value) for name, value in d.ceilings.items()},
    }


def _belief(belief: Belief) -> dict[str, Any]:
    return {
        "source": belief.source,
        **belief.stated,
        "sinusoid_periods_s": list(belief.periods),
        TOLERANCE_PERCENT: _rounded(100 * belief.tolerance),
    }


def _cause(cause: Cause) -> dict[str, Any]:
    name = cause.term.parameter
    return {
        "effect": cause.term.effect,
        "probability": _rounded(cause.probability),
        "parameters": {name: _rounded(cause.value)},
        "interval_95": {name: [_rounded(cause.low), _rounded(cause.high)]},
        "equivalents": list(cause.equivalents),
    }


def _gap(closing: Closing) -> dict[str, Any]:
    return {
        "before": _whiteness(closing.before),
        "after": _whiteness(closing.after),
        "floor": {"whitened_rms": 1.0},
    }


def _whiteness(found: Whiteness) -> dict[str, float]:
    return {
        "whitened_rms": _rounded(found.rms),
        "octave_log_rms": _rounded(found.log_rms),
        "whiteness_p_value": _rounded(found.p_value),
    }


def _shrink(holdout: Closing) -> dict[str, float]:
    """Of the octaves' departure from the promised power, above what chance leaves."""
    before = max(holdout.before.log_rms - holdout.before.log_floor, 0.0)
    after = max(holdout.after.log_rms - holdout.after.log_floor, 0.0)
    return {"shrink_percent": _rounded(100 * (1 - after / before)) if before > 0 else 0.0}


def _next_test(result: RecordDiagnosis) -> dict[str, str] | None:
    """A longer record separates slow noises; a still one separates motion from noise."""
    if result.verdict == "unexplained":
        why = "power that no noise term has: repeat on an isolated base, with a second sensor on it"
        return {"kind": "static", "why": why}
    if result.verdict == "ambiguous":
        why = "terms that differ in the slowest noise alone: repeat four times as long"
        return {"kind": "static", "why": why}
    return None


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")
