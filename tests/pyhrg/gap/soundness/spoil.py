"""Mistakes of a laboratory's recording, applied to the logs of a campaign."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.records import COLUMNS, Log
from pyhrg.records.campaign import Campaign

Change = Callable[[Log], Log]


def change_logs(campaign: Campaign, change: Change, *ids: str) -> Campaign:
    """The campaign with all logs changed, or those of these tests."""
    tests = (
        replace(test, recording=change(test.log)) if not ids or test.id in ids else test
        for test in campaign.tests
    )
    return replace(campaign, tests=tuple(tests))


def take_kinds(campaign: Campaign, *kinds: str) -> Campaign:
    return replace(campaign, tests=tuple(t for t in campaign.tests if t.kind in kinds))


def drop_tests(campaign: Campaign, *ids: str) -> Campaign:
    return replace(campaign, tests=tuple(t for t in campaign.tests if t.id not in ids))


def swapped(one: str, other: str) -> Change:
    return lambda log: _with(log, {one: getattr(log, other), other: getattr(log, one)})


def scaled(factor: float, *fields: str) -> Change:
    return lambda log: _with(log, {field: factor * getattr(log, field) for field in fields})


def shifted(offset: float, field: str) -> Change:
    return lambda log: _with(log, {field: getattr(log, field) + offset})


def added(values: Array, field: str) -> Change:
    return lambda log: _with(log, {field: getattr(log, field) + values})


def removed(*fields: str) -> Change:
    return lambda log: _with(log, {field: np.full(len(log.time), np.nan) for field in fields})


def at(rows: slice, value: float, field: str) -> Change:
    def change(log: Log) -> Log:
        values = getattr(log, field).copy()
        values[rows] = value
        return _with(log, {field: values})

    return change


def without_rows(rows: slice | list[int]) -> Change:
    """Rows that the recorder missed."""
    return lambda log: _with(
        log, {c.field: np.delete(getattr(log, c.field), rows) for c in COLUMNS}
    )


def _with(log: Log, columns: dict[str, Any]) -> Log:
    return replace(log, **columns)
