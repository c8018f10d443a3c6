"""What an import understood, in words, for a lab to check."""

from collections.abc import Sequence

import numpy as np

from pyhrg.device.device_file import NOMINAL
from pyhrg.records.campaign_import.column_mapping import ColumnMapping
from pyhrg.records.campaign_import.importing import Imported, ImportedTest
from pyhrg.records.columns import BY_FIELD
from pyhrg.records.log import Log

SI_UNITS = {
    "s": "s",
    "deg": "rad",
    "rad": "rad",
    "deg_s": "rad/s",
    "m_s2": "m/s2",
    "degC": "K",
    "per_s": "1/s",
    "Hz": "rad/s",
    "": "",
}
"""By a column's unit in a campaign."""


ABSENT = "no column "


def preview(found: Imported) -> str:
    """Tests with rows, columns, ranges in SI units, and what a reader leaves out."""
    mapping = found.mapping
    lines = [f"{mapping.device}: {len(found.tests)} tests"]
    unstated = [key for key in NOMINAL if key not in mapping.nominal]
    if unstated:
        lines.append(f"nominal: not stated, so as in any ideal gyro: {', '.join(unstated)}")
    for test in found.tests:
        lines += ["", *_lines(test)]
    return "\n".join(lines)


def _lines(test: ImportedTest) -> list[str]:
    log, mapping = test.logged, test.mapping
    lines = [
        f"{mapping.id}: {mapping.kind}, {mapping.role}; {log.source}",
        f"  {len(log.time)} rows every {log.interval:g} s, {_steps(log)}",
    ]
    if "time" not in mapping.columns:
        lines.append("  time               counted")
    by_field = sorted(mapping.columns.items(), key=lambda item: list(BY_FIELD).index(item[0]))
    lines += [_column(column, log) for _, column in by_field]
    return [*lines, *(f"  note: {note}" for note in _notes(test.read.exclusions))]


def _notes(exclusions: Sequence[str]) -> list[str]:
    """With the columns that are not there in one sentence."""
    absent = [note.removeprefix(ABSENT) for note in exclusions if note.startswith(ABSENT)]
    others = [note for note in exclusions if not note.startswith(ABSENT)]
    return [ABSENT + ", ".join(absent), *others] if absent else others


def _steps(log: Log) -> str:
    steps = np.diff(log.time[np.isfinite(log.time)])
    return f"steps of {np.min(steps):.6g} to {np.max(steps):.6g} s"


def _column(mapping: ColumnMapping, log: Log) -> str:
    column = mapping.column
    values = getattr(log, column.field)
    known = values[np.isfinite(values)]
    if mapping.logged is None:
        origin = f"constant {mapping.constant:g}"
    else:
        done = f", {mapping.integrate} added up" if mapping.integrate else ""
        done += ", unwrapped" if mapping.wraps_every else ""
        origin = f"column {mapping.logged}{done}"
    unit = mapping.unit_name or mapping.time_format
    logged = f"{origin} [{unit}]" if unit and unit != "1" else origin
    ends = dict.fromkeys([f"{np.min(known):.6g}", f"{np.max(known):.6g}"] if len(known) else [])
    shown = " to ".join(ends) or "no value"
    lost = f", {len(values) - len(known)} missing" if len(known) < len(values) else ""
    si_unit = SI_UNITS[column.unit]
    return f"  {column.stem:<18} {logged:<42} {shown} {si_unit}".rstrip() + lost
