"""Columns of a log that can't be what their names say, and what a log says of nominal values."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.site import Site
from pyhrg.device.device import Device
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Believed:
    """What a campaign's logs are held to."""

    device: Device
    site: Site


@dataclass(frozen=True)
class Doubt:
    """Fields of a log that are left out, and why.

    rows: (n,) those that are doubted; None: all.
    """

    fields: tuple[str, ...]
    sentence: str
    rows: NDArray[np.bool_] | None = None


@dataclass(frozen=True)
class Witness:
    """What a field of a log says of a nominal value.

    key: of `nominal`; nominal, found, low, high: in its unit.
    """

    key: str
    field: str
    source: str
    nominal: float
    found: float
    low: float
    high: float

    @property
    def contradicts(self) -> bool:
        """Whether no effect of a catalogue makes it so far off."""
        return not self.low <= self.found <= self.high

    def fits(self, value: float) -> bool:
        """Whether it could as well be a gyro of another value."""
        share = value / self.nominal
        return self.low * share <= self.found <= self.high * share

    @property
    def sentence(self) -> str:
        """File, column, found and expected."""
        return (
            f"{self.source}: column {BY_FIELD[self.field].name}: says {self.key} {self.found:.4g}; "
            f"expected {self.low:.4g} to {self.high:.4g}"
        )


def doubt(log: Log, fields: tuple[str, ...], trouble: str) -> Doubt:
    """Of whole columns."""
    names = ", ".join(BY_FIELD[field].name for field in fields)
    column = "columns" if len(fields) > 1 else "column"
    return Doubt(fields, f"{log.source}: {column} {names}: {trouble}")


def with_columns(log: Log, columns: Mapping[str, Any]) -> Log:
    """A log with other values in some of its fields."""
    return replace(log, **columns)


def without(log: Log, doubts: Sequence[Doubt]) -> Log:
    """A log without what is doubted."""
    for one in doubts:
        rows = np.ones(len(log.time), dtype=bool) if one.rows is None else one.rows
        emptied = {field: np.where(rows, np.nan, getattr(log, field)) for field in one.fields}
        log = with_columns(log, emptied)
    return log


def has(log: Log, *fields: str) -> bool:
    """Whether a log has values in all these fields."""
    return all(bool(np.isfinite(getattr(log, field)).any()) for field in fields)
