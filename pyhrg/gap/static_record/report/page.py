"""The diagnosis of a static record as a page: a section for each channel."""

import html

from pyhrg.common.pages.markup import Table, paragraph, table
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.report.figures import allan_svg, spectrum_svg
from pyhrg.gap.static_record.result import RecordDiagnosis, excess_shares

STYLE = (
    "body{font:16px/1.5 sans-serif;max-width:64em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}caption{text-align:left}"
    "td,th{padding:.15em .7em;text-align:left;border-bottom:1px solid #ddd}"
    "figure{display:inline-block;margin:0;max-width:31em}svg{max-width:100%;height:auto}"
    ".weak{color:#555}.wide{overflow-x:auto}"
)
WORDS = {
    "no_gap": "As believed: nothing speaks for more than the noise model has.",
    "explained": "A noise term is missing, and it is known which.",
    "ambiguous": "A noise term is missing; of some this record can't tell which.",
    "unexplained": "No noise term explains this record: something else takes part.",
}
SOURCE = {
    "rate": "motion: other channels show it too",
    "acceleration": "motion: other channels show it too",
    "noise": "the channel's own, steady; or too slow to tell",
    "time": "the channel's own, changing or periodic; or too slow to tell",
}


def page(result: RecordDiagnosis) -> str:
    """The whole."""
    title = html.escape(f"Noise of {result.source}")
    sections = (_section(d, i, result) for i, d in enumerate(result.channels))
    notes = "".join(paragraph(f"Left out: {note}", "weak") for note in result.notes)
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<title>{title}</title><style>{STYLE}</style></head><body><h1>{title}</h1>"
        f"{paragraph(WORDS[result.verdict])}{_overview(result)}{''.join(sections)}{notes}"
        "</body></html>\n"
    )


def _overview(result: RecordDiagnosis) -> str:
    rows = tuple(
        (
            d.channel.name,
            d.verdict.replace("_", " "),
            f"{d.judgement.log_ratio:.4g}",
            f"{d.judgement.unknown_probability:.2g}",
            f"{d.holdout.before.rms:.4g}",
            f"{d.holdout.after.rms:.4g}",
        )
        for d in result.channels
    )
    header = (
        *("", "Verdict", "log evidence of a gap", "Probability of something unknown"),
        *("whitened rms, held-out half, as believed", "with what was missing"),
    )
    return _wide(Table("Channels", header, rows))


def _wide(content: Table) -> str:
    return f'<div class="wide">{table(content)}</div>'


def _section(d: ChannelDiagnosis, index: int, result: RecordDiagnosis) -> str:
    parts = [f"<h2>{html.escape(d.channel.name)}</h2>", paragraph(WORDS[d.verdict]), _causes(d)]
    for svg, text in ((allan_svg(d), "Allan deviation"), (spectrum_svg(d), "Spectrum")):
        parts.append(f'<figure role="img" aria-label="{text}, {d.channel.name}">{svg}</figure>')
    if d.verdict != "no_gap":
        parts.append(_where(d, index, result))
    ceilings = ", ".join(f"{name} {value:.3g}" for name, value in d.ceilings.items())
    believed = ", ".join(f"{name} {value:g}" for name, value in d.belief.stated.items())
    tolerance = f"each within {d.belief.tolerance:.0%} (1 sigma)"
    parts.append(paragraph(f"Believed: {believed}; {tolerance}.", "weak"))
    parts.append(paragraph(f"Whatever else is in the record, at most: {ceilings}.", "weak"))
    return "".join(parts)


def _causes(d: ChannelDiagnosis) -> str:
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
    header = ("", "Level, 95 % interval", "Key", "Probability", "Can't be told from")
    return _wide(Table("Beyond belief", header, rows))


def _where(d: ChannelDiagnosis, index: int, result: RecordDiagnosis) -> str:
    rows = tuple(
        (f"{low:.3g} to {high:.3g}", f"{share:.1%}", SOURCE[coordinate])
        for coordinate, (low, high), share in excess_shares(d, result.shared[index])
    )
    caption = "Where the whitened power is not as promised (first half)"
    return _wide(Table(caption, ("Frequency, Hz", "Share", "Whose"), rows))
