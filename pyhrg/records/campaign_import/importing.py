"""A mapping and its logs, made a campaign."""

from dataclasses import dataclass, replace

import numpy as np

from pyhrg.records import COLUMNS, Log
from pyhrg.records.campaign import Campaign, Test
from pyhrg.records.campaign_import.conversion import quantity, times
from pyhrg.records.campaign_import.joining import joined
from pyhrg.records.campaign_import.layout import read_cells
from pyhrg.records.campaign_import.mapping import CampaignMapping, TestMapping
from pyhrg.records.log import checked
from pyhrg.records.table import Array, Table, check_range
from pyhrg.records.timing import interval_of, ordered


@dataclass(frozen=True)
class ImportedTest:
    """A test as it was logged, and how it will be read."""

    mapping: TestMapping
    logged: Log
    """Every row, or longer ones where they are asked for; this is what is written."""
    read: Log
    """What a reader of the campaign keeps, and why not the rest: rows are those of the lab's file.
    """


@dataclass(frozen=True)
class Imported:
    """All tests of a mapping."""

    mapping: CampaignMapping
    tests: tuple[ImportedTest, ...]

    @property
    def campaign(self) -> Campaign:
        """As it is written."""
        tests = tuple(
            Test(test.mapping.id, test.mapping.kind, test.mapping.role, test.logged)
            for test in self.tests
        )
        return Campaign(self.mapping.device, self.mapping.site, self.mapping.nominal, tests)


def imported(mapping: CampaignMapping) -> Imported:
    """Read a lab's logs; nothing is mended or left out, and resampled only where `rows_s` asks it.

    Raises:
        LogError: a file, column or cell that isn't as the mapping says; what `records.read`
            refuses. Rows are the lines of the lab's file.
    """
    return Imported(mapping, tuple(_test(test, mapping) for test in mapping.tests))


def _test(test: TestMapping, mapping: CampaignMapping) -> ImportedTest:
    cells = read_cells(test.file, test.layout)
    time = times(test.columns.get("time"), cells, test.interval)
    empty = np.full(len(time), np.nan)
    columns: dict[str, Array] = {column.field: empty for column in COLUMNS} | {"time": time}
    interval = _interval(Table(cells.source, cells.rows, columns), test.interval)
    for field, logged in test.columns.items():
        if field != "time":
            columns[field] = quantity(logged, cells, time, interval)
    for column in COLUMNS:
        written = (columns[column.field] - column.offset) / column.factor
        check_range(cells.source, column, cells.rows, written)
    table = Table(cells.source, cells.rows, columns, _notes(test))
    read = checked(table, interval, mapping.site.latitude)
    if test.rows is not None:
        read = joined(read, test.rows)
        return ImportedTest(test, replace(read, exclusions=()), read)
    return ImportedTest(test, Log(cells.source, interval, exclusions=(), **columns), read)


def _interval(table: Table, stated: float | None) -> float:
    """As stated, else the median time step without the rounding of its times, s."""
    return float(f"{interval_of(ordered(table), stated):.9g}")


def _notes(test: TestMapping) -> tuple[str, ...]:
    missing = [c for c in COLUMNS if c.field not in test.columns and not c.optional]
    counted = "time_s: rows counted from interval_s, so that a missing row can't be seen"
    return tuple(
        counted if column.field == "time" else f"no column {column.name}" for column in missing
    )
