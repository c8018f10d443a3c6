"""Compiled libraries, kept by the digest of what they are made of; only changes are compiled."""

import hashlib
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path

from fmu_build.binaries.platforms import FLAGS, UCRT, WINDOWS_RUNTIME, Platform, compile_library
from pyhrg.common.caches.files import find_cache_folder, read_cached, write_cached


def fetch_library(
    folder: Path,
    sources: Sequence[str],
    identifier: str,
    target: Platform,
    progress: Callable[[str], None] = lambda text: None,
) -> bytes:
    """Shared library of the C sources in a folder, from the user's cache or compiled."""
    digest = hashlib.sha256(f"{version('ziglang')} {FLAGS} {UCRT} {target} {identifier}".encode())
    digest.update(WINDOWS_RUNTIME.read_bytes())
    for name in (*sources, *sorted(file.name for file in folder.glob("*.h"))):
        digest.update(f"{name}\0".encode() + (folder / name).read_bytes())
    library_name = f"{digest.hexdigest()}{target.suffix}"
    path = find_cache_folder() / "libraries" / library_name
    if (kept := read_cached(path)) is not None:
        progress(f"unchanged for {target.name}")
        return kept
    progress(f"compiling for {target.name}")
    library = compile_library(folder, sources, identifier, target)
    write_cached(path, library)
    return library
