"""The icon: a shell seen from above, at rest and vibrating, among its eight electrodes.

Drawn with IEEE operations alone (no platform's sine), so that its bytes are the same everywhere.
"""

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

SIZE = 128
"""Width and height in pixels."""

SAMPLES = 4
"""Samples a pixel in each direction."""

WHITE, GREY, BLUE, ORANGE = (255, 255, 255), (170, 178, 189), (38, 84, 148), (222, 120, 31)
LOBE = 0.16
"""Vibration amplitude over the rim's radius, exaggerated a millionfold."""


def draw_icon() -> bytes:
    """The icon as PNG."""
    rows = b"".join(b"\0" + row.tobytes() for row in _pixels())
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b""))
    png = b"\x89PNG\r\n\x1a\n"
    for kind, data in chunks:
        png += struct.pack(">I", len(data)) + kind + data
        png += struct.pack(">I", zlib.crc32(kind + data))
    return png


def _pixels() -> NDArray[np.uint8]:
    """Colours, each pixel the mean of its samples."""
    count = SIZE * SAMPLES
    axis = (np.arange(count) + 0.5) * (2.0 / count) - 1.0
    x, y = np.meshgrid(axis, axis)
    radius = np.sqrt(x * x + y * y)
    cos2 = (x * x - y * y) / (radius * radius)
    cos4 = 2 * cos2 * cos2 - 1
    cos8 = 2 * cos4 * cos4 - 1
    colour = np.empty((count, count, 3))
    colour[:] = WHITE
    colour[(np.abs(radius - 0.88) < 0.07) & (cos8 > -0.75)] = GREY
    for sign, paint in ((-1, ORANGE), (1, BLUE)):
        colour[np.abs(radius - 0.6 * (1 + sign * LOBE * cos2)) < 0.03] = paint
    colour[radius < 0.11] = BLUE
    means = colour.reshape(SIZE, SAMPLES, SIZE, SAMPLES, 3).mean(axis=(1, 3))
    return np.rint(means).astype(np.uint8)
