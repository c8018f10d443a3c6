"""A campaign: the tests of one gyro as a folder, with an index and one log a test."""

import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import ClassVar

from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import write_whole
from pyhrg.common.site import Site
from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.common.units import DEG
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device
from pyhrg.records.log import Log, read_log, write_log
from pyhrg.records.timing import INTERVAL_RANGE

SCHEMA = "hrg-campaign/1"
INDEX = "campaign.json"
ROLES = ("fit", "holdout")
"""Tests that a diagnosis may fit, and tests that only verify it."""
GRAVITY = (9.7, 9.9)
"""Smallest and largest gravity on Earth, m/s2."""
TOLERANCE_KEYS = tuple(
    declaration.keys[0]
    for declaration in read_declarations(Device).values()
    if declaration.tolerance or declaration.effect
)
"""Values of a device file that may have a tolerance."""
MIN_TOLERANCE = 1e-15
"""Smallest tolerance, in the unit of its key: far below that of any value."""
FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9._-]*")
"""Names of files that any system takes."""


class CampaignError(HrgError):
    """The folder is no campaign; the message names file, key, what was found and what expected."""


@dataclass(frozen=True)
class Test:
    """One test of one power-on.

    Attributes:
        id: name of the test, unique in the campaign; it names the file.
        kind: what was done: `static`, `positions`, `rate`, `ring_down`, ... (docs/records.md).
        role: `fit`, or `holdout` for a test that a diagnosis may not fit.
        recording: the log, or a function that reads it.
    """

    __test__: ClassVar[bool] = False  # not one of pytest's

    id: str
    kind: str
    role: str
    recording: Log | Callable[[], Log]

    @cached_property
    def log(self) -> Log:
        """The log, read once."""
        return self.recording if isinstance(self.recording, Log) else self.recording()

    @property
    def is_holdout(self) -> bool:
        """Whether the test may only verify, never fit."""
        return self.role == "holdout"


@dataclass(frozen=True)
class Campaign:
    """All tests of one gyro.

    Attributes:
        device: name of the gyro.
        site: laboratory where it was tested.
        nominal: nominal values of the gyro's parameters, by the keys of a device file, in the keys'
            units.
        tests: the tests in the order of the index.
        tolerances: one standard deviation of each value that is known less exactly, or better,
            than a diagnosis assumes; by key of a device file, in the key's unit.
    """

    device: str
    site: Site
    nominal: Mapping[str, float]
    tests: tuple[Test, ...]
    tolerances: Mapping[str, float] = field(default_factory=dict)

    __repr__ = describe_briefly

    def of_kind(self, *kinds: str) -> list[Test]:
        """Tests of these kinds in the campaign's order, held-out ones included."""
        return [test for test in self.tests if test.kind in kinds]


def read_campaign(folder: Path | str, *, any_sign: bool = False) -> Campaign:
    """Read a campaign's index (docs/records.md). Each log is read when it is first asked for.

    Args:
        folder: folder that holds `campaign.json`.
        any_sign: whether the table's angle may have the opposite sign of the gyro's, as in
            `read_log`.

    Raises:
        HrgError: there is no such folder or no index, it has another schema, or a key is missing or
            has a wrong value.
    """
    if not Path(folder).is_dir():
        raise CampaignError(f"{folder}: found no such folder, expected that of a campaign")
    index = read_json_table(Path(folder) / INDEX)
    index.text("schema", None, (SCHEMA,))
    for key, expected in (("site", "a table"), ("nominal", "a table"), ("tests", "a list")):
        index.require(key, expected)
    site = read_site(index)
    nominal = index.table("nominal")
    entries = index.tables("tests")
    tests = tuple(_read_test(Path(folder), entry, site, any_sign) for entry in entries)
    _check_names(Path(folder) / INDEX, tests)
    return Campaign(
        device=_read_text(index, "device"),
        site=site,
        nominal={key: nominal.finite_number(key) for key in nominal.values},
        tests=tests,
        tolerances=read_tolerances(index),
    )


def read_tolerances(document: TomlTable) -> dict[str, float]:
    """The table `tolerances`; empty if it is not there."""
    table = document.table("tolerances")
    table.check_known(TOLERANCE_KEYS)
    return {key: table.number(key, None, MIN_TOLERANCE, math.inf) for key in table.values}


def read_site(document: TomlTable) -> Site:
    place = document.table("site")
    return Site(
        latitude=place.number("latitude_deg", None, -90.0, 90.0) * DEG,
        gravity=place.number("gravity_m_s2", None, *GRAVITY),
    )


def write_campaign(campaign: Campaign, folder: Path | str, *, force: bool = False) -> None:
    """Write a campaign into a folder: the logs, then the index.

    Args:
        campaign: tests with their logs.
        folder: is made if it is not there.
        force: whether a campaign that is there may be replaced.

    Raises:
        CampaignError: a test's id is no file name, or is there twice; or there is a campaign.
        HrgError: a log that is yet to be read can't be used.
        OSError: the folder can't be written.
    """
    folder = Path(folder)
    _check_names(folder, campaign.tests)
    if (folder / INDEX).exists() and not force:
        raise CampaignError(
            f"can't write {folder}: found a campaign there; choose another folder, or replace it "
            "with force=True"
        )
    folder.mkdir(parents=True, exist_ok=True)
    for test in campaign.tests:
        write_log(test.log, folder / f"{test.id}.csv.gz")
    index = {
        "schema": SCHEMA,
        "device": campaign.device,
        "site": {
            "latitude_deg": float(f"{campaign.site.latitude_deg:.15g}"),
            "gravity_m_s2": campaign.site.gravity,
        },
        "nominal": dict(campaign.nominal),
        **({"tolerances": dict(campaign.tolerances)} if campaign.tolerances else {}),
        "tests": [
            {
                **{"id": test.id, "kind": test.kind, "role": test.role},
                **{"file": f"{test.id}.csv.gz", "interval_s": test.log.interval},
                "n": len(test.log.time),
            }
            for test in campaign.tests
        ],
    }
    text = json.dumps(index, indent=1, allow_nan=False) + "\n"
    write_whole(folder / INDEX, text.encode())


def _check_names(path: Path, tests: tuple[Test, ...]) -> None:
    names = [test.id for test in tests]
    for name in names:
        if not FILE_NAME.fullmatch(name) or names.count(name) > 1:
            raise CampaignError(f"{path}: test {name!r}: expected a file name, each once")


def _read_test(folder: Path, entry: TomlTable, site: Site, any_sign: bool) -> Test:
    file = _read_text(entry, "file")
    if not FILE_NAME.fullmatch(file):
        raise entry.error("file", file, "the name of a file in the campaign's folder")
    interval = entry.number("interval_s", None, *INTERVAL_RANGE)
    n = entry.whole_number("n", None, 0, 1_000_000_000)
    stored = partial(_read_log, folder / file, interval, n, site, any_sign)
    role = entry.text("role", None, ROLES)
    return Test(_read_text(entry, "id"), _read_text(entry, "kind"), role, stored)


def _read_log(path: Path, interval: float, n: int, site: Site, any_sign: bool) -> Log:
    """Read a log; another number of rows than the `n` that the index states is an exclusion."""
    log = read_log(path, interval_s=interval, latitude_deg=site.latitude_deg, any_sign=any_sign)
    if len(log.time) == n:
        return log
    note = f"{len(log.time)} rows are of use; {INDEX} says {n}"
    return replace(log, exclusions=(*log.exclusions, note))


def _read_text(table: TomlTable, key: str) -> str:
    text = table.text(key, None)
    if not text:
        raise table.error(key, text, "a text")
    return text
