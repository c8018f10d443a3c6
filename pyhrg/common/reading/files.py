"""Bytes and text of files, gzipped or not."""

import gzip
import io
import os
import stat
from contextlib import ExitStack
from pathlib import Path
from typing import BinaryIO

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.limits import (
    LINE_BYTES,
    LOG_BYTES,
    check_size,
    compute_expanded_limit,
    refuse_unreadable,
)

WITHOUT_WAITING = getattr(os, "O_NONBLOCK", 0)
"""Flag of opening without waiting for a pipe's writer; 0 on Windows, which has none."""
GZIPPED = b"\x1f\x8b"
"""First bytes of gzipped data."""
SPREADSHEETS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")
"""First bytes of a spreadsheet's file: of Excel and LibreOffice, new and old."""


def open_file(path: Path) -> BinaryIO:
    """A file or a pipe, opened for reading."""
    with refuse_unreadable(path, "file"), ExitStack() as stack:
        # without waiting: a pipe that nobody writes to is empty
        handle = os.open(path, os.O_RDONLY | WITHOUT_WAITING | getattr(os, "O_BINARY", 0))
        file = stack.enter_context(os.fdopen(handle, "rb"))
        kind = os.fstat(handle).st_mode
        if not (stat.S_ISREG(kind) or stat.S_ISFIFO(kind)):
            raise HrgError(f"{path}: found a device, expected a file")
        if WITHOUT_WAITING:
            os.set_blocking(handle, True)
        stack.pop_all()
        return file


def read_bytes(path: Path, most: int) -> bytes:
    """A file's bytes; more than `most` are refused, before they are read where it can be known."""
    with open_file(path) as file, refuse_unreadable(path, "file"):
        check_size(path, os.fstat(file.fileno()).st_size, most)
        data = file.read(most + 1)
        check_size(path, len(data), most)
        return data


def read_unpacked(path: Path) -> bytes:
    """A log's bytes, decompressed if they are gzipped, whatever the file's name."""
    data = read_bytes(path, LOG_BYTES)
    if data.startswith(SPREADSHEETS):
        raise HrgError(f"{path}: found a spreadsheet (Excel) or an archive; save the sheet as CSV")
    if not data.startswith(GZIPPED):
        return data
    most = min(LOG_BYTES, compute_expanded_limit(len(data)))
    with (
        refuse_unreadable(path, "whole gzipped data"),
        gzip.GzipFile(fileobj=io.BytesIO(data)) as file,
    ):
        unpacked = file.read(most + 1)
        check_size(path, len(unpacked), most)
        return unpacked


def decode(
    source: object,
    data: bytes,
    encoding: str = "utf-8-sig",
) -> str:
    """The text that bytes are; refused where its lines are too long for a log or a document."""
    lines = data.count(b"\n") + data.count(b"\r") + 1
    if len(data) > LINE_BYTES * lines:
        raise HrgError(
            f"{source}: found lines of {len(data) // lines} bytes on average, expected at most "
            f"{LINE_BYTES}"
        )
    with refuse_unreadable(source, f"text in {encoding}"):
        return data.decode(encoding)
