"""Compilation of the inner loops, kept on disk from run to run."""

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


def sources() -> list[Path]:
    """Files that hold compiled functions, or constants that are compiled into them."""
    here = Path(__file__)
    files = [p for p in sorted(here.parents[1].rglob("*.py")) if b"@compiled" in p.read_bytes()]
    site = find_spec("pyhrg.common.site")
    assert site is not None
    assert site.origin is not None
    return [here, Path(site.origin), *files]


@cache
def folder() -> Path:
    """Of the cache. Numba notices a change in a function's own file alone, so that the folder is
    named after the contents of all of them."""
    texts = b"\0".join(path.read_bytes() for path in sources())
    return user_cache_path("hrg") / f"compiled-{hashlib.sha256(texts).hexdigest()[:16]}"


@cache
def kept() -> bool:
    """Whether the cache's folder can be written."""
    try:
        folder().mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder()):
            return True
    except OSError:
        return False


def compiled(function: Callable[..., Any]) -> Any:
    """Decorator: `numba.njit`, cached in `folder`, or nowhere: beside its source, compiled code
    would outlive a change in another file."""
    if not kept():
        return numba.njit(function)
    before = _SETTINGS.CACHE_DIR
    _SETTINGS.CACHE_DIR = str(folder())
    try:
        return numba.njit(cache=True)(function)
    finally:
        _SETTINGS.CACHE_DIR = before
