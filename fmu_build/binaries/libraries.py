"""Compiled libraries, kept by the digest of what they are made of; only changes are compiled."""

import hashlib
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path

import platformdirs

from fmu_build.binaries.platforms import FLAGS, UCRT, WINDOWS_RUNTIME, Platform, compile_library
from pyhrg.common.files import write_whole


def fetch_library(
    folder: Path,
    sources: Sequence[str],
    identifier: str,
    target: Platform,
    progress: Callable[[str], None] = lambda text: None,
) -> bytes:
    """Shared library of the C sources in a folder, from the user's cache or compiled."""
    return keep_library(folder, sources, identifier, target, progress).read_bytes()


def keep_library(
    folder: Path,
    sources: Sequence[str],
    identifier: str,
    target: Platform,
    progress: Callable[[str], None] = lambda text: None,
    *,
    flags: Sequence[str] = FLAGS,
    processor: str = "",
) -> Path:
    """Path of the shared library in the user's cache, compiled if it isn't there. Its name is a
    digest of all files in the folder, and of the processor's features where `flags` use them."""
    made_of = f"{version('ziglang')} {flags} {processor} {UCRT} {target} {identifier} {sources}"
    digest = hashlib.sha256(made_of.encode())
    digest.update(WINDOWS_RUNTIME.read_bytes())
    for file in sorted(folder.glob("*.[ch]")):
        digest.update(f"{file.name}\0".encode() + file.read_bytes())
    path = (
        platformdirs.user_cache_path("hrg") / "libraries" / f"{digest.hexdigest()}{target.suffix}"
    )
    if path.exists():
        progress(f"unchanged for {target.name}")
        return path
    progress(f"compiling for {target.name}")
    library = compile_library(folder, sources, identifier, target, flags)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, library)
    return path
