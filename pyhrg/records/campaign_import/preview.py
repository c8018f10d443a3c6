"""What an import understood, in words, for a laboratory to check."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.device.device_file import NOMINAL
from pyhrg.records.campaign_import.column_mapping import ColumnMapping
from pyhrg.records.campaign_import.mapping import CampaignMapping, TestMapping
from pyhrg.records.columns import BY_FIELD
from pyhrg.records.log import Log
from pyhrg.records.table import fold_absent_columns


@dataclass(frozen=True)
class ImportedTest:
    """A test as it was logged, and as a reader of the campaign will get it.

    logged: every row, or longer rows where the mapping asks for them; this is what is written;
    read: what a reader keeps; its exclusions name rows by the lines of the laboratory's file.
    """

    mapping: TestMapping
    logged: Log
    read: Log


def describe_tests(mapping: CampaignMapping, tests: Sequence[ImportedTest]) -> str:
    """Tests with rows, columns, ranges in SI units, and what a reader leaves out."""
    site = mapping.site
    stated = [f"{key} {value:g}" for key, value in mapping.nominal.items()]
    lines = [
        f"{mapping.device}: {len(tests)} tests",
        f"site: latitude_deg {site.latitude_deg:g}, gravity_m_s2 {site.gravity:g}",
        f"nominal: {', '.join(stated)}",
    ]
    if mapping.tolerances:
        own = [f"{key} {value:g}" for key, value in mapping.tolerances.items()]
        lines.append(f"tolerances: {', '.join(own)}")
    unstated = [key for key in NOMINAL if key not in mapping.nominal]
    if unstated:
        lines.append(f"nominal: not stated, so as in any ideal gyro: {', '.join(unstated)}")
    for test in tests:
        lines += ["", *_describe_test(test)]
    return "\n".join(lines)


def _describe_test(test: ImportedTest) -> list[str]:
    log, mapping = test.logged, test.mapping
    steps = np.diff(log.time[np.isfinite(log.time)])
    lines = [
        f"{mapping.id}: {mapping.kind}, {mapping.role}; {log.source}",
        f"  {len(log.time)} rows every {log.interval:g} s, "
        f"steps of {np.min(steps):.6g} to {np.max(steps):.6g} s",
    ]
    if "time" not in mapping.columns:
        lines.append("  time               counted")
    by_field = sorted(mapping.columns.items(), key=lambda item: list(BY_FIELD).index(item[0]))
    lines += [_describe_column(column, log) for _, column in by_field]
    return [*lines, *(f"  note: {note}" for note in fold_absent_columns(test.read.exclusions))]


def _describe_column(mapping: ColumnMapping, log: Log) -> str:
    column = mapping.column
    values = getattr(log, column.field)
    known = values[np.isfinite(values)]
    if mapping.logged is None:
        origin = f"constant {mapping.constant:g}"
    else:
        treatment = f", {mapping.integrate} added up" if mapping.integrate else ""
        treatment += ", unwrapped" if mapping.wraps_every else ""
        origin = f"column {mapping.logged}{treatment}"
    unit = mapping.unit_name or mapping.time_format
    logged = f"{origin} [{unit}]" if unit and unit != "1" else origin
    ends = dict.fromkeys([f"{np.min(known):.6g}", f"{np.max(known):.6g}"] if len(known) else [])
    value_range = " to ".join(ends) or "no value"
    missing = f", {len(values) - len(known)} missing" if len(known) < len(values) else ""
    si_unit = column.si_unit
    return f"  {column.stem:<18} {logged:<42} {value_range} {si_unit}".rstrip() + missing
