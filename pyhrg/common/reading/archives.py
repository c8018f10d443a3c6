"""ZIP archives."""

import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import open_file
from pyhrg.common.reading.limits import (
    ARCHIVE_ENTRIES,
    check_size,
    compute_expanded_limit,
    refuse_unreadable,
)

METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
"""Compressions that are read, those of FMI 3.0.2, 2.5; others expand without a bound."""
ENCRYPTED = 1
"""Bit of an entry's flags."""


class Archive:
    """An open archive, whose entries together are within the limits."""

    def __init__(self, path: Path, file: zipfile.ZipFile) -> None:
        self._path, self._file = path, file
        self.entries = file.infolist()
        """In the order of the archive; a name may be there twice."""
        if len(self.entries) > ARCHIVE_ENTRIES:
            raise HrgError(
                f"{path}: found {len(self.entries)} files, expected at most {ARCHIVE_ENTRIES}"
            )
        most = compute_expanded_limit(path.stat().st_size)
        check_size(path, sum(entry.file_size for entry in self.entries), most)

    def read(self, entry: zipfile.ZipInfo | str) -> bytes:
        """Bytes of an entry, checked by its CRC-32."""
        name = entry if isinstance(entry, str) else entry.filename
        place = f"{name} in {self._path}"
        with refuse_unreadable(place, "intact entry"):
            entry = self._file.getinfo(name) if isinstance(entry, str) else entry
            if entry.compress_type not in METHODS:
                found = f"found compression method {entry.compress_type}"
                raise HrgError(f"{place}: {found}, expected stored or deflated")
            with self._file.open(entry) as file:
                data = file.read(entry.file_size)  # not all: a size that lies bounds no read()
        if len(data) < entry.file_size:
            raise HrgError(f"{place}: found {len(data)} bytes of {entry.file_size}")
        return data


@contextmanager
def open_archive(path: Path) -> Iterator[Archive]:
    with open_file(path) as file:
        with refuse_unreadable(path, "intact ZIP file"):
            archive = zipfile.ZipFile(file)
        with archive:
            yield Archive(path, archive)
