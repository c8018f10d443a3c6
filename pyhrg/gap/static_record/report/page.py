"""The files of a diagnosis of a static record; its page has a section for each channel."""

import html
import json
from pathlib import Path

import tomli_w

from pyhrg.common.arrays import Array
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table
from pyhrg.common.pages.shell import make_document
from pyhrg.common.pages.svg import format_interval
from pyhrg.gap.static_record.belief import PERIODS, TOLERANCE_PERCENT
from pyhrg.gap.static_record.document import build_document, round_digits
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.report.figures import draw_allan_deviation, draw_spectrum
from pyhrg.gap.static_record.result import RecordDiagnosis, locate_excess

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
