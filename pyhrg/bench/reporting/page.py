"""The report of a run as one HTML page; its figures lie in the folders of the tests."""

import html
from collections.abc import Mapping, Sequence

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.text import list_notes, make_findings_table
from pyhrg.common.pages.markup import Table, make_document, make_paragraph, make_wide_table

STYLE = (
    "img{max-width:100%;background:#fff}.wide table{min-width:0}"
    ".wide td:not(:last-child),.wide th:not(:last-child){white-space:nowrap}"
    ".wide td:nth-child(6){min-width:14rem}"
)


def make_page(
    title: str, overview: Table | None, sections: Sequence[str], notes: Sequence[str]
) -> str:
    """HTML of the whole page: a section for each test, the overview, then notes."""
    parts = [f"<h1>{html.escape(title)}</h1>", *sections]
    parts.append(make_wide_table(overview) if overview else "")
    parts += [make_paragraph(note, "weak") for note in notes]
    return make_document(title, STYLE, "".join(parts), "", images=True)


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
    parts += [make_wide_table(content) for content in tables]
    if picture:
        alternative = html.escape(f"Figure: {procedure.title}. {outcome.verdict}")
        parts.append(f'<img src="{picture}" alt="{alternative}">')
    parts += [make_paragraph(note, "weak") for note in list_notes(outcome, limits)]
    parts.append(make_paragraph(f"Method: {procedure.source}.", "weak"))
    return "".join(parts)
