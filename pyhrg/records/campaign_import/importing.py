"""From a mapping and its logs to a campaign, and what the import understood, in words, for a
laboratory to check.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import replace_folder
from pyhrg.device.device_file import NOMINAL
from pyhrg.records.campaign import Campaign, Test, write_campaign
from pyhrg.records.campaign_import.column_mapping import ColumnMapping
from pyhrg.records.campaign_import.conversion import convert_column, join_rows, read_times
from pyhrg.records.campaign_import.layout import read_cells
from pyhrg.records.campaign_import.mapping import CampaignMapping, TestMapping, read_mapping
from pyhrg.records.columns import BY_FIELD, COLUMNS
from pyhrg.records.log import Log, build_log
from pyhrg.records.table import Table, check_range, fold_absent_columns
from pyhrg.records.timing import drop_wrong_rows, find_interval


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
    lines = [f"{mapping.device}: {len(tests)} tests"]
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


@dataclass(frozen=True)
class ImportedCampaign:
    """All tests of a mapping, as they were logged and as they will be read."""

    mapping: CampaignMapping
    tests: tuple[ImportedTest, ...]

    __repr__ = describe_briefly

    @property
    def campaign(self) -> Campaign:
        """The campaign as it is written."""
        return self._make_campaign([test.logged for test in self.tests])

    @property
    def campaign_as_read(self) -> Campaign:
        """The campaign as a reader of it gets it, without the notes that `preview` has."""
        return self._make_campaign([replace(test.read, exclusions=()) for test in self.tests])

    @property
    def preview(self) -> str:
        """Tests with rows, columns, ranges in SI units, and what a reader leaves out."""
        return describe_tests(self.mapping, self.tests)

    def _make_campaign(self, logs: list[Log]) -> Campaign:
        pairs = ((test.mapping, log) for test, log in zip(self.tests, logs, strict=True))
        tests = tuple(Test(m.id, m.kind, m.role, log) for m, log in pairs)
        return Campaign(self.mapping.device, self.mapping.site, self.mapping.nominal, tests)


def import_campaign(mapping: Path | str, out: Path | str | None = None) -> ImportedCampaign:
    """Read a laboratory's logs as a campaign (docs/import.md); `preview` shows what was understood.

    No value is changed and no row left out. Rows are joined to longer ones only where the mapping's
    `rows_s` asks for it.

    Args:
        mapping: the TOML file that states columns and units.
        out: folder to write the campaign to; not there yet, or empty. None: nothing is written.

    Raises:
        HrgError: the mapping can't be used; a file, column or cell is not as it says, or `read_log`
            would refuse the log; there is something in `out`. Rows are named by the lines of the
            laboratory's file.
        OSError: `out` can't be written.
    """
    place = None if out is None else Path(out)
    if place and place.exists() and (place.is_file() or any(place.iterdir())):
        raise HrgError(f"can't write {out}: found something there, expected nothing yet")
    logs = read_mapping(Path(mapping))
    imported = ImportedCampaign(logs, tuple(_import_test(test, logs) for test in logs.tests))
    if place:
        with replace_folder(place) as aside:
            write_campaign(imported.campaign, aside)
    return imported


def _import_test(test: TestMapping, mapping: CampaignMapping) -> ImportedTest:
    cells = read_cells(test.file, test.layout)
    time = read_times(test.columns.get("time"), cells, test.interval)
    empty = np.full(len(time), np.nan)
    columns: dict[str, Array] = {column.field: empty for column in COLUMNS} | {"time": time}
    timed = drop_wrong_rows(Table(cells.source, cells.rows, columns))
    # a median time step is written without the rounding of its times
    interval = float(f"{find_interval(timed, test.interval):.9g}")
    for field, column_mapping in test.columns.items():
        if field != "time":
            columns[field] = convert_column(column_mapping, cells, time, interval)
    for column in COLUMNS:
        values = (columns[column.field] - column.offset) / column.factor
        check_range(cells.source, column, cells.rows, values)
    table = Table(cells.source, cells.rows, columns, _describe_missing(test))
    read = build_log(table, interval, mapping.site.latitude)
    if test.rows is not None:
        read = join_rows(read, test.rows)
        return ImportedTest(test, replace(read, exclusions=()), read)
    return ImportedTest(test, Log(cells.source, interval, exclusions=(), **columns), read)


def _describe_missing(test: TestMapping) -> tuple[str, ...]:
    """A sentence on each column that the mapping lacks."""
    missing = [c for c in COLUMNS if c.field not in test.columns and not c.optional]
    counted = "time_s: rows counted from interval_s, so that a missing row can't be seen"
    return tuple(
        counted if column.field == "time" else f"no column {column.name}" for column in missing
    )
