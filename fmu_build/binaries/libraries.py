"""Compiled libraries, kept by the digest of what they are made of; only changes are compiled."""

import hashlib
from collections.abc import Callable, Sequence
from pathlib import Path

from fmu_build.binaries.platforms import (
    FLAGS,
    UCRT,
    WINDOWS_RUNTIME,
    Platform,
    compile_library,
    find_compiler_version,
)
from pyhrg.common.caches.files import find_cache_folder, read_cached, write_cached


def fetch_library(
    folder: Path,
    sources: Sequence[str],
    identifier: str,
    target: Platform,
    progress: Callable[[str], None] = lambda text: None,
    *,
    flags: Sequence[str] = FLAGS,
    processor: str = "",
) -> bytes:
    """Shared library of the C sources in a folder, from the user's cache or compiled. What it is
    kept by is a digest of all of them and, where `flags` use them, of the processor's features."""
    tools = f"{find_compiler_version()} {flags} {processor} {UCRT}"
    digest = hashlib.sha256(f"{tools} {target} {identifier} {sources}".encode())
    digest.update(WINDOWS_RUNTIME.read_bytes())
    for file in sorted(folder.glob("*.[ch]")):
        digest.update(f"{file.name}\0".encode() + file.read_bytes())
    library_name = f"{digest.hexdigest()}{target.suffix}"
    path = find_cache_folder() / "libraries" / library_name
    if (kept := read_cached(path)) is not None:
        progress(f"unchanged for {target.name}")
        return kept
    progress(f"compiling for {target.name}")
    library = compile_library(folder, sources, identifier, target, flags)
    write_cached(path, library)
    return library
