"""Outcomes as text, JSON and HTML, with their figures and logs."""

import html
import json
import math
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from pyhrg.bench.judgement import Judgement, judged
from pyhrg.bench.outcome import Finding, Outcome, Table
from pyhrg.bench.procedure import Procedure

SCHEMA = "hrg-bench/1"
RESULT, PICTURE, PAGE = "result.json", "figure.png", "report.html"


def text(procedure: Procedure, outcome: Outcome, limits: Mapping[str, float]) -> str:
    """What a person wants to read of one test."""
    lines = [procedure.title, "-" * len(procedure.title)]
    lines += [table_text(table) + "\n" for table in outcome.tables]
    lines.append(table_text(findings_table(outcome.findings)))
    lines += ["", outcome.verdict]
    lines += [f"Specification: {j}" for j in judged(outcome, limits)]
    lines += [f"Can't be seen: {warning}" for warning in outcome.warnings]
    lines += [f"Left out: {exclusion}" for exclusion in outcome.exclusions]
    return "\n".join(lines)


def findings_table(findings: Sequence[Finding]) -> Table:
    """Findings with intervals, in their units."""
    rows = tuple(
        (f.name, _value(f), _interval(f), f.unit if f.unit != "1" else "", _count(f), f.note)
        for f in findings
    )
    return Table("Findings", ("", "value", "95 % interval", "unit", "n", ""), rows)


def table_text(table: Table) -> str:
    """Columns aligned: the first and the last to the left."""
    cells = [table.header, *table.rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(table.header))]
    last = len(widths) - 1

    def line(row: tuple[str, ...]) -> str:
        parts = [
            cell.ljust(width) if i in (0, last) else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        return "  ".join(parts).rstrip()

    return "\n".join([table.title, *map(line, cells)])


def document(procedure: Procedure, outcome: Outcome, seed: int | None) -> dict[str, Any]:
    """Content of result.json: findings in the units that their keys name."""
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "procedure": procedure.name,
        "source": procedure.source,
        "seed": seed,
        "findings": {f.key: _listed(f) for f in outcome.findings},
        "verdict": outcome.verdict,
        "warnings": list(outcome.warnings),
        "exclusions": list(outcome.exclusions),
        "values_si": outcome.values,
    }


def write(procedure: Procedure, outcome: Outcome, seed: int | None, folder: Path) -> None:
    """Write result.json and figure.png into an existing folder."""
    content = json.dumps(document(procedure, outcome, seed), indent=2, allow_nan=False)
    (folder / RESULT).write_text(content + "\n")
    if outcome.draw:
        figure = Figure(figsize=(8, 5), layout="constrained")
        outcome.draw(figure)
        figure.savefig(folder / PICTURE, dpi=120, metadata={"Software": None})


def page(title: str, parts: Sequence[str]) -> str:
    """An HTML page of parts."""
    style = (
        "body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
        "table{border-collapse:collapse;margin:1em 0}td,th{padding:.15em .7em;text-align:right;"
        "border-bottom:1px solid #ddd}td:first-child,th:first-child,td:last-child{text-align:left}"
        "img{max-width:100%}.weak{color:#555}"
    )
    head = f"<!doctype html><html lang=en><meta charset=utf-8><title>{html.escape(title)}</title>"
    return f"{head}<style>{style}</style><h1>{html.escape(title)}</h1>{''.join(parts)}</html>\n"


def section(procedure: Procedure, outcome: Outcome, limits: Mapping[str, float]) -> str:
    """One test as HTML; its figure lies in the folder of its name."""
    parts = [f"<h2>{html.escape(procedure.title)}</h2><p>{html.escape(outcome.verdict)}</p>"]
    parts += [table_html(t) for t in (findings_table(outcome.findings), *outcome.tables)]
    if outcome.draw:
        alt = html.escape(procedure.title)
        parts.append(f'<img src="{procedure.name}/{PICTURE}" alt="{alt}">')
    notes: list[Judgement | str] = list(judged(outcome, limits))
    notes += [f"Can't be seen: {text}" for text in outcome.warnings]
    notes += [f"Left out: {text}" for text in outcome.exclusions]
    parts += [f"<p class=weak>{html.escape(str(note))}</p>" for note in notes]
    parts.append(f"<p class=weak>Method: {html.escape(procedure.source)}.</p>")
    return "".join(parts)


def missing(procedure: Procedure, reason: str) -> str:
    """A test that gave no figures, as HTML."""
    return f"<h2>{html.escape(procedure.title)}</h2><p>{html.escape(reason)}</p>"


def table_html(table: Table) -> str:
    """A table as HTML."""

    def row(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells) + "</tr>"

    rows = [row(table.header, "th"), *(row(cells, "td") for cells in table.rows)]
    return f"<table><caption>{html.escape(table.title)}</caption>{''.join(rows)}</table>"


def _value(finding: Finding) -> str:
    return _number(finding.shown, _decimals(finding))


def _interval(finding: Finding) -> str:
    low, high = finding.interval_shown
    if math.isnan(low) and math.isnan(high):
        return "-"
    return f"{_number(low, _decimals(finding))} to {_number(high, _decimals(finding))}"


def _decimals(finding: Finding) -> int | None:
    """Decimals that show two digits of the interval's width; None where four digits are enough."""
    low, high = finding.interval_shown
    width = high - low
    if not (math.isfinite(width) and width > 0):
        return None
    decimals = 1 - math.floor(math.log10(width))
    return decimals if 0 <= decimals <= 9 and abs(finding.shown) < 1e6 else None


def _number(value: float, decimals: int | None) -> str:
    if not math.isfinite(value):
        return "-" if math.isnan(value) else str(value)
    return f"{value:.4g}" if decimals is None else f"{value:.{decimals}f}"


def _count(finding: Finding) -> str:
    return str(finding.n) if finding.n else ""


def _listed(finding: Finding) -> dict[str, Any]:
    def known(value: float) -> float | None:
        return float(value) if math.isfinite(value) else None

    low, high = finding.interval_shown
    return {
        "value": known(finding.shown),
        "interval_95": [known(low), known(high)],
        "n": finding.n,
        "note": finding.note,
    }
