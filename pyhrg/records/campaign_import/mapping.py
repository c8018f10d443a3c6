"""A mapping: the TOML file that states columns and units of a laboratory's logs."""

from dataclasses import dataclass
from pathlib import Path

from pyhrg.common.site import Site
from pyhrg.common.toml_table import TomlTable, read_table
from pyhrg.device.device_file import from_table
from pyhrg.records.campaign import FILE_NAME, ROLES, read_site, read_tolerances
from pyhrg.records.campaign_import.column_mapping import BY_STEM, ColumnMapping, read_columns
from pyhrg.records.campaign_import.layout import Layout, read_layout
from pyhrg.records.timing import INTERVAL_RANGE

REQUIRED_NOMINAL = ("coriolis_factor", "decay_time_s", "frequency_Hz")
"""Nominal values that a mapping must state: without them nothing can be simulated."""

KEYS = ("device", "site", "nominal", "tolerances", "rows_s", "layout", "columns", "tests")
"""Keys of a mapping."""


@dataclass(frozen=True)
class TestMapping:
    """The mapping of one test.

    id: name of the test, a file name.
    kind: of the test (docs/records.md).
    role: `fit` or `holdout`.
    file: the laboratory's log.
    interval: sampling interval, s; the median time step if None.
    rows: length of the campaign's rows, s; as logged if None.
    layout: of the file.
    columns: by field of `Log`.
    """

    __test__ = False  # not one of pytest's

    id: str
    kind: str
    role: str
    file: Path
    interval: float | None
    rows: float | None
    layout: Layout
    columns: dict[str, ColumnMapping]


@dataclass(frozen=True)
class CampaignMapping:
    """The mapping of all tests of one gyro. source: its file; nominal, tolerances: by keys of a
    device file."""

    source: str
    device: str
    site: Site
    nominal: dict[str, float]
    tolerances: dict[str, float]
    tests: tuple[TestMapping, ...]


def read_mapping(path: Path) -> CampaignMapping:
    """Read a mapping (docs/import.md); the files that it names are beside it."""
    top = read_table(path)
    top.check_known(
        ("device", "site", "nominal", "tolerances", "rows_s", "layout", "columns", "tests")
    )
    tests = tuple(_read_test(entry, top, path.parent) for entry in top.tables("tests"))
    if not tests:
        raise top.missing("tests", "[[tests]], one a log")
    ids = [test.id for test in tests]
    for i, name in enumerate(ids):
        if not FILE_NAME.fullmatch(name) or ids.count(name) > 1:
            raise top.error(f"tests[{i}].id", name, "a file name, each once")
    device = top.require("device", "the gyro's name")
    if not isinstance(device, str) or not device:
        raise top.error("device", device, "the gyro's name")
    top.table("site").check_known(("latitude_deg", "gravity_m_s2"))
    stated = _read_nominal(top), read_tolerances(top)
    return CampaignMapping(str(path), device, read_site(top), *stated, tests)


def _read_nominal(top: TomlTable) -> dict[str, float]:
    """Nominal values by key, each known to a device and in its range."""
    table = top.table("nominal")
    for key in REQUIRED_NOMINAL:
        table.require(key, "it: the gyro can't be simulated without")
    values = {key: table.finite_number(key) for key in table.values}
    from_table(values, f"{top.source}: nominal")
    return values


def _read_test(entry: TomlTable, top: TomlTable, folder: Path) -> TestMapping:
    entry.check_known(
        ("id", "kind", "role", "file", "interval_s", "rows_s", "layout", "columns", "absent")
    )
    general, own = top.table("layout"), entry.table("layout")
    layout = TomlTable(
        top.source,
        own.prefix if own.values else general.prefix,
        {**general.values, **own.values},
    )
    absent = entry.values.get("absent", [])
    if not isinstance(absent, list) or not all(stem in BY_STEM for stem in absent):
        raise entry.error("absent", absent, f"some of {', '.join(BY_STEM)}, in brackets")
    columns = read_columns(top.table("columns")) | read_columns(entry.table("columns"))
    return TestMapping(
        id=entry.text("id", None),
        kind=entry.text("kind", None),
        role=entry.text("role", None, ROLES),
        file=folder / entry.text("file", None),
        interval=_read_duration(entry, "interval_s"),
        rows=_read_duration(entry, "rows_s") or _read_duration(top, "rows_s"),
        layout=read_layout(layout),
        columns={f: mapping for f, mapping in columns.items() if mapping.column.stem not in absent},
    )


def _read_duration(table: TomlTable, key: str) -> float | None:
    """A duration, s; None where it isn't stated."""
    return table.number(key, None, *INTERVAL_RANGE) if key in table.values else None
