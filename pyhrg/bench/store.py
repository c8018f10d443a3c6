"""Logs kept while a long run is under way, so that it can be interrupted and resumed."""

import hashlib
import io
import shutil
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from types import TracebackType
from zipfile import BadZipFile

import numpy as np

import pyhrg
from pyhrg.bench.programme import HELD, Programme
from pyhrg.common.files import write_whole
from pyhrg.records import Log


@dataclass(frozen=True)
class Store:
    """A folder of logs by what they were made from; bits are kept.

    As a context manager it is there while the run is, and left behind only by one that ended
    early.
    """

    folder: Path

    def __enter__(self) -> "Store":
        self.folder.mkdir(parents=True, exist_ok=True)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is None:
            shutil.rmtree(self.folder, ignore_errors=True)
        with suppress(OSError):  # it holds logs
            self.folder.rmdir()

    def load(self, key: str) -> Log | None:
        """The log that was kept under a key; None where there is none that can be read."""
        try:
            with np.load(io.BytesIO(self._path(key).read_bytes())) as kept:
                columns = {name: kept[name] for name in kept.files if name != "interval"}
                return Log(source="", interval=float(kept["interval"]), **columns)
        except (OSError, EOFError, ValueError, KeyError, BadZipFile):
            return None

    def keep(self, key: str, log: Log) -> None:
        """Keep a log, whole."""
        arrays = {f.name: getattr(log, f.name) for f in fields(log)}
        arrays = {name: values for name, values in arrays.items() if isinstance(values, np.ndarray)}
        packed = io.BytesIO()
        np.savez(packed, interval=log.interval, **arrays)
        write_whole(self._path(key), packed.getvalue())

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}.npz"


def key_of(programme: Programme, **circumstances: object) -> str:
    """Digest of all that a log depends on, this package's code included."""
    digest = hashlib.sha256(_code())
    digest.update(repr(sorted(circumstances.items())).encode())
    digest.update(repr(programme.interval).encode())
    arrays = (programme.table_rate, programme.temperature, *map(programme.held, HELD))
    for values in arrays:
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()[:32]


@cache
def _code() -> bytes:
    digest = hashlib.sha256()
    for file in sorted(Path(pyhrg.__file__).parent.rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.digest()
