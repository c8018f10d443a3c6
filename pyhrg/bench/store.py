"""Logs on disk during a long run, so that it can be interrupted and resumed."""

import hashlib
import io
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from pyhrg.bench.programme import COMMANDS, Programme
from pyhrg.common.files import write_whole
from pyhrg.records import Log


@dataclass(frozen=True)
class Store:
    """A folder of logs, to the bit, under a key of everything that they depend on."""

    folder: Path

    @contextmanager
    def open(self) -> Iterator[None]:
        """Make the folder at the beginning of a run and remove it at the end.

        A run that ends early leaves the folder behind, unless it is empty.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            yield
            shutil.rmtree(self.folder, ignore_errors=True)
        finally:
            with suppress(OSError):  # the folder holds logs
                self.folder.rmdir()

    def load(self, key: str) -> Log | None:
        """The log of a key; None where there is none or it can't be read."""
        try:
            with np.load(io.BytesIO(self._path(key).read_bytes())) as archive:
                columns = {name: archive[name] for name in archive.files if name != "interval"}
                return Log(source="", interval=float(archive["interval"]), **columns)
        except (OSError, EOFError, ValueError, KeyError, BadZipFile):
            return None

    def keep(self, key: str, log: Log) -> None:
        """Write a log under a key, whole or not at all."""
        arrays = {f.name: getattr(log, f.name) for f in fields(log)}
        arrays = {name: values for name, values in arrays.items() if isinstance(values, np.ndarray)}
        packed = io.BytesIO()
        np.savez(packed, interval=log.interval, **arrays)
        write_whole(self._path(key), packed.getvalue())

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}.npz"


def compute_key(programme: Programme, **circumstances: object) -> str:
    """Digest of all that a log depends on: programme, circumstances, this package's code."""
    digest = hashlib.sha256(_digest_code())
    digest.update(repr(sorted(circumstances.items())).encode())
    digest.update(repr(programme.interval).encode())
    arrays = (programme.table_rate, programme.temperature, *map(programme.values, COMMANDS))
    for values in arrays:
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()[:32]


@cache
def _digest_code() -> bytes:
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parents[1].rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.digest()
