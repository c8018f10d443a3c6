"""Findings and tables as text, with as many decimals as their intervals justify."""

import math
import unicodedata
from collections.abc import Mapping, Sequence

from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.reporting.judgement import judge_findings
from pyhrg.common.pages.markup import Table
from pyhrg.common.pages.svg import format_estimate
from pyhrg.records.table import merge_sources


def format_section(title: str, body: str) -> str:
    """Title, underlined, above the body."""
    return f"{title}\n{'-' * len(title)}\n{body}"


def format_outcome(outcome: Outcome, limits: Mapping[str, float]) -> str:
    """Tables, findings, verdict and notes of one test."""
    tables = [*outcome.tables, make_findings_table(outcome.findings)]
    lines = [format_table(table) + "\n" for table in tables]
    return "\n".join([*lines, outcome.verdict, *list_notes(outcome, limits)])


def list_notes(outcome: Outcome, limits: Mapping[str, float]) -> list[str]:
    """One sentence on each limit of the specification, each warning, and each thing that was left
    out of the records, missing in them or assumed."""
    return [
        *(f"Specification: {judgement}" for judgement in judge_findings(outcome, limits)),
        *(f"Warning: {warning}" for warning in outcome.warnings),
        *(f"Record: {exclusion}" for exclusion in merge_sources(outcome.exclusions)),
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
