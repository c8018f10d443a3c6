"""Logs on disk during a long run, so that it can be interrupted and resumed."""

import hashlib
import io
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from pyhrg.bench.programme import COMMANDS, Programme
from pyhrg.common.caches.files import read_cached, write_cached
from pyhrg.common.made_by import digest_value, list_versions
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
        made = [path for path in (self.folder, *self.folder.parents) if not path.exists()]
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            yield
            shutil.rmtree(self.folder, ignore_errors=True)
        finally:
            with suppress(OSError):  # a folder holds logs or results
                for path in made or [self.folder]:
                    path.rmdir()

    def load(self, key: str) -> Log | None:
        """The log of a key; None where there is none or it is damaged."""
        if (kept := read_cached(self._path(key))) is None:
            return None
        with np.load(io.BytesIO(kept)) as archive:
            columns = {name: archive[name] for name in archive.files if name != "interval"}
            return Log(source="", interval=float(archive["interval"]), **columns)

    def keep(self, key: str, log: Log) -> None:
        """Write a log under a key, whole or not at all."""
        arrays = {f.name: getattr(log, f.name) for f in fields(log)}
        arrays = {name: values for name, values in arrays.items() if isinstance(values, np.ndarray)}
        packed = io.BytesIO()
        np.savez(packed, interval=log.interval, **arrays)
        write_cached(self._path(key), packed.getvalue())

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}.npz"


def compute_key(programme: Programme, **circumstances: object) -> str:
    """Digest of all that a log depends on: programme, circumstances, this code, its libraries."""
    others = (list_versions(), sorted(circumstances.items()), programme.interval)
    digest = hashlib.sha256(digest_value(others).encode())
    arrays = (programme.table_rate, programme.temperature, *map(programme.values, COMMANDS))
    for values in arrays:
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()[:32]
