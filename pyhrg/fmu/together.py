"""Several gyros recorded together: the same bits as one by one, in a third of the time or less."""

from collections.abc import Iterator, Mapping, Sequence

from pyhrg.common.arrays import Array
from pyhrg.fmu.gyro import CHUNK, Gyro
from pyhrg.fmu.lanes import Lanes, load_lanes
from pyhrg.fmu.rows import Layout, Rows, arrange_rows

NARROW, WIDE = 4, 8
"""Numbers of lanes: a vector of AVX2 or two of NEON, and twice as many, of which each half computes
while the other waits. `benchmarks/speed.py` compares them."""


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
