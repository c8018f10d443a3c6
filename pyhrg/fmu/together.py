"""Several gyros recorded together, in the lanes of a processor's vectors (`record.c`) where they
are of one FMU: the same bits as one by one, in a third of the time or less.
"""

import ctypes
import hashlib
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from fmu_build.binaries.lanes import build_lanes
from fmu_build.binaries.platforms import PLATFORMS, find_host_platform
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.fmu.archive import Archive
from pyhrg.fmu.gyro import CHUNK, Gyro
from pyhrg.fmu.rows import Layout, Rows, arrange_rows

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


NARROW, WIDE = 4, 8
"""Numbers of lanes: a vector of AVX2 or two of NEON, and twice as many, of which each half computes
while the other waits. `benchmarks/speed.py` compares them."""


def can_record_together(archive: Archive) -> bool:
    """Whether gyros of this FMU go together; the library for it is built if it isn't there."""
    return load_lanes(archive.folder, NARROW) is not None


def record_together(
    gyros: Sequence[Gyro],
    moving: Sequence[Mapping[str, Array]],
    held: Sequence[Mapping[str, Array]],
    step: float,
    ends: Sequence[str] = (),
    means: Sequence[str] = (),
) -> list[tuple[Array, Array]]:
    """Record gyros of one FMU, each as `Gyro.record` does it, from the same time on.

    What can't go together goes one by one: noise in some gyros only, different numbers of rows,
    rows that are new for some only, other communication steps, and all where there is no compiler.

    Args:
        gyros: (k,) at the same time since power-on.
        moving, held: (k,) see `Gyro.record`.
        step, ends, means: see `Gyro.record`.

    Returns:
        (k,) pairs as `Gyro.record` returns them, the same bits.

    Raises:
        GyroError: see `Gyro.record`.
        ValueError: gyros of different FMUs, or inputs of different names.
    """
    archive = gyros[0].instance.archive
    if any(gyro.instance.archive is not archive for gyro in gyros):
        raise ValueError("found gyros of different FMUs")
    if any([*each] != [*every[0]] for every in (moving, held) for each in every):
        raise ValueError("found gyros whose inputs have different names")
    inputs = zip(moving, held, strict=True)
    arranged = [arrange_rows(archive, *each, step, ends, means) for each in inputs]
    rows = [each for _, each in arranged]
    for group in _split(len(gyros)):
        _fill(gyros[group], arranged[0][0], rows[group])
    return [(each.ends, each.means) for each in rows]


def _split(count: int) -> Iterator[slice]:
    """Groups of at most `WIDE`."""
    for first in range(0, count, WIDE):
        yield slice(first, min(first + WIDE, count))


def _fill(gyros: Sequence[Gyro], layout: Layout, rows: Sequence[Rows]) -> None:
    done = 0
    archive = gyros[0].instance.archive
    if len(gyros) > 1:
        lanes = load_lanes(archive.folder, NARROW if len(gyros) <= NARROW else WIDE)
        done = _fill_lanes(lanes, gyros, layout, rows) if lanes else 0
    for gyro, each in zip(gyros, rows, strict=True):
        rest = each.take(slice(done, len(each.moving)))
        rest.means[:] = 0.0  # an attempt together may have begun to sum
        gyro.fill(layout, rest)


def _fill_lanes(lanes: Lanes, gyros: Sequence[Gyro], layout: Layout, rows: Sequence[Rows]) -> int:
    """How many rows succeeded."""
    components, start = [gyro.instance.slave.component for gyro in gyros], gyros[0].time
    n, steps = rows[0].moving.shape[:2]
    length = max(1, CHUNK // steps)
    done = 0
    for first in range(0, n, length):
        gyros[0].check_stop()
        parts = [each.take(slice(first, min(first + length, n))) for each in rows]
        if not lanes.record(components, start + first * steps * layout.step, layout, parts):
            break
        done = first + len(parts[0].moving)
    for gyro in gyros:
        gyro.time += layout.step * steps * done
    return done
