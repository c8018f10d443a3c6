"""Compiled inner loops (numba), cached on disk from one run to the next."""

import hashlib
import io
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numba
from numba.core import caching, config

from pyhrg.common import site
from pyhrg.common.caches.files import append_digest, find_cache_folder, read_cached
from pyhrg.common.errors import HrgError

_SETTINGS: Any = config
PACKAGES = ("pyhrg", "ins_eval")


def list_sources() -> list[Path]:
    """Return all files with compiled functions, or with constants that are compiled into them."""
    root = Path(__file__).parents[3]
    sources = [path for name in PACKAGES for path in sorted((root / name).rglob("*.py"))]
    return [Path(site.__file__), *(p for p in sources if b"@compile_loop" in p.read_bytes())]


@cache
def cache_folder() -> Path:
    """Return the cache's folder, which is named after the contents of all `list_sources`.

    Numba alone notices a change in a function's own file only, not in a file that it imports.
    """
    texts = b"\0".join(path.read_bytes() for path in list_sources())
    return find_cache_folder() / f"compiled-{hashlib.sha256(texts).hexdigest()[:16]}"


@cache
def is_cache_usable() -> bool:
    """Tell whether files can be written to the cache's folder, by this user alone."""
    try:
        cache_folder().mkdir(exist_ok=True)
        with tempfile.TemporaryFile(dir=cache_folder()):
            return True
    except (HrgError, OSError):
        return False


class _CheckedFile(caching.IndexDataCacheFile):
    """Numba's files of one function, with digests: it unpickles none that is damaged.

    The digest follows the pickle. Unpickling stops before it, so that numba reads the files as they
    are.
    """

    def _load_index(self) -> Any:
        return {} if read_cached(Path(self._index_path)) is None else super()._load_index()

    def _load_data(self, name: str) -> Any:
        if read_cached(Path(self._data_path(name))) is None:
            raise FileNotFoundError(name)  # numba compiles it anew
        return super()._load_data(name)

    def save(self, key: Any, data: Any) -> None:
        with suppress(OSError):  # a full disk: the next process compiles again
            super().save(key, data)

    @contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[Any]:
        buffer = io.BytesIO()
        yield buffer
        with super()._open_for_write(filepath) as file:
            file.write(append_digest(buffer.getvalue()))


def compile_loop(
    function: Callable[..., Any] | None = None, *, inline: Literal["never", "always"] = "never"
) -> Any:
    """Decorator: `numba.njit`, cached in `cache_folder`, or not at all if that is not usable. The
    function runs without Python's lock.

    Numba's own place, beside the source file, would serve stale code after a change elsewhere, and
    compile again in each copy of the sources. `inline` is numba's.
    """
    if function is None:
        return lambda function: compile_loop(function, inline=inline)
    if not is_cache_usable():
        return numba.njit(function, nogil=True, inline=inline)
    before = _SETTINGS.CACHE_DIR
    _SETTINGS.CACHE_DIR = str(cache_folder())
    try:
        compiled: Any = numba.njit(cache=True, nogil=True, inline=inline)(function)
    finally:
        _SETTINGS.CACHE_DIR = before
    compiled._cache._cache_file = _CheckedFile(
        str(cache_folder()), _name_files(function), source_stamp=None
    )
    return compiled


def _name_files(function: Callable[..., Any]) -> str:
    """Beginning of the names of a function's files: the same wherever the sources lie. Pickles
    depend on the version of Python."""
    version = "".join(map(str, sys.version_info[:2]))
    return f"{function.__module__}.{function.__qualname__}-py{version}"
