"""Compiled inner loops (numba), cached on disk from one run to the next."""

import hashlib
import tempfile
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numba
from numba.core import config
from platformdirs import user_cache_path

_SETTINGS: Any = config


def list_sources() -> list[Path]:
    """Return all files with compiled functions, or with constants that are compiled into them."""
    here = Path(__file__)
    files = [p for p in sorted(here.parents[1].rglob("*.py")) if b"@compile_loop" in p.read_bytes()]
    site = find_spec("pyhrg.common.site")
    assert site is not None
    assert site.origin is not None
    return [here, Path(site.origin), *files]


@cache
def cache_folder() -> Path:
    """Return the cache's folder, which is named after the contents of all `list_sources`.

    Numba alone notices a change in a function's own file only, not in a file that it imports.
    """
    texts = b"\0".join(path.read_bytes() for path in list_sources())
    return user_cache_path("hrg") / f"compiled-{hashlib.sha256(texts).hexdigest()[:16]}"


@cache
def is_cache_writable() -> bool:
    """Tell whether files can be written to the cache's folder."""
    try:
        cache_folder().mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=cache_folder()):
            return True
    except OSError:
        return False


def compile_loop(function: Callable[..., Any]) -> Any:
    """Decorator: `numba.njit`, cached in `cache_folder`, or not at all if that is not writable.

    Numba's own place, beside the source file, would serve stale code after a change elsewhere.
    """
    if not is_cache_writable():
        return numba.njit(function)
    before = _SETTINGS.CACHE_DIR
    _SETTINGS.CACHE_DIR = str(cache_folder())
    try:
        return numba.njit(cache=True)(function)
    finally:
        _SETTINGS.CACHE_DIR = before
