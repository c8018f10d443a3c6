"""Gyros of one FMU side by side in the lanes of a processor's vectors (`record.c`)."""

import ctypes
import hashlib
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from fmu_build.binaries.lanes import build_lanes
from fmu_build.binaries.platforms import PLATFORMS, find_host_platform
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.fmu.rows import Layout, Rows

_Addresses = ctypes.c_void_p * 4
"""Addresses of what belongs to moving and held inputs, outputs at the end and outputs averaged."""


class _Plan(ctypes.Structure):
    """`Plan` of `record.c`."""

    _fields_ = (
        ("rows", ctypes.c_size_t),
        ("steps", ctypes.c_size_t),
        ("commands", ctypes.c_size_t),
        ("start", ctypes.c_double),
        ("step", ctypes.c_double),
        ("tick", ctypes.c_double),
        ("is_new", ctypes.c_void_p),
        ("references", _Addresses),
        ("counts", ctypes.c_size_t * 4),
    )


class _Gyro(ctypes.Structure):
    """`Gyro` of `record.c`."""

    _fields_ = (("instance", ctypes.c_void_p), ("values", _Addresses))


class Lanes:
    """The library for one FMU and one number of lanes."""

    def __init__(self, library: Path) -> None:
        self._record = ctypes.CDLL(str(library)).record_together
        self._record.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t]

    def record(
        self, components: Sequence[int], start: float, layout: Layout, rows: Sequence[Rows]
    ) -> bool:
        """Fill `ends` and `means` of each gyro's rows from `start`, s, on, and move its instance.

        False where all can't go together, with the instances as they were: different numbers of
        rows, rows that are new for some of them only, noise in some of them only, instances at
        different times, or anything that an instance by itself refuses.
        """
        first, references = rows[0], layout[3:]
        for each in rows:
            if each.moving.shape != first.moving.shape or (each.is_new != first.is_new).any():
                return False
        n, steps = first.moving.shape[:2]
        plan = _Plan(
            *(n, steps, layout.commands, start, layout.step, layout.tick, first.is_new.ctypes.data),
            _Addresses(*(each.ctypes.data for each in references)),
            (ctypes.c_size_t * 4)(*map(len, references)),
        )
        gyros = (_Gyro * len(rows))()
        for gyro, component, each in zip(gyros, components, rows, strict=True):
            values = each.moving, each.held, each.ends, each.means
            gyro.instance = component
            gyro.values = _Addresses(*(array.ctypes.data for array in values))
        return bool(self._record(ctypes.byref(plan), gyros, len(rows)))


@lru_cache(maxsize=8)
def load_lanes(folder: Path, width: int) -> Lanes | None:
    """The library for the FMU extracted to a folder; None where it can't be built."""
    try:
        library = build_lanes(folder / "sources", width)
        suffix = PLATFORMS[find_host_platform()].suffix
        path = folder / f"lanes-{hashlib.sha256(library).hexdigest()[:16]}{suffix}"
        if not path.exists() or path.read_bytes() != library:
            write_whole(path, library)
        return Lanes(path)
    except (HrgError, OSError):
        return None
