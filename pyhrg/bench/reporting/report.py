"""Outcomes as text and JSON, with their figures."""

import json
import math
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.judgement import Judgement, judged, unmatched
from pyhrg.common.pages.markup import Table

SCHEMA = "hrg-bench/1"
RESULT, PICTURE = "result.json", "figure.png"


@dataclass(frozen=True)
class Result:
    """A procedure with its outcome, or why there is none."""

    procedure: Procedure
    outcome: Outcome | None
    reason: str = ""


@dataclass(frozen=True)
class Results:
    """What was tested and how, the results, the specification's limits by finding, and, of several
    tests, the table that sums them up."""

    subject: str
    done: Sequence[Result]
    limits: Mapping[str, float]
    overview: Table | None = None

    @property
    def outcomes(self) -> list[Outcome]:
        """Of the tests that gave figures."""
        return [result.outcome for result in self.done if result.outcome]

    @property
    def unmatched(self) -> list[str]:
        """On limits that nothing was held to; a single test leaves those of others alone."""
        return unmatched(self.outcomes, self.limits) if len(self.done) > 1 else []


def text(results: Results) -> str:
    """What a person wants to read."""
    sections = [f"HRG bench: {results.subject}"]
    for result in results.done:
        title = result.procedure.title
        body = _text(result.outcome, results.limits) if result.outcome else result.reason
        sections.append(f"{title}\n{'-' * len(title)}\n{body}")
    if results.overview:
        sections.append(table_text(results.overview))
    sections += [f"Specification: {sentence}" for sentence in results.unmatched]
    return "\n\n".join(sections)


def _text(outcome: Outcome, limits: Mapping[str, float]) -> str:
    tables = [*outcome.tables, findings_table(outcome.findings)]
    lines = [table_text(table) + "\n" for table in tables]
    return "\n".join([*lines, outcome.verdict, *notes(outcome, limits)])


def notes(outcome: Outcome, limits: Mapping[str, float]) -> list[str]:
    """The specification, what can't be seen, what was left out; a sentence each."""
    return [
        *(f"Specification: {judgement}" for judgement in judged(outcome, limits)),
        *(f"Can't be seen: {warning}" for warning in outcome.warnings),
        *(f"Left out: {exclusion}" for exclusion in outcome.exclusions),
    ]


def findings_table(findings: Sequence[Finding]) -> Table:
    """Findings with intervals, in their units."""
    rows = tuple((f.name, *shown(f), _count(f), f.note) for f in findings)
    return Table("Findings", ("", "value", "95 % interval", "unit", "n", ""), rows)


def shown(finding: Finding) -> tuple[str, str, str]:
    """Value, interval and unit, to be read."""
    unit = finding.unit if finding.unit != "1" else ""
    return _number(finding.shown, _decimals(finding)), _interval(finding), unit


def table_text(table: Table) -> str:
    """Columns aligned: the first and the last to the left."""
    cells = [table.header, *table.rows]
    widths = [max(_width(row[i]) for row in cells) for i in range(len(table.header))]
    last = len(widths) - 1

    def line(row: tuple[str, ...]) -> str:
        gaps = [" " * (width - _width(cell)) for cell, width in zip(row, widths, strict=True)]
        parts = [
            cell + gap if i in (0, last) else gap + cell
            for i, (cell, gap) in enumerate(zip(row, gaps, strict=True))
        ]
        return "  ".join(parts).rstrip()

    return "\n".join([table.title, *map(line, cells)])


def _width(cell: str) -> int:
    """Columns of a terminal: Chinese characters take two."""
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in cell)


def document(
    procedure: Procedure, outcome: Outcome, seed: int | None, limits: Mapping[str, float]
) -> dict[str, Any]:
    """Content of result.json: findings in the units that their keys name."""
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "procedure": procedure.name,
        "source": procedure.source,
        "seed": seed,
        "findings": {f.key: _finding(f) for f in outcome.findings},
        "verdict": outcome.verdict,
        "specification": {j.finding.key: _judgement(j) for j in judged(outcome, limits)},
        "warnings": list(outcome.warnings),
        "exclusions": list(outcome.exclusions),
        "values_si": _plain(outcome.values),
    }


def write(
    procedure: Procedure,
    outcome: Outcome,
    seed: int | None,
    limits: Mapping[str, float],
    folder: Path,
) -> None:
    """Write result.json and figure.png into an existing folder."""
    content = document(procedure, outcome, seed, limits)
    (folder / RESULT).write_text(json.dumps(content, indent=2, allow_nan=False) + "\n")
    if outcome.draw:
        figure = Figure(figsize=(8, 5), layout="constrained")
        outcome.draw(figure)
        figure.savefig(folder / PICTURE, dpi=120, metadata={"Software": None})


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


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "value": _plain(finding.shown),
        "interval_95": _plain(finding.interval_shown),
        "n": finding.n,
        "note": finding.note,
    }


def _judgement(judgement: Judgement) -> dict[str, Any]:
    side = "at_least" if judgement.finding.at_least else "at_most"
    return {side: judgement.limit, "verdict": judgement.word}


def _plain(value: Any) -> Any:
    """As JSON has it: no arrays, and null for what is no finite number."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return _plain(value.tolist())
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
