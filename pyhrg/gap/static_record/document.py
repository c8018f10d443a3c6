"""The content of the `diagnosis.json` of a static record."""

from typing import Any

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.belief import PERIODS, TOLERANCE_PERCENT
from pyhrg.gap.static_record.fit.diagnosis import Cause, ChannelDiagnosis, HalfComparison
from pyhrg.gap.static_record.result import RecordDiagnosis, locate_excess

SCHEMA = "hrg-diagnosis/1"
DIGITS = 6
"""Significant digits of the numbers in the file."""
NEXT_TESTS = {
    "unexplained": "no noise term has this power: repeat on an isolated base, with a second sensor "
    "on it",
    "ambiguous": "the terms differ only in the slowest noise: repeat with a record four times as "
    "long",
}


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
            "band_hz": [round_digits(x) for x in band],
            "share": round_digits(share),
        }
        for coordinate, band, share in (locate_excess(d, shared) if d.verdict != "no_gap" else ())
    ]
    ranking = d.ranking
    return d.channel.name, {
        "verdict": d.verdict,
        "causes": [_build_cause(cause) for cause in d.causes],
        "unknown_probability": round_digits(ranking.unknown_probability),
        "log_evidence_ratio": round_digits(ranking.log_ratio),
        "unknowns": {
            u.name: round_digits(ranking.get_unknown_probability(u.name)) for u in ranking.unknowns
        },
        "where": where,
        "gap": {
            "fit": _build_gap(d.fit),
            "holdout": _build_gap(d.holdout),
            "shrink_percent": _compute_reduction(d.holdout),
            "halves_p_value": round_digits(d.holdout_p_value),
        },
        "belief": {
            "source": d.belief.source,
            **d.belief.stated,
            PERIODS: list(d.belief.periods),
            TOLERANCE_PERCENT: round_digits(100 * d.belief.tolerance),
        },
        "ceilings": {name: round_digits(value) for name, value in d.ceilings.items()},
    }


def _build_cause(cause: Cause) -> dict[str, Any]:
    name = cause.term.parameter
    return {
        "effect": cause.term.effect,
        "probability": round_digits(cause.probability),
        "parameters": {name: round_digits(cause.value)},
        "interval_95": {name: [round_digits(cause.low), round_digits(cause.high)]},
        "equivalents": list(cause.equivalents),
    }


def _build_gap(half: HalfComparison) -> dict[str, Any]:
    stages = {
        stage: {
            "whitened_rms": round_digits(whiteness.rms),
            "octave_log_rms": round_digits(whiteness.log_rms),
            "whiteness_p_value": round_digits(whiteness.p_value),
        }
        for stage, whiteness in (("before", half.before), ("after", half.after))
    }
    return {**stages, "floor": {"whitened_rms": 1.0}}


def _compute_reduction(holdout: HalfComparison) -> float:
    """Reduction of the octaves' log-power deviation beyond its value for white noise, per cent."""
    before = max(holdout.before.log_rms - holdout.before.log_floor, 0.0)
    after = max(holdout.after.log_rms - holdout.after.log_floor, 0.0)
    return round_digits(100 * (1 - after / before)) if before > 0 else 0.0


def _suggest_next_test(result: RecordDiagnosis) -> dict[str, str] | None:
    """A longer record separates slow noise terms; an isolated base separates motion from noise."""
    why = NEXT_TESTS.get(result.verdict)
    return {"kind": "static", "why": why} if why else None


def round_digits(value: float) -> float:
    """A number as the files state it."""
    return float(f"{value:.{DIGITS}g}")
