"""Parts of a log that are left out, and estimates of nominal values from a log."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Mask
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD


@dataclass(frozen=True)
class Exclusion:
    """Fields of a log that are left out, and why.

    rows: (n,) rows that are left out; None: all.
    """

    fields: tuple[str, ...]
    sentence: str
    rows: Mask | None = None


@dataclass(frozen=True)
class NominalEstimate:
    """Estimate of a nominal value from one field of a log, with the range that effects can explain.

    key: key in the campaign's table `nominal`; nominal, value, low and high are in its unit.
    """

    key: str
    field: str
    source: str
    nominal: float
    value: float
    low: float
    high: float

    @property
    def contradicts(self) -> bool:
        """Whether no effect of the catalogue explains its distance from the nominal value."""
        return not self.low <= self.value <= self.high

    def fits(self, nominal: float) -> bool:
        """Whether it would agree with another nominal value."""
        share = nominal / self.nominal
        return self.low * share <= self.value <= self.high * share

    @property
    def sentence(self) -> str:
        """File, column, the estimate and what was expected."""
        return (
            f"{self.source}: column {BY_FIELD[self.field].name}: implies {self.key} "
            f"{self.value:.4g}; expected {self.low:.4g} to {self.high:.4g}"
        )


def exclude_columns(log: Log, fields: tuple[str, ...], trouble: str) -> Exclusion:
    """Exclusion of whole columns, with a sentence that names file and columns."""
    names = ", ".join(BY_FIELD[field].name for field in fields)
    column = "columns" if len(fields) > 1 else "column"
    return Exclusion(fields, f"{log.source}: {column} {names}: {trouble}")


def replace_columns(log: Log, columns: Mapping[str, Any]) -> Log:
    """A log with other values in some of its fields."""
    return replace(log, **columns)


def apply_exclusions(log: Log, exclusions: Sequence[Exclusion]) -> Log:
    """A log with NaN in all that is left out."""
    for exclusion in exclusions:
        rows = np.ones(len(log.time), dtype=bool) if exclusion.rows is None else exclusion.rows
        emptied = {field: np.where(rows, np.nan, getattr(log, field)) for field in exclusion.fields}
        log = replace_columns(log, emptied)
    return log


def find_runs(chosen: Mask) -> list[tuple[int, int]]:
    """First row of each run of chosen rows, and the row after its last."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], chosen.astype(np.int8), [0]]))).tolist()
    return list(zip(edges[::2], edges[1::2], strict=True))
