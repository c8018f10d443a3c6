"""Compilation of the inner loops, kept on disk from run to run."""

import hashlib
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
    files = [p for p in sorted(here.parent.rglob("*.py")) if b"@compiled" in p.read_bytes()]
    site = find_spec("pyhrg.site")
    assert site is not None
    assert site.origin is not None
    return [here, Path(site.origin), *files]


@cache
def folder() -> Path:
    """Of the cache. Numba notices a change in a function's own file alone, so that the folder is
    named after the contents of all of them."""
    texts = b"\0".join(path.read_bytes() for path in sources())
    return user_cache_path("hrg") / f"compiled-{hashlib.sha256(texts).hexdigest()[:16]}"


def compiled(function: Callable[..., Any]) -> Any:
    """Decorator: `numba.njit`, cached where the cache's folder can be written."""
    before = _SETTINGS.CACHE_DIR
    _SETTINGS.CACHE_DIR = str(folder())
    try:
        return numba.njit(cache=True)(function)
    except (OSError, RuntimeError):  # Numba: "cannot cache function: no locator available"
        return numba.njit(function)
    finally:
        _SETTINGS.CACHE_DIR = before
