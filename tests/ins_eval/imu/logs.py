"""Logs for tests."""

from pathlib import Path

import numpy as np
import pandas as pd

from pyhrg.records.imu.log import (
    ACCELEROMETERS,
    GYROS,
    ROTATION,
    TIME,
    VELOCITY,
    Increments,
    Quantity,
)
from tests.ins_eval.cases import at_rest

INCREMENTS = ROTATION, VELOCITY
GYRO_RAD_S, GYRO_DEG_S = GYROS[2], GYROS[3]
FORCE_M_S2, FORCE_G = ACCELEROMETERS[1], ACCELEROMETERS[2]


def resting(seconds: float = 60.0, latitude: float = 0.8, sigma: float = 1e-6) -> Increments:
    """A level vehicle at rest, heading 0.5 rad; noise of each increment, SI."""
    truth = at_rest(latitude, 100.0, seconds, np.zeros(3), yaw=0.5)
    noise = np.random.default_rng(1).normal(0.0, sigma, size=(2, len(truth), 3))
    rotation = truth.rotation + 0.01 * noise[0]
    return Increments(0.01, rotation, truth.velocity + noise[1])


def frame(
    increments: Increments, gyros: Quantity = GYRO_RAD_S, forces: Quantity = FORCE_M_S2
) -> pd.DataFrame:
    """A table of rates or increments."""
    columns = {TIME: increments.bounds[1:]}
    for kind, sums in ((gyros, increments.rotation), (forces, increments.velocity)):
        values = sums / kind.factor / (1.0 if kind.integral else increments.interval)
        columns |= dict(zip(kind.columns, values.T, strict=True))
    return pd.DataFrame(columns)


def saved(table: pd.DataFrame, folder: Path, name: str = "log.csv") -> Path:
    """The table as CSV, gzipped or not, or Parquet, by the name's ending."""
    path = folder / name
    if path.suffix == ".parquet":
        table.to_parquet(path, index=False)
    else:
        table.to_csv(path, index=False)
    return path
