"""Rows of the study that are judged together: triads by missions."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.study.tables import columns
from ins_eval.study.tables.score import ALL

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Group:
    """What a score is of: r triads in m missions."""

    calibration: str
    mission_class: str
    half: str
    rows: pd.DataFrame
    missions: tuple[str, ...]

    @property
    def triads(self) -> int:
        """r."""
        return len(self.rows) // len(self.missions)

    def of(self, name: str) -> Array:
        """(r, m) of a column of numbers, (r, m, n) of one of lists of numbers."""
        values = self.rows[name].to_numpy()
        if values.dtype == object:
            values = np.stack(values)
        return np.asarray(values.reshape(self.triads, len(self.missions), *values.shape[1:]), float)

    def pair(self, prefix: str) -> Array:
        """(r, m, 2) of columns of errors north and east: `flown`, `noise`, `oracle`, ..."""
        return np.stack([self.of(f"{prefix}_{axis}_m") for axis in ("north", "east")], axis=-1)


def groups(table: pd.DataFrame) -> Iterator[Group]:
    """By calibration and half: all classes together, then each.

    Args:
        table: of `columns`.

    Raises:
        ValueError: a triad lacks a mission, or has one twice.
    """
    for (calibration, half), rows in table.groupby([columns.CALIBRATION, columns.HALF]):
        yield _group(str(calibration), ALL, str(half), rows)
        for name, part in rows.groupby(columns.CLASS):
            yield _group(str(calibration), str(name), str(half), part)


def _group(calibration: str, mission_class: str, half: str, rows: pd.DataFrame) -> Group:
    ordered = rows.sort_values([columns.TRIAD, columns.MISSION], kind="stable")
    missions = tuple(sorted(set(ordered[columns.MISSION])))
    flown = ordered[columns.MISSION].to_numpy()
    triads = ordered[columns.TRIAD].to_numpy()
    count = len(missions)
    whole = len(flown) % count == 0 and np.all(flown.reshape(-1, count) == np.array(missions))
    if not whole or np.any(np.diff(triads[::count]) <= 0):
        raise ValueError(
            f"{calibration}, {mission_class}, {half}: {len(set(triads))} triads, {count} missions "
            f"and {len(flown)} rows; expected one row for each triad and mission"
        )
    return Group(calibration, mission_class, half, ordered, missions)
