"""Logs made up for tests, and files that hold them with something wrong."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records import COLUMNS, Log, write_log

LATITUDE = 40 * DEG
K = 0.277
Rows = list[list[str]]


def made_up_log(n: int = 600, table_rate: float = 0.0, noise: float = 1.0, seed: int = 1) -> Log:
    """A gyro with its axis up, 1 s apart; the table turns at its rate (rad/s) in the second half.

    Noise is that of a good gyro, times `noise`.
    """
    generator = np.random.default_rng(seed)
    time = np.arange(1.0, n + 1)
    table = table_rate * np.clip(time - n // 2, 0, None)
    white = noise * generator.normal(size=(6, n))
    gyro = table + EARTH_RATE * math.sin(LATITUDE) * time + 0.04 * ARCSEC * white[0]
    one, zero = np.ones(n), np.zeros(n)
    return Log(
        source="made_up.csv.gz",
        interval=1.0,
        time=time,
        table_angle=table,
        axis_up=one,
        acceleration_x=zero,
        acceleration_y=zero,
        acceleration_z=9.8 * one,
        temperature=298.15 + 0.005 * white[1],
        virtual_rotation=zero,
        amplitude_setpoint=one,
        phase_offset=zero,
        drive_on=one,
        gyro_angle=gyro,
        wave_angle=0.5 - K * gyro,
        amplitude=1 + 1e-6 * white[2],
        amplitude_force=1 / 450 + 1e-8 * white[3],
        quadrature_force=-1e-3 + 1e-6 * white[4],
        frequency_offset=2e-4 + 1e-4 * white[5],
        valid=np.full(n, np.nan),
    )


def spoilt(folder: Path, spoil: Callable[[Rows], object], log: Log | None = None) -> Path:
    """The file of a log (12 rows where none is given), after its header and rows were changed."""
    path = folder / "log.csv"
    write_log(log or made_up_log(12), path)
    rows = [line.split(",") for line in path.read_text().splitlines()]
    spoil(rows)
    path.write_text("".join(",".join(row) + "\n" for row in rows))
    return path


def place(name: str) -> int:
    """Of a column in a row."""
    return [column.name for column in COLUMNS].index(name)
