"""The files of a diagnosis of a static record: `diagnosis.json`, a page with a section for each
channel, and the closed noise model.
"""

import html
import json
from pathlib import Path
from typing import Any

import tomli_w

from pyhrg.common.arrays import Array
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import Table, make_document, make_paragraph, make_wide_table
from pyhrg.common.pages.svg import format_interval
from pyhrg.gap.static_record.belief import PERIODS, TOLERANCE_PERCENT
from pyhrg.gap.static_record.fit.diagnosis import Cause, ChannelDiagnosis, HalfComparison
from pyhrg.gap.static_record.report.figures import draw_allan_deviation, draw_spectrum
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


RESULT, PAGE, CLOSED = "diagnosis.json", "report.html", "closed.toml"
STYLE = (
    "td,th{text-align:left}svg text{fill:#000}"
    ".panels{grid-template-columns:repeat(auto-fill,minmax(min(100%,28rem),1fr))}"
)

VERDICT_SENTENCES = {
    "no_gap": "No gap: the noise agrees with the belief.",
    "explained": "A noise term exceeds the belief, and it is identified.",
    "ambiguous": "A noise term exceeds the belief; this record can't separate it from others.",
    "unexplained": "No noise term explains this record: an unknown takes part.",
}
SOURCES = {
    "rate": "motion: other channels show it too",
    "acceleration": "motion: other channels show it too",
    "noise": "the channel's own noise, stationary; or too slow to decide",
    "time": "the channel's own, changing or periodic; or too slow to decide",
}


def write_record_report(result: RecordDiagnosis, out: Path) -> None:
    """Write `diagnosis.json`, `report.html` and `closed.toml`: a belief with the noise that was
    found, by channel."""
    closed = {d.channel.name: _state_closed_noise(d) for d in result.channel_diagnoses}
    texts = {
        PAGE: build_page(result),
        CLOSED: tomli_w.dumps(closed),
        RESULT: json.dumps(build_document(result), indent=1, allow_nan=False) + "\n",
    }
    with stage_files(out, tuple(texts)) as aside:
        for name, text in texts.items():
            (aside / name).write_text(text, encoding="utf-8")


def _state_closed_noise(d: ChannelDiagnosis) -> dict[str, object]:
    """The closed noise model under the keys of a belief."""
    terms = zip(d.channel.kind.terms, d.closed.tolist(), strict=True)
    levels = {t.parameter: round_digits(x / t.factor) for t, x in terms if x}
    ramp = d.channel.kind.ramp
    ramps = [c.value for c in d.causes if c.term is ramp] or [d.belief.ramp / ramp.factor]
    if ramps[0]:
        levels[ramp.parameter] = round_digits(ramps[0])
    tolerance = round_digits(100 * d.belief.tolerance)
    return {**levels, PERIODS: list(d.belief.periods), TOLERANCE_PERCENT: tolerance}


def build_page(result: RecordDiagnosis) -> str:
    title = f"Noise of {result.source}"
    pairs = zip(result.channel_diagnoses, result.shared, strict=True)
    body = [
        f"<h1>{html.escape(title)}</h1>",
        make_paragraph(VERDICT_SENTENCES[result.verdict]),
        _build_overview(result),
        *(_build_section(d, shared) for d, shared in pairs),
        *(make_paragraph(f"Record: {note}", "weak") for note in result.notes),
    ]
    return make_document(title, STYLE, "".join(body), "")


def _build_overview(result: RecordDiagnosis) -> str:
    rows = tuple(
        (
            d.channel.name,
            d.verdict.replace("_", " "),
            f"{d.ranking.log_ratio:.4g}",
            f"{d.ranking.unknown_probability:.2g}",
            f"{d.holdout.before.rms:.4g}",
            f"{d.holdout.after.rms:.4g}",
        )
        for d in result.channel_diagnoses
    )
    header = (
        *("", "Verdict", "ln Bayes factor of a gap", "Probability of an unknown"),
        *("Whitened rms, held-out half, as believed", "with the terms that were found"),
    )
    return make_wide_table(Table("Channels", header, rows))


def _build_section(d: ChannelDiagnosis, shared: Array) -> str:
    name = html.escape(d.channel.name)
    ceilings = ", ".join(f"{name} {value:.3g}" for name, value in d.ceilings.items())
    believed = ", ".join(f"{name} {value:g}" for name, value in d.belief.stated.items())
    tolerance = f"each within {d.belief.tolerance:.0%} (1 sigma)"
    figures = ((draw_allan_deviation(d), "Allan deviation"), (draw_spectrum(d), "Spectrum"))
    return "".join(
        [
            f"<h2>{name}</h2>",
            make_paragraph(VERDICT_SENTENCES[d.verdict]),
            _build_causes(d) if d.causes else "",
            '<div class="panels">',
            *(f'<figure role="img" aria-label="{t}, {name}">{svg}</figure>' for svg, t in figures),
            "</div>",
            _build_places(d, shared) if d.verdict != "no_gap" else "",
            make_paragraph(f"Believed: {believed}; {tolerance}.", "weak"),
            make_paragraph(
                f"Upper 97.5 % bounds, whatever else is in the record: {ceilings}.", "weak"
            ),
        ]
    )


def _build_causes(d: ChannelDiagnosis) -> str:
    rows = tuple(
        (
            c.term.effect.replace("_", " "),
            format_interval(c.value, c.low, c.high),
            c.term.parameter,
            f"{c.probability:.3f}",
            ", ".join(c.equivalents).replace("_", " ") or "-",
        )
        for c in d.causes
    )
    header = ("", "Level, 95 % interval", "Key", "Probability", "Confounded with")
    return make_wide_table(Table("Terms that exceed the belief", header, rows))


def _build_places(d: ChannelDiagnosis, shared: Array) -> str:
    rows = tuple(
        (f"{low:.3g} to {high:.3g}", f"{share:.1%}", SOURCES[coordinate])
        for coordinate, (low, high), share in locate_excess(d, shared)
    )
    caption = "Where the whitened power differs from the belief (first half)"
    return make_wide_table(Table(caption, ("Frequency, Hz", "Share", "Origin"), rows))
