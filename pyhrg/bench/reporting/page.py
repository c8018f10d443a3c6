"""The report of a run as one HTML page; figures lie in the tests' folders."""

import html
from collections.abc import Mapping, Sequence

from pyhrg.bench.outcome import Outcome, Table
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.report import PICTURE, Results, findings_table, notes

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
    parts = [_table(results.overview)] if results.overview else []
    for result in results.done:
        parts.append(f"<h2>{html.escape(result.procedure.title)}</h2>")
        if result.outcome:
            parts.append(_section(result.procedure, result.outcome, results.limits))
        else:
            parts.append(_paragraph(f"No figures: {result.reason}"))
    parts += [_paragraph(f"Specification: {text}", "weak") for text in results.unmatched]
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        f"<title>{title}</title><style>{STYLE}</style></head>"
        f"<body><h1>{title}</h1>{''.join(parts)}</body></html>\n"
    )


def _section(procedure: Procedure, outcome: Outcome, limits: Mapping[str, float]) -> str:
    parts = [_paragraph(outcome.verdict)]
    parts += [_table(table) for table in (findings_table(outcome.findings), *outcome.tables)]
    if outcome.draw:
        alternative = html.escape(f"Figure: {procedure.title}. {outcome.verdict}")
        parts.append(f'<img src="{procedure.name}/{PICTURE}" alt="{alternative}">')
    parts += [_paragraph(note, "weak") for note in notes(outcome, limits)]
    parts.append(_paragraph(f"Method: {procedure.source}.", "weak"))
    return "".join(parts)


def _paragraph(text: str, style: str = "") -> str:
    opening = f'<p class="{style}">' if style else "<p>"
    return f"{opening}{html.escape(text)}</p>"


def _table(table: Table) -> str:
    rows = [_row(table.header, "th"), *(_row(cells, "td") for cells in table.rows)]
    return f"<table><caption>{html.escape(table.title)}</caption>{''.join(rows)}</table>"


def _row(cells: Sequence[str], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"
