"""From a mapping and its logs to a campaign."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import replace_folder
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records.campaign import INDEX, Campaign, Test, write_campaign
from pyhrg.records.campaign_import.conversion import convert_column, read_times
from pyhrg.records.campaign_import.joining import join_rows
from pyhrg.records.campaign_import.layout import read_cells
from pyhrg.records.campaign_import.mapping import CampaignMapping, TestMapping, read_mapping
from pyhrg.records.campaign_import.preview import ImportedTest, describe_tests
from pyhrg.records.columns import COLUMNS
from pyhrg.records.log import Log, build_log
from pyhrg.records.missing_inputs import TURNING_RATE
from pyhrg.records.table import Table, check_range
from pyhrg.records.timing import drop_wrong_rows, find_interval


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
        return Campaign(
            self.mapping.device,
            self.mapping.site,
            self.mapping.nominal,
            tests,
            self.mapping.tolerances,
        )


def import_campaign(
    mapping: Path | str, out: Path | str | None = None, *, force: bool = False
) -> ImportedCampaign:
    """Read a laboratory's logs as a campaign (docs/import.md); `preview` shows what was understood.

    No value is changed and no row left out. Rows are joined to longer ones only where the mapping's
    `rows_s` asks for it.

    Args:
        mapping: the TOML file that states columns and units.
        out: folder to write the campaign to; not there yet, or empty. None: nothing is written.
        force: whether a campaign in `out` may be replaced.

    Raises:
        HrgError: the mapping can't be used; a file, column or cell is not as it says, or `read_log`
            would refuse the log; there is something in `out` that may not be replaced. Rows are
            named by the lines of the laboratory's file.
        OSError: `out` can't be written.
    """
    place = None if out is None else Path(out)
    if place:
        _check_place(place, force)
    logs = read_mapping(Path(mapping))
    imported = ImportedCampaign(logs, tuple(_import_test(test, logs) for test in logs.tests))
    if place:
        with replace_folder(place) as aside:
            write_campaign(imported.campaign, aside)
    return imported


def _check_place(out: Path, force: bool) -> None:
    """Refuse to replace what is there, with `force` what is not a campaign alone."""
    if out.exists() and not out.is_dir():
        raise HrgError(f"can't write {out}: found a file, expected a folder")
    names = sorted(path.name for path in out.iterdir()) if out.exists() else []
    others = [name for name in names if name != INDEX and not name.endswith(".csv.gz")]
    if others or (names and INDEX not in names):
        found = f"found {(others or names)[0]}, which is no part of a campaign"
        raise HrgError(f"can't write {out}: {found}; choose another folder")
    if names and not force:
        raise HrgError(
            f"can't write {out}: found a campaign there; choose another folder, or replace it with "
            "--force (in Python force=True)"
        )


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
    origin = _align_origin(test, columns, mapping.site)
    for column in COLUMNS:
        values = (columns[column.field] - column.offset) / column.factor
        check_range(cells.source, column, cells.rows, values)
    table = Table(cells.source, cells.rows, columns, (*_describe_missing(test), *origin))
    read = build_log(table, interval, mapping.site.latitude)
    if test.rows is not None:
        read = join_rows(read, test.rows)
        joined: dict[str, Any] = {c.field: getattr(read, c.field) for c in COLUMNS}
        _align_origin(test, joined, mapping.site)
        read = replace(read, **joined)
        return ImportedTest(test, replace(read, exclusions=()), read)
    return ImportedTest(test, Log(cells.source, interval, exclusions=(), **columns), read)


def _align_origin(test: TestMapping, columns: dict[str, Array], site: Site) -> list[str]:
    """Let an output angle that counts from zero begin with what table and Earth turned until the
    first row. Of one that begins elsewhere than a table that counts from zero, return a sentence:
    a diagnosis reads their difference as a step.
    """
    gyro, table = (test.columns.get(field) for field in ("gyro_angle", "table_angle"))
    angle, inputs = columns["gyro_angle"], np.nan_to_num(columns["table_angle"])
    known = np.flatnonzero(np.isfinite(angle + columns["time"]))
    if not gyro or not len(known):
        return []
    first = known[0]
    time = float(columns["time"][first])
    up = float(np.nan_to_num(columns["axis_up"][first]))
    turn = float(inputs[first] + site.compute_earth_rate(up) * time)
    if gyro.from_zero:
        columns["gyro_angle"] = angle - angle[first] + turn
        return []
    beside = float(angle[first]) - turn
    if not (table and table.from_zero and abs(beside) > TURNING_RATE * time):
        return []
    return [
        f"gyro_angle begins {beside / DEG:.6g} deg beside table_angle, which counts from zero: let "
        "both count from zero, or neither"
    ]


def _describe_missing(test: TestMapping) -> tuple[str, ...]:
    """A sentence on each column that the mapping lacks."""
    missing = [c for c in COLUMNS if c.field not in test.columns and not c.optional]
    counted = "time_s: rows counted from interval_s, so that a missing row can't be seen"
    return tuple(
        counted if column.field == "time" else f"no column {column.name}" for column in missing
    )
