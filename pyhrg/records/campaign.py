"""A campaign: what a test engineer brings home from one gyro, a folder with one log a test."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import ClassVar

from pyhrg import records
from pyhrg.common.files import write_whole
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign_index import CampaignError, Entry, index_of

__all__ = ["Campaign", "CampaignError", "Site", "StoredLog", "Test", "read", "write"]

SCHEMA = "hrg-campaign/1"
INDEX = "campaign.json"
ROLES = ("fit", "holdout")
"""May be used to diagnose; only to verify."""
GRAVITY = (9.7, 9.9)
"""On Earth, m/s2."""
FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9._-]*")


@dataclass(frozen=True)
class StoredLog:
    """A log that is read when it is asked for."""

    path: Path
    interval: float
    """s."""
    n: int
    """Rows that the campaign promises."""
    latitude: float
    """Of the site, rad."""

    def read(self) -> Log:
        """Read the log; a number of rows that isn't as promised is an exclusion.

        Raises:
            LogError: as `records.read`.
        """
        log = records.read(self.path, self.interval, self.latitude)
        if len(log.time) == self.n:
            return log
        note = f"{len(log.time)} rows left; {INDEX} says {self.n}"
        return replace(log, exclusions=(*log.exclusions, note))


@dataclass(frozen=True)
class Test:
    """One test of one power-on."""

    __test__: ClassVar[bool] = False  # not one of pytest's

    id: str
    kind: str
    """`static`, `positions`, `rate`, `ring_down`, ..."""
    role: str
    """`fit` or `holdout`."""
    recording: Log | StoredLog

    @cached_property
    def log(self) -> Log:
        """The log, read once.

        Raises:
            LogError: it can't be used.
        """
        return self.recording if isinstance(self.recording, Log) else self.recording.read()

    @property
    def is_holdout(self) -> bool:
        """Whether it may only verify, never fit."""
        return self.role == "holdout"


@dataclass(frozen=True)
class Campaign:
    """The tests of one gyro."""

    device: str
    site: Site
    nominal: Mapping[str, float]
    """What is believed of the gyro, under the names and units of the file."""
    tests: tuple[Test, ...]

    def of_kind(self, *kinds: str) -> list[Test]:
        """Its tests of these kinds, in order; those held out too."""
        return [test for test in self.tests if test.kind in kinds]


def read(folder: Path) -> Campaign:
    """Read a campaign's index; logs are read when they are asked for.

    Raises:
        CampaignError: no index, another schema, or a key that is missing or has a wrong value.
    """
    index = index_of(folder / INDEX)
    if index.text("schema") != SCHEMA:
        raise index.error("schema", f"expected {SCHEMA!r}")
    place = index.entry("site")
    site = Site(
        latitude=place.number("latitude_deg", -90.0, 90.0) * DEG,
        gravity=place.number("gravity_m_s2", *GRAVITY),
    )
    nominal = index.entry("nominal")
    tests = tuple(_test(folder, entry, site) for entry in index.entries("tests"))
    _check_names(folder / INDEX, tests)
    return Campaign(
        device=index.text("device"),
        site=site,
        nominal={key: nominal.number(key) for key in nominal.values},
        tests=tests,
    )


def write(campaign: Campaign, folder: Path) -> None:
    """Write the logs, then the index.

    Raises:
        CampaignError: a test's id is no file name, or is there twice.
        LogError: a log that is yet to be read can't be used.
        OSError: the folder can't be written.
    """
    _check_names(folder, campaign.tests)
    folder.mkdir(parents=True, exist_ok=True)
    for test in campaign.tests:
        records.write(test.log, folder / _file(test))
    index = {
        "schema": SCHEMA,
        "device": campaign.device,
        "site": {
            "latitude_deg": float(f"{campaign.site.latitude / DEG:.15g}"),
            "gravity_m_s2": campaign.site.gravity,
        },
        "nominal": dict(campaign.nominal),
        "tests": [_listed(test) for test in campaign.tests],
    }
    text = json.dumps(index, indent=1, allow_nan=False) + "\n"
    write_whole(folder / INDEX, text.encode())


def _check_names(path: Path, tests: tuple[Test, ...]) -> None:
    names = [test.id for test in tests]
    for name in names:
        if not FILE_NAME.fullmatch(name) or names.count(name) > 1:
            raise CampaignError(f"{path}: test {name!r}: expected a file name, each once")


def _file(test: Test) -> str:
    return f"{test.id}.csv.gz"


def _listed(test: Test) -> dict[str, str | float]:
    return {
        "id": test.id,
        "kind": test.kind,
        "role": test.role,
        "file": _file(test),
        "interval_s": test.log.interval,
        "n": len(test.log.time),
    }


def _test(folder: Path, entry: Entry, site: Site) -> Test:
    role = entry.text("role")
    if role not in ROLES:
        raise entry.error("role", f"expected {' or '.join(ROLES)}")
    file = entry.text("file")
    if not FILE_NAME.fullmatch(file):
        raise entry.error("file", "expected the name of a file in the campaign's folder")
    interval = entry.number("interval_s", 1e-6, 1e6)
    n = entry.number("n", 0, 1e9)
    if n != int(n):
        raise entry.error("n", "expected a whole number")
    stored = StoredLog(folder / file, interval, int(n), site.latitude)
    return Test(entry.text("id"), entry.text("kind"), role, stored)
