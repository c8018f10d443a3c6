"""Groups of flights that are scored together: r triads in m missions."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.study.tables import columns
from ins_eval.study.tables.score import ALL
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class FlightGroup:
    """Flights of r triads in m missions, all of them in all."""

    calibration: str
    mission_class: str
    role: str
    rows: pd.DataFrame
    missions: tuple[str, ...]

    @property
    def triads(self) -> int:
        """Number of triads, r."""
        return len(self.rows) // len(self.missions)

    def select(self, name: str) -> Array:
        """(r, m) values of a column of numbers; (r, m, n) of a column of lists."""
        values = self.rows[name].to_numpy()
        if values.dtype == object:
            values = np.stack(values)
        return np.asarray(values.reshape(self.triads, len(self.missions), *values.shape[1:]), float)

    def select_pair(self, prefix: str) -> Array:
        """(r, m, 2) errors north and east of the columns with this prefix, such as `flown`, m."""
        return np.stack([self.select(f"{prefix}_{axis}_m") for axis in ("north", "east")], axis=-1)


def group_flights(table: pd.DataFrame) -> Iterator[FlightGroup]:
    """Groups by calibration and role: all classes together, then each class; as `make_group`."""
    for (calibration, role), rows in table.groupby([columns.CALIBRATION, columns.ROLE]):
        yield make_group(str(calibration), ALL, str(role), rows)
        for name, part in rows.groupby(columns.CLASS):
            yield make_group(str(calibration), str(name), str(role), part)


def make_group(calibration: str, mission_class: str, role: str, rows: pd.DataFrame) -> FlightGroup:
    """The group of these flights.

    Raises:
        ValueError: a triad lacks a mission, or has one twice.
    """
    ordered = rows.sort_values([columns.TRIAD, columns.MISSION], kind="stable")
    missions = tuple(sorted(set(ordered[columns.MISSION])))
    flown = ordered[columns.MISSION].to_numpy()
    triads = ordered[columns.TRIAD].to_numpy()
    count = len(missions)
    whole = len(flown) % count == 0 and np.all(flown.reshape(-1, count) == np.array(missions))
    if not whole or np.any(np.diff(triads[::count]) <= 0):
        raise ValueError(
            f"{calibration}, {mission_class}, {role}: {len(set(triads))} triads, {count} missions "
            f"and {len(flown)} rows; expected one row for each triad and mission"
        )
    return FlightGroup(calibration, mission_class, role, ordered, missions)
