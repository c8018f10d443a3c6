"""A mapping: the TOML file that says what a lab's logs are."""

from dataclasses import dataclass
from pathlib import Path

from pyhrg.common.files import toml_of
from pyhrg.common.toml_table import SpecificationError, TomlTable
from pyhrg.common.units import DEG
from pyhrg.device.device_file import DeviceError, from_table
from pyhrg.records.campaign import FILE_NAME, GRAVITY, ROLES, Site
from pyhrg.records.campaign_import.column_mapping import BY_STEM, ColumnMapping, read_columns
from pyhrg.records.campaign_import.layout import Layout, read_layout

NEEDED = ("coriolis_factor", "decay_time_s", "frequency_Hz")
"""Of a gyro's nominal values: without them nothing can be simulated."""
SHORTEST, LONGEST = 1e-6, 1e6
"""Sampling intervals, s."""


@dataclass(frozen=True)
class TestMapping:
    """One test: its file, and its columns by the campaign's field."""

    __test__ = False  # not one of pytest's

    id: str
    kind: str
    role: str
    file: Path
    interval: float | None
    """s; None: the median time step."""
    rows: float | None
    """Length of the campaign's rows, s; None: as logged."""
    layout: Layout
    columns: dict[str, ColumnMapping]


@dataclass(frozen=True)
class CampaignMapping:
    """What a lab's logs are."""

    source: str
    device: str
    site: Site
    nominal: dict[str, float]
    tests: tuple[TestMapping, ...]


def read_mapping(path: Path) -> CampaignMapping:
    """Read a mapping; files that it names are beside it.

    Raises:
        SpecificationError: an unreadable file, a key that is unknown, missing or has a wrong value.
    """
    top = TomlTable(str(path), "", toml_of(path, SpecificationError))
    top.check_known(("device", "site", "nominal", "rows_s", "layout", "columns", "tests"))
    tests = tuple(_test(entry, top, path.parent) for entry in top.tables("tests"))
    if not tests:
        raise top.missing("tests", "[[tests]], one a log")
    _check_ids(top, tests)
    device = top.require("device", "the gyro's name")
    if not isinstance(device, str) or not device:
        raise top.error("device", device, "the gyro's name")
    return CampaignMapping(str(path), device, _site(top), _nominal(top), tests)


def _site(top: TomlTable) -> Site:
    place = top.table("site")
    place.check_known(("latitude_deg", "gravity_m_s2"))
    place.require("latitude_deg", "-90 to 90")
    place.require("gravity_m_s2", f"{GRAVITY[0]:g} to {GRAVITY[1]:g}")
    return Site(
        latitude=place.number("latitude_deg", 0.0, -90.0, 90.0) * DEG,
        gravity=place.number("gravity_m_s2", 0.0, *GRAVITY),
    )


def _nominal(top: TomlTable) -> dict[str, float]:
    """Numbers by key, each known to a device and within its range."""
    table = top.table("nominal")
    for key in NEEDED:
        table.require(key, "it: the gyro can't be simulated without")
    values = {key: table.number(key, 0.0, -1e300, 1e300) for key in table.values}
    try:
        from_table(values, f"{top.source}: nominal")
    except DeviceError as error:
        raise SpecificationError(str(error)) from error
    return values


def _test(entry: TomlTable, top: TomlTable, folder: Path) -> TestMapping:
    entry.check_known(
        ("id", "kind", "role", "file", "interval_s", "rows_s", "layout", "columns", "absent")
    )
    for key in ("id", "kind", "role", "file"):
        entry.require(key, "text")
    general, own = top.table("layout"), entry.table("layout")
    layout = TomlTable(
        top.source,
        own.prefix if own.values else general.prefix,
        {**general.values, **own.values},
    )
    absent = _absent(entry)
    columns = read_columns(top.table("columns")) | read_columns(entry.table("columns"))
    return TestMapping(
        id=entry.text("id", ""),
        kind=entry.text("kind", ""),
        role=entry.text("role", "", ROLES),
        file=folder / entry.text("file", ""),
        interval=_duration(entry, "interval_s"),
        rows=_duration(entry, "rows_s") or _duration(top, "rows_s"),
        layout=read_layout(layout),
        columns={f: mapping for f, mapping in columns.items() if f not in absent},
    )


def _duration(table: TomlTable, key: str) -> float | None:
    """s; None where it isn't stated."""
    return table.number(key, 0.0, SHORTEST, LONGEST) if key in table.values else None


def _absent(entry: TomlTable) -> set[str]:
    """Fields of columns that this test's log lacks."""
    stems = entry.values.get("absent", [])
    if not isinstance(stems, list) or not all(stem in BY_STEM for stem in stems):
        raise entry.error("absent", stems, f"some of {', '.join(BY_STEM)}, in brackets")
    return {BY_STEM[stem].field for stem in stems}


def _check_ids(top: TomlTable, tests: tuple[TestMapping, ...]) -> None:
    ids = [test.id for test in tests]
    for i, name in enumerate(ids):
        if not FILE_NAME.fullmatch(name) or ids.count(name) > 1:
            raise top.error(f"tests[{i}].id", name, "a file name, each once")
