"""Logs kept while a long run is under way, so that it can be interrupted and resumed."""

import hashlib
import os
import tempfile
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from pyhrg.bench.programme import HELD, Programme
from pyhrg.records import Log


@dataclass(frozen=True)
class Store:
    """A folder of logs by what they were made from; bits are kept."""

    folder: Path

    def load(self, key: str) -> Log | None:
        """The log that was kept under a key."""
        path = self._path(key)
        if not path.exists():
            return None
        with np.load(path) as kept:
            columns = {name: kept[name] for name in kept.files if name != "interval"}
            return Log(source="", interval=float(kept["interval"]), exclusions=(), **columns)

    def keep(self, key: str, log: Log) -> None:
        """Keep a log; written aside, then renamed."""
        self.folder.mkdir(parents=True, exist_ok=True)
        arrays = {f.name: getattr(log, f.name) for f in fields(log)}
        arrays = {name: values for name, values in arrays.items() if isinstance(values, np.ndarray)}
        handle, aside = tempfile.mkstemp(dir=self.folder, suffix=".partial")
        with os.fdopen(handle, "wb") as file:
            np.savez(file, interval=log.interval, **arrays)
        Path(aside).replace(self._path(key))

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}.npz"


def key_of(programme: Programme, **circumstances: object) -> str:
    """Digest of all that a log depends on."""
    digest = hashlib.sha256(repr(sorted(circumstances.items())).encode())
    digest.update(repr(programme.interval).encode())
    arrays = (programme.table_rate, programme.temperature, *map(programme.held, HELD))
    for values in arrays:
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()[:32]
