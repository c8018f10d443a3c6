"""The content of the `diagnosis.json` of a static record."""

from typing import Any

from pyhrg.gap.static_record.belief import TOLERANCE_PERCENT, Belief
from pyhrg.gap.static_record.fit.diagnosis import Cause, ChannelDiagnosis, HalfComparison
from pyhrg.gap.static_record.fit.whiteness import Whiteness
from pyhrg.gap.static_record.result import Array, RecordDiagnosis, locate_excess

SCHEMA = "hrg-diagnosis/1"
DIGITS = 6
"""Significant digits of the numbers in the file."""


def build_document(result: RecordDiagnosis) -> dict[str, Any]:
    """The document with the keys of a campaign's diagnosis; `channels` has the rest by channel."""
    pairs = zip(result.channel_diagnoses, result.shared, strict=True)
    parts = [_build_channel(d, shared, result.source) for d, shared in pairs]
    return {
        "schema": SCHEMA,
        "record": result.source,
        "seed": result.seed,
        "verdict": result.verdict,
        "causes": [{"channel": name, **x} for name, p in parts for x in p["causes"]],
        "unknown_probability": max(p["unknown_probability"] for _, p in parts),
        "where": [x for _, p in parts for x in p["where"]],
        "gap": {name: p["gap"] for name, p in parts},
        "next_test": _suggest_next_test(result),
        "channels": dict(parts),
        "notes": list(result.notes),
    }


def _build_channel(d: ChannelDiagnosis, shared: Array, source: str) -> tuple[str, dict[str, Any]]:
    where = [
        {
            "test": source,
            "channel": d.channel.name,
            "coordinate": coordinate,
            "band_hz": [_round(x) for x in band],
            "share": _round(share),
        }
        for coordinate, band, share in (locate_excess(d, shared) if d.verdict != "no_gap" else ())
    ]
    ranking = d.ranking
    return d.channel.name, {
        "verdict": d.verdict,
        "causes": [_build_cause(cause) for cause in d.causes],
        "unknown_probability": _round(ranking.unknown_probability),
        "log_evidence_ratio": _round(ranking.log_ratio),
        "unknowns": {
            u.name: _round(ranking.get_unknown_probability(u.name)) for u in ranking.unknowns
        },
        "where": where,
        "gap": {"fit": _build_gap(d.fit), "holdout": _build_gap(d.holdout)}
        | _compute_reduction(d.holdout),
        "belief": _build_belief(d.belief),
        "ceilings": {name: _round(value) for name, value in d.ceilings.items()},
    }


def _build_belief(belief: Belief) -> dict[str, Any]:
    return {
        "source": belief.source,
        **belief.stated,
        "sinusoid_periods_s": list(belief.periods),
        TOLERANCE_PERCENT: _round(100 * belief.tolerance),
    }


def _build_cause(cause: Cause) -> dict[str, Any]:
    name = cause.term.parameter
    return {
        "effect": cause.term.effect,
        "probability": _round(cause.probability),
        "parameters": {name: _round(cause.value)},
        "interval_95": {name: [_round(cause.low), _round(cause.high)]},
        "equivalents": list(cause.equivalents),
    }


def _build_gap(closing: HalfComparison) -> dict[str, Any]:
    return {
        "before": _build_whiteness(closing.before),
        "after": _build_whiteness(closing.after),
        "floor": {"whitened_rms": 1.0},
    }


def _build_whiteness(whiteness: Whiteness) -> dict[str, float]:
    return {
        "whitened_rms": _round(whiteness.rms),
        "octave_log_rms": _round(whiteness.log_rms),
        "whiteness_p_value": _round(whiteness.p_value),
    }


def _compute_reduction(holdout: HalfComparison) -> dict[str, float]:
    """Reduction of the octaves' log-power deviation beyond its value for white noise, per cent."""
    before = max(holdout.before.log_rms - holdout.before.log_floor, 0.0)
    after = max(holdout.after.log_rms - holdout.after.log_floor, 0.0)
    return {"shrink_percent": _round(100 * (1 - after / before)) if before > 0 else 0.0}


def _suggest_next_test(result: RecordDiagnosis) -> dict[str, str] | None:
    """A longer record separates slow noise terms; an isolated base separates motion from noise."""
    if result.verdict == "unexplained":
        why = "no noise term has this power: repeat on an isolated base, with a second sensor on it"
        return {"kind": "static", "why": why}
    if result.verdict == "ambiguous":
        why = "the terms differ only in the slowest noise: repeat with a record four times as long"
        return {"kind": "static", "why": why}
    return None


def _round(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")
