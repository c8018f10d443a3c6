"""Findings and tables as text and as HTML, with as many decimals as their intervals justify;
findings are compared with the limits of a specification. The figures of a page lie in the folders
of the tests.
"""

import difflib
import html
import math
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.common.pages.markup import Table, make_document, make_paragraph, make_wide_table
from pyhrg.common.pages.svg import format_estimate, format_interval


@dataclass(frozen=True)
class Judgement:
    """A finding beside its limit.

    limit: of the finding's magnitude, in the unit that the finding's key names.
    """

    finding: Finding
    limit: float

    @property
    def word(self) -> str:
        """`meets` or `fails` where the whole 95 % interval of the magnitude lies on one side of the
        limit, else `not decided`; `not measured` where the finding has no value."""
        if math.isnan(self.finding.si_value):
            return "not measured"
        low, high = self.finding.interval
        if math.isnan(low + high):
            return "not decided"
        ends = sorted((abs(low), abs(high)))
        low, high = (0.0 if low < 0 < high else ends[0]), ends[1]
        if self.finding.at_least:
            return "meets" if low >= self.limit else "fails" if high < self.limit else "not decided"
        return "meets" if high <= self.limit else "fails" if low > self.limit else "not decided"

    def __str__(self) -> str:
        finding = self.finding
        low, high = finding.interval
        value = format_interval(finding.value, low, high) if low <= high else f"{finding.value:.4g}"
        side = "at least" if finding.at_least else "at most"
        return f"{finding.key} {value}, {side} {self.limit:g}: {self.word}"


def judge_findings(outcome: Outcome, limits: Mapping[str, float]) -> list[Judgement]:
    """A judgement of each finding for whose key the specification has a limit."""
    return [Judgement(f, limits[f.key]) for f in outcome.findings if f.key in limits]


def describe_unmatched_limits(
    outcomes: Iterable[Outcome], limits: Mapping[str, float]
) -> list[str]:
    """A sentence on each limit whose key no finding has."""
    keys = [finding.key for outcome in outcomes for finding in outcome.findings]
    sentences = []
    for key in (key for key in limits if key not in keys):
        close = difflib.get_close_matches(key, keys, n=1)
        hint = f"; the closest is {close[0]}" if close else ""
        sentences.append(f"{key}: not judged, no test gave a figure of that name{hint}")
    return sentences


def format_section(title: str, body: str) -> str:
    """Title, underlined, above the body."""
    return f"{title}\n{'-' * len(title)}\n{body}"


def format_outcome(outcome: Outcome, limits: Mapping[str, float]) -> str:
    """Tables, findings, verdict and notes of one test."""
    tables = [*outcome.tables, make_findings_table(outcome.findings)]
    lines = [format_table(table) + "\n" for table in tables]
    return "\n".join([*lines, outcome.verdict, *list_notes(outcome, limits)])


def list_notes(outcome: Outcome, limits: Mapping[str, float]) -> list[str]:
    """One sentence on each limit of the specification, each warning and each exclusion."""
    return [
        *(f"Specification: {judgement}" for judgement in judge_findings(outcome, limits)),
        *(f"Warning: {warning}" for warning in outcome.warnings),
        *(f"Excluded: {exclusion}" for exclusion in outcome.exclusions),
    ]


def make_findings_table(findings: Sequence[Finding]) -> Table:
    """Findings with their 95 % intervals, in the units that they are shown in."""
    rows = tuple((f.name, *format_finding(f), str(f.n) if f.n else "", f.note) for f in findings)
    return Table("Findings", ("", "value", "95 % interval", "unit", "n", ""), rows)


def format_finding(finding: Finding) -> tuple[str, str, str]:
    """Value, 95 % interval and unit of a finding."""
    unit = finding.unit if finding.unit != "1" else ""
    low, high = finding.interval
    if not (math.isfinite(finding.value + high - low) and high > low):
        value, low_text, high_text = map(_format_number, (finding.value, low, high))
        return value, "-" if math.isnan(low + high) else f"{low_text} to {high_text}", unit
    texts = (text.replace("−", "-") for text in format_estimate(finding.value, low, high))
    value, low_text, high_text = texts
    return value, f"{low_text} to {high_text}", unit


def format_table(table: Table) -> str:
    """A table with aligned columns: the first and the last to the left, the others to the right."""
    cells = [table.header, *table.rows]
    widths = [max(_count_columns(row[i]) for row in cells) for i in range(len(table.header))]
    last = len(widths) - 1

    def line(row: tuple[str, ...]) -> str:
        parts = []
        for i, (cell, width) in enumerate(zip(row, widths, strict=True)):
            gap = " " * (width - _count_columns(cell))
            parts.append(cell + gap if i in (0, last) else gap + cell)
        return "  ".join(parts).rstrip()

    return "\n".join([table.title, *map(line, cells)])


def _count_columns(cell: str) -> int:
    """Columns that a cell takes on a terminal; a Chinese character takes two."""
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in cell)


def _format_number(value: float) -> str:
    if not math.isfinite(value):
        return "-" if math.isnan(value) else str(value)
    return f"{value:.4g}"


STYLE = (
    "img{max-width:100%;background:#fff}.wide table{min-width:0}"
    ".wide td:not(:last-child),.wide th:not(:last-child){white-space:nowrap}"
)


def make_page(
    title: str, overview: Table | None, sections: Sequence[str], notes: Sequence[str]
) -> str:
    """HTML of the whole page: the overview, a section for each test, then notes."""
    parts = [f"<h1>{html.escape(title)}</h1>", make_wide_table(overview) if overview else ""]
    parts += [*sections, *(make_paragraph(note, "weak") for note in notes)]
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
