"""The report of a run as one HTML page; figures lie in the tests' folders."""

import html
from collections.abc import Mapping

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.report import PICTURE, Results, findings_table, notes
from pyhrg.common.pages.markup import paragraph, table

PAGE = "report.html"
STYLE = (
    "body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0;font-variant-numeric:tabular-nums}"
    "caption{text-align:left}td,th{padding:.15em .7em;text-align:right;"
    "border-bottom:1px solid #ddd}td:first-child,th:first-child,td:last-child{text-align:left}"
    "img{max-width:100%}.weak{color:#555}"
)


def page(results: Results) -> str:
    """All results."""
    title = html.escape(f"HRG bench: {results.subject}")
    parts = [table(results.overview)] if results.overview else []
    for result in results.done:
        parts.append(f"<h2>{html.escape(result.procedure.title)}</h2>")
        if result.outcome:
            parts.append(_section(result.procedure, result.outcome, results.limits))
        else:
            parts.append(paragraph(f"No figures: {result.reason}"))
    parts += [paragraph(f"Specification: {text}", "weak") for text in results.unmatched]
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        f"<title>{title}</title><style>{STYLE}</style></head>"
        f"<body><h1>{title}</h1>{''.join(parts)}</body></html>\n"
    )


def _section(procedure: Procedure, outcome: Outcome, limits: Mapping[str, float]) -> str:
    parts = [paragraph(outcome.verdict)]
    parts += [table(content) for content in (findings_table(outcome.findings), *outcome.tables)]
    if outcome.draw:
        alternative = html.escape(f"Figure: {procedure.title}. {outcome.verdict}")
        parts.append(f'<img src="{procedure.name}/{PICTURE}" alt="{alternative}">')
    parts += [paragraph(note, "weak") for note in notes(outcome, limits)]
    parts.append(paragraph(f"Method: {procedure.source}.", "weak"))
    return "".join(parts)
