"""The diagnosis of a static record as a page: a section for each channel."""

import html

from pyhrg.common.pages.markup import Table, make_paragraph, make_table
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.report.figures import draw_allan_deviation, draw_spectrum
from pyhrg.gap.static_record.result import RecordDiagnosis, locate_excess

STYLE = (
    "body{font:16px/1.5 sans-serif;max-width:64em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}caption{text-align:left}"
    "td,th{padding:.15em .7em;text-align:left;border-bottom:1px solid #ddd}"
    "figure{display:inline-block;margin:0;max-width:31em}svg{max-width:100%;height:auto}"
    ".weak{color:#555}.wide{overflow-x:auto}"
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


def build_page(result: RecordDiagnosis) -> str:
    """The page as HTML."""
    title = html.escape(f"Noise of {result.source}")
    sections = (_build_section(d, i, result) for i, d in enumerate(result.channel_diagnoses))
    notes = "".join(make_paragraph(f"Left out: {note}", "weak") for note in result.notes)
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<title>{title}</title><style>{STYLE}</style></head><body><h1>{title}</h1>"
        f"{make_paragraph(VERDICT_SENTENCES[result.verdict])}{_build_overview(result)}{''.join(sections)}{notes}"
        "</body></html>\n"
    )


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
    return _build_wide_table(Table("Channels", header, rows))


def _build_wide_table(content: Table) -> str:
    return f'<div class="wide">{make_table(content)}</div>'


def _build_section(d: ChannelDiagnosis, index: int, result: RecordDiagnosis) -> str:
    parts = [
        f"<h2>{html.escape(d.channel.name)}</h2>",
        make_paragraph(VERDICT_SENTENCES[d.verdict]),
        _build_causes(d),
    ]
    for svg, text in ((draw_allan_deviation(d), "Allan deviation"), (draw_spectrum(d), "Spectrum")):
        parts.append(f'<figure role="img" aria-label="{text}, {d.channel.name}">{svg}</figure>')
    if d.verdict != "no_gap":
        parts.append(_build_places(d, index, result))
    ceilings = ", ".join(f"{name} {value:.3g}" for name, value in d.ceilings.items())
    believed = ", ".join(f"{name} {value:g}" for name, value in d.belief.stated.items())
    tolerance = f"each within {d.belief.tolerance:.0%} (1 sigma)"
    parts.append(make_paragraph(f"Believed: {believed}; {tolerance}.", "weak"))
    parts.append(
        make_paragraph(f"Upper 97.5 % bounds, whatever else is in the record: {ceilings}.", "weak")
    )
    return "".join(parts)


def _build_causes(d: ChannelDiagnosis) -> str:
    if not d.causes:
        return ""
    rows = tuple(
        (
            c.term.effect.replace("_", " "),
            f"{c.value:.4g} ({c.low:.4g} to {c.high:.4g})",
            c.term.parameter,
            f"{c.probability:.3f}",
            ", ".join(c.equivalents).replace("_", " ") or "-",
        )
        for c in d.causes
    )
    header = ("", "Level, 95 % interval", "Key", "Probability", "Confounded with")
    return _build_wide_table(Table("Terms that exceed the belief", header, rows))


def _build_places(d: ChannelDiagnosis, index: int, result: RecordDiagnosis) -> str:
    rows = tuple(
        (f"{low:.3g} to {high:.3g}", f"{share:.1%}", SOURCES[coordinate])
        for coordinate, (low, high), share in locate_excess(d, result.shared[index])
    )
    caption = "Where the whitened power differs from the belief (first half)"
    return _build_wide_table(Table(caption, ("Frequency, Hz", "Share", "Origin"), rows))
