"""The report of a run as one HTML page; its figures lie in the folders of the tests."""

import html
from collections.abc import Mapping, Sequence

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.text import list_notes, make_findings_table
from pyhrg.common.pages.markup import Table, make_paragraph, make_table

STYLE = (
    "body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0;font-variant-numeric:tabular-nums}"
    "caption{text-align:left}td,th{padding:.15em .7em;text-align:right;"
    "border-bottom:1px solid #ddd}td:first-child,th:first-child,td:last-child{text-align:left}"
    "img{max-width:100%}.weak{color:#555}"
)


def make_page(
    title: str, overview: Table | None, sections: Sequence[str], notes: Sequence[str]
) -> str:
    """HTML of the whole page: the overview, a section for each test, then notes."""
    title = html.escape(title)
    parts = [make_table(overview)] if overview else []
    parts += [*sections, *(make_paragraph(note, "weak") for note in notes)]
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        f"<title>{title}</title><style>{STYLE}</style></head>"
        f"<body><h1>{title}</h1>{''.join(parts)}</body></html>\n"
    )


def make_failure_section(procedure: Procedure, reason: str) -> str:
    """HTML section of a test that gave no figures."""
    return f"<h2>{html.escape(procedure.title)}</h2>{make_paragraph(f'No figures: {reason}')}"


def make_section(
    procedure: Procedure, outcome: Outcome, limits: Mapping[str, float], picture: str
) -> str:
    """HTML section of a test: verdict, tables, figure, notes, method.

    The limits are the specification's, by the findings' keys; `picture` is the figure's path from
    the page's folder, empty where the test has none.
    """
    parts = [f"<h2>{html.escape(procedure.title)}</h2>", make_paragraph(outcome.verdict)]
    tables = (make_findings_table(outcome.findings), *outcome.tables)
    parts += [make_table(content) for content in tables]
    if picture:
        alternative = html.escape(f"Figure: {procedure.title}. {outcome.verdict}")
        parts.append(f'<img src="{picture}" alt="{alternative}">')
    parts += [make_paragraph(note, "weak") for note in list_notes(outcome, limits)]
    parts.append(make_paragraph(f"Method: {procedure.source}.", "weak"))
    return "".join(parts)
