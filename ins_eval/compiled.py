"""Compilation of the inner loops, kept on disk from run to run."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba.core import config
from platformdirs import user_cache_path

_SETTINGS: Any = config

SOURCES = ("earth.py", "navigation/kernel.py", "alignment/inertial_kernel.py")
"""Files that hold compiled functions. Numba notices a change in a function's own file alone; the
cache's folder is named after all of them."""


def _digest() -> str:
    texts = ((Path(__file__).parent / name).read_bytes() for name in SOURCES)
    return hashlib.sha256(b"\0".join(texts)).hexdigest()[:16]


_FOLDER = user_cache_path("hrg") / f"compiled-{_digest()}"


def compiled(function: Callable[..., Any]) -> Any:
    """Decorator: `numba.njit`, cached."""
    before = _SETTINGS.CACHE_DIR
    _SETTINGS.CACHE_DIR = str(_FOLDER)
    try:
        return numba.njit(cache=True)(function)
    finally:
        _SETTINGS.CACHE_DIR = before
