"""Content of result.json, written and read."""

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from pyhrg.bench.outcome import UNITS, Finding, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.judgement import judge_findings
from pyhrg.common.arrays import to_json_value
from pyhrg.common.pages.markup import Table
from pyhrg.common.toml_table import TomlTable, read_json_table

SCHEMA = "hrg-bench/1"
LIMITS = ("at_most", "at_least")
"""Keys of a limit: from above, from below."""


def format_document(
    procedure: Procedure,
    outcome: Outcome,
    identity: Mapping[str, Any],
    limits: Mapping[str, float],
) -> str:
    """JSON text of a test's result; each finding is in the unit that its key names.

    The identity says what was tested and by which version; the limits are the specification's, by
    the findings' keys.
    """
    content = {
        "schema": SCHEMA,
        **identity,
        "procedure": procedure.name,
        "source": procedure.source,
        "findings": {
            finding.key: {
                "name": finding.name,
                "unit": finding.unit,
                "value": to_json_value(finding.value),
                "interval_95": to_json_value(finding.interval),
                "n": finding.n,
                "note": finding.note,
            }
            for finding in outcome.findings
        },
        "verdict": outcome.verdict,
        "specification": {
            judgement.finding.key: {
                LIMITS[judgement.finding.at_least]: judgement.limit,
                "verdict": judgement.word,
            }
            for judgement in judge_findings(outcome, limits)
        },
        "tables": [asdict(table) for table in outcome.tables],
        "warnings": list(outcome.warnings),
        "exclusions": list(outcome.exclusions),
        "values_si": to_json_value(outcome.values),
    }
    return json.dumps(content, indent=2, allow_nan=False) + "\n"


def read_document(path: Path) -> tuple[Outcome, dict[str, float]]:
    """The outcome that a result.json states, without its figure and its values for programs, and
    the specification's limits by the findings' keys.

    Raises:
        HrgError: the file can't be read, or a key is missing or of another kind.
    """
    document = read_json_table(path)
    stated = document.table("findings")
    specification = document.table("specification")
    limits = {key: _read_limit(specification.table(key)) for key in specification.values}
    outcome = Outcome(
        findings=tuple(
            _read_finding(stated, key, "at_least" in specification.table(key).values)
            for key in stated.values
        ),
        verdict=document.text("verdict", None),
        tables=tuple(
            Table(
                table.text("title", None),
                table.texts("header"),
                _read_rows(table),
            )
            for table in document.tables("tables")
        ),
        warnings=document.texts("warnings"),
        exclusions=document.texts("exclusions"),
    )
    return outcome, limits


def _read_limit(entry: TomlTable) -> float:
    return entry.finite_number(next((side for side in LIMITS if side in entry.values), LIMITS[0]))


def _read_finding(stated: TomlTable, key: str, at_least: bool) -> Finding:
    entry = stated.table(key)
    unit = entry.text("unit", None, tuple(UNITS))
    low, high = _read_bounds(entry)
    value, low, high = (
        math.nan if number is None else number * UNITS[unit]
        for number in (entry.optional_number("value"), low, high)
    )
    n, note = entry.whole_number("n", None, 0, math.inf), entry.text("note", "")
    finding = Finding(entry.text("name", None), value, unit, low, high, n, note, at_least)
    if finding.key != key:
        raise entry.error("name", finding.name, f"that of {key}")
    return finding


def _read_bounds(entry: TomlTable) -> tuple[float | None, float | None]:
    """Bounds of an interval; null where there is none."""
    bounds = entry.require("interval_95", "[low, high]")
    if not isinstance(bounds, list) or len(bounds) != 2:
        raise entry.error("interval_95", bounds, "[low, high]")
    low, high = (
        replace(entry, values={"interval_95": bound}).optional_number("interval_95")
        for bound in bounds
    )
    return low, high


def _read_rows(table: TomlTable) -> tuple[tuple[str, ...], ...]:
    """Rows of a printed table, each as long as its header."""
    rows = table.require("rows", "a list of rows")
    width = len(table.values["header"])
    for row in rows if isinstance(rows, list) else [rows]:
        if not isinstance(row, list) or [type(cell) for cell in row] != [str] * width:
            raise table.error("rows", row, f"rows of {width} texts")
    return tuple(map(tuple, rows))
