"""ASCII messages of NovAtel receivers and VectorNav sensors, for tests."""

import zlib
from collections.abc import Iterable
from functools import reduce
from operator import xor

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments
from pyhrg.records.imu.novatel import SCALES, Scale

ISA100C = 26
SCALE = SCALES[ISA100C, "ISA100C"]


def make_novatel(text: str, sign: str = "%") -> str:
    return f"{sign}{text}*{zlib.crc32(text.encode(), 0xFFFFFFFF) ^ 0xFFFFFFFF:08x}"


def make_vectornav(text: str) -> str:
    return f"${text}*{reduce(xor, text.encode()):02X}"


def count_novatel(increments: Increments, scale: Scale = SCALE) -> Array:
    """Counts (n, 6) as RAWIMU has them: along z, -y, x of axes right, forward, up."""
    forward_right_down = (increments.velocity / scale.velocity, increments.rotation / scale.angle)
    counts = [
        [-down, -forward, right] for forward, right, down in map(np.transpose, forward_right_down)
    ]
    return np.rint(np.concatenate(counts)).T.astype(int)


def write_rawimu(
    increments: Increments,
    name: str = "RAWIMUSXA",
    kind: object = ISA100C,
    start: float = 604_790.0,
) -> list[str]:
    """Messages from seconds `start` of GPS week 2209 on."""
    extension = f"00,{kind}," if "X" in name else ""
    lines = []
    for n, counts in enumerate(count_novatel(increments).tolist(), start=1):
        week, seconds = divmod(start + n * increments.interval, 604_800.0)
        time = f"{2209 + week:.0f},{seconds:.6f}"
        header = f"{name},{time}" if "S" in name[6:] else f"{name},COM1,0,60.0,FINE,{time},0,0,0"
        body = ",".join(map(str, counts))
        text = f"{header};{extension}{time},00000077,{body}"
        lines.append(make_novatel(text, "%" if "S" in name[6:] else "#"))
    return lines


def write_vectornav(name: str, increments: Increments) -> list[str]:
    """VNDTV, VNIMU or VNYMR messages."""
    step = increments.interval
    lines = []
    for rotation, velocity in zip(increments.rotation, increments.velocity, strict=True):
        fields: Iterable[float]
        if name == "VNDTV":
            fields = [step, *np.rad2deg(rotation), *velocity]
        else:
            before, after = {"VNIMU": (3, 2), "VNYMR": (6, 0)}[name]
            fields = [*[0.1] * before, *velocity / step, *rotation / step, *[20.0] * after]
        lines.append(make_vectornav(",".join([name, *(f"{x:+.12e}" for x in fields)])))
    return lines
