"""Fixes of a vehicle: positions, velocities and speeds that something other than its IMU measured.

A row has a time, that of the IMU's log, and one or more groups of columns; a group that a row
leaves empty was not measured then.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ins_eval.aided.receivers import split_novatel, split_vectornav
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.errors import HrgError, describe_briefly, quote
from pyhrg.common.reading.documents import parse_csv
from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.common.reading.messages import is_novatel, is_vectornav
from pyhrg.common.units import DEG

TIME = "time_s"
GROUPS = {
    "position": ("latitude_deg", "longitude_deg", "height_m", "position_sigma_m"),
    "velocity": (
        "velocity_north_m_s",
        "velocity_east_m_s",
        "velocity_down_m_s",
        "velocity_sigma_m_s",
    ),
    "speed": ("speed_m_s", "speed_sigma_m_s"),
}
"""Columns of what is measured: the antenna's position and velocity over ground, a speed forward.
A standstill is a velocity of 0. Sigmas are of each component."""
HEIGHT_SIGMA = "height_sigma_m"
"""Optional column; without it, heights are as accurate as the other two."""
KF_GINS = (TIME, *GROUPS["position"][:3], "sigma_north_m", "sigma_east_m", "sigma_down_m")
"""Columns of the text format of KF-GINS: no header, fields in white space; and of the positions of
NovAtel messages. Those of VectorNav messages go on with the velocity's."""
LIMITS = {
    "latitude_deg": (-89.0, 89.0),
    "longitude_deg": (-360.0, 360.0),
    "height_m": (-1000.0, 50_000.0),
    **dict.fromkeys(("position_sigma_m", HEIGHT_SIGMA, *KF_GINS[4:]), (1e-4, 1000.0)),
    **dict.fromkeys(GROUPS["velocity"][:3], (-3000.0, 3000.0)),
    **dict.fromkeys(("velocity_sigma_m_s", "speed_sigma_m_s"), (1e-4, 100.0)),
    "speed_m_s": (-300.0, 300.0),
}
"""Smallest and largest value of each column. Chosen: no vehicle goes beyond."""
LONGEST_FIRST_LINE = 1000
"""Number of characters in which the first line of a KF-GINS file ends. Chosen."""
FEWEST = 30
"""Smallest number of positions. Chosen: fewer align no vehicle."""


@dataclass(frozen=True)
class Fixes:
    """Fixes at m times; NaN where a quantity was not measured.

    time: (m,) s, increasing; position: (m, 3) latitude, longitude, rad, height, m; position_sigma:
    (m, 3) north, east, down, m; velocity: (m, 3) north, east, down, m/s; velocity_sigma: (m,) of
    each component, m/s; speed: (m,) forward, m/s; speed_sigma: (m,) m/s; source: for messages.
    """

    time: Array
    position: Array
    position_sigma: Array
    velocity: Array
    velocity_sigma: Array
    speed: Array
    speed_sigma: Array
    source: str = "fixes"

    __repr__ = describe_briefly

    def __len__(self) -> int:
        return len(self.time)

    @property
    def has_position(self) -> Mask:
        """(m,)"""
        return np.isfinite(self.position[:, 0])

    def select(self, rows: Mask | NDArray[np.intp]) -> "Fixes":
        """The fixes of some rows."""
        chosen = {f.name: getattr(self, f.name)[rows] for f in fields(self) if f.name != "source"}
        return Fixes(**chosen, source=self.source)

    def between(self, first: float, last: float) -> "Fixes":
        """The fixes at times from `first` to `last`, s."""
        return self.select((self.time >= first) & (self.time <= last))


def make_position_fixes(time: Array, position: Array, sigma: Array | float) -> Fixes:
    """Fixes of the position alone.

    time: (m,) s; position: (m, 3) latitude, longitude, rad, height, m; sigma: of north, east and
    down, m.
    """
    none = np.full(len(time), np.nan)
    size = np.broadcast_to(np.asarray(sigma, dtype=float), (len(time), 3))
    return Fixes(time, position, size, np.tile(none[:, None], 3), none, none, none)


def read_fixes(path: Path | str) -> Fixes:
    """Read fixes from a CSV file, KF-GINS text, or messages of NovAtel or VectorNav, gzipped or not
    (docs/aided.md).

    Raises:
        HrgError: an unreadable file; no position; a column that is missing or appears twice; a
            field that is no number or beyond its limits; half a group; time that does not increase.
    """
    source = Path(path)
    text = decode(source, read_unpacked(source))
    if is_novatel(text):
        wanted, numbered = list(KF_GINS), split_novatel(source, text)
    elif is_vectornav(text):
        wanted, numbered = [*KF_GINS, *GROUPS["velocity"]], split_vectornav(source, text)
    elif _is_kf_gins(text):
        wanted, numbered = list(KF_GINS), _split_kf_gins(source, text)
    else:
        (_, names), *numbered = list(parse_csv(source, text)) or [(1, [])]
        header = [name.strip() for name in names]
        wanted = _choose_columns(source, header)
        places = [header.index(name) for name in wanted]
        numbered = [(n, [row[p] if p < len(row) else "" for p in places]) for n, row in numbered]
    rows = [_parse_row(source, number, row, wanted) for number, row in numbered]
    values = np.array(rows).reshape(-1, len(wanted))
    columns = dict(zip(wanted, values.T, strict=True))
    if wanted[4] == KF_GINS[4]:
        north, east, columns[HEIGHT_SIGMA] = (columns.pop(name) for name in KF_GINS[4:])
        columns["position_sigma_m"] = np.sqrt((north**2 + east**2) / 2)
    _check_groups(source, [number for number, _ in numbered], columns)
    _check_time(source, [number for number, _ in numbered], columns[TIME])
    return _assemble(source, columns)


def _is_kf_gins(text: str) -> bool:
    """Whether the first line has the numbers of `KF_GINS`, without commas."""
    fields = text[:LONGEST_FIRST_LINE].split("\n", 1)[0].split()
    try:
        return len([float(field) for field in fields]) == len(KF_GINS)
    except ValueError:
        return False


def _split_kf_gins(source: Path, text: str) -> list[tuple[int, list[str]]]:
    """Number and fields of each row."""
    lines = enumerate(text.splitlines(), start=1)
    rows = [(number, line.split()) for number, line in lines if line.strip()]
    for number, row in rows:
        if len(row) != len(KF_GINS):
            found = f"row {number}: found {len(row)} fields, expected {len(KF_GINS)}"
            raise HrgError(f"{source}: {found}: {', '.join(KF_GINS)}")
    return rows


def _choose_columns(source: Path, header: Sequence[str]) -> list[str]:
    """Time and the columns of each group of which the file has one."""
    groups = [g for g in GROUPS.values() if any(name in header for name in g)]
    if GROUPS["position"] not in groups:
        groups.insert(0, GROUPS["position"])
    wanted = [TIME, *(name for group in groups for name in group)]
    missing = [name for name in wanted if name not in header]
    if missing:
        found = ", ".join(header) or "an empty file"
        raise HrgError(f"{source}: column {missing[0]} is missing; found {found}")
    wanted += [HEIGHT_SIGMA] if HEIGHT_SIGMA in header else []
    if repeated := [name for name in wanted if header.count(name) > 1]:
        raise HrgError(f"{source}: column {repeated[0]} appears more than once")
    return wanted


def _parse_row(source: Path, number: int, row: list[str], names: Sequence[str]) -> list[float]:
    values = []
    for name, field in zip(names, row, strict=True):
        text = field.strip()
        if not text and name != TIME:
            values.append(np.nan)
            continue
        try:
            value = float(text)
        except ValueError:
            found = f"row {number}, {name}: found {quote(text)}"
            raise HrgError(f"{source}: {found}, expected a number") from None
        low, high = LIMITS.get(name, (-1e12, 1e12))
        if not low <= value <= high:
            found = f"row {number}, {name}: found {text}"
            raise HrgError(f"{source}: {found}, expected {low:g} to {high:g}")
        values.append(value)
    return values


def _check_groups(source: Path, numbers: Sequence[int], columns: dict[str, Array]) -> None:
    """Refuse rows that have a part of a group."""
    for group in GROUPS.values():
        if group[0] not in columns:
            continue
        present = np.isfinite([columns[name] for name in group])
        half = present.any(axis=0) & ~present.all(axis=0)
        if half.any():
            row = int(np.argmax(half))
            name = group[int(np.argmin(present[:, row]))]
            raise HrgError(
                f"{source}: row {numbers[row]}, {name}: found nothing, expected a number beside "
                f"the others of {', '.join(group)}"
            )


def _check_time(source: Path, numbers: Sequence[int], time: Array) -> None:
    steps = np.diff(time)
    if np.any(steps <= 0):
        row = int(np.argmax(steps <= 0)) + 1
        raise HrgError(
            f"{source}: row {numbers[row]}, {TIME}: found {time[row]:.10g} after "
            f"{time[row - 1]:.10g}, expected time to increase"
        )


def _assemble(source: Path, columns: dict[str, Array]) -> Fixes:
    none = np.full(len(columns[TIME]), np.nan)

    def stack(names: Sequence[str]) -> Array:
        return np.stack([columns.get(name, none) for name in names], axis=-1)

    position, velocity, speed = GROUPS["position"], GROUPS["velocity"], GROUPS["speed"]
    sigma = columns[position[3]]
    down = columns.get(HEIGHT_SIGMA, sigma)
    fixes = Fixes(
        time=columns[TIME],
        position=stack(position[:3]) * np.array([DEG, DEG, 1.0]),
        position_sigma=np.stack([sigma, sigma, np.where(np.isfinite(down), down, sigma)], axis=-1),
        velocity=stack(velocity[:3]),
        velocity_sigma=columns.get(velocity[3], none),
        speed=columns.get(speed[0], none),
        speed_sigma=columns.get(speed[1], none),
        source=str(source),
    )
    count = int(np.count_nonzero(fixes.has_position))
    if count < FEWEST:
        raise HrgError(f"{source}: found {count} positions, expected at least {FEWEST}")
    return fixes
