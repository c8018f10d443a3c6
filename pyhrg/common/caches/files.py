"""Files of the cache: verified by digest, and read from a folder that nobody else may write."""

import hashlib
import os
import stat
from pathlib import Path

import platformdirs

from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole

OTHERS_MAY_WRITE = stat.S_IWGRP | stat.S_IWOTH
OF_USER_ALONE = 0o700
"""Mode of the cache's folder."""


def find_cache_folder() -> Path:
    """The user's cache, made if it is not there.

    Compiled code in it is loaded and run, so that nobody else may write there.

    Raises:
        HrgError: there is no home; or the folder is another user's, or others may write it.
        OSError: it can't be made.
    """
    folder = platformdirs.user_cache_path("hrg")
    if not folder.is_absolute():
        raise HrgError("cache: found no home folder, expected $HOME or $XDG_CACHE_HOME")
    folder.mkdir(mode=OF_USER_ALONE, parents=True, exist_ok=True)
    if not hasattr(os, "geteuid"):  # Windows: a user's folders are the user's alone
        return folder
    status = folder.stat()
    if status.st_uid != os.geteuid() or status.st_mode & OTHERS_MAY_WRITE:
        raise HrgError(
            f"{folder}: found owner {status.st_uid} and mode {stat.S_IMODE(status.st_mode):o}, "
            f"expected a cache that user {os.geteuid()} alone may write: delete it, or name "
            "another by XDG_CACHE_HOME"
        )
    return folder


def write_digest(path: Path) -> None:
    """Write the digest of a cached file that other programs read (an FMU) into a file beside it."""
    write_whole(_name_digest(path), hashlib.sha256(path.read_bytes()).hexdigest().encode())


def is_intact(path: Path) -> bool:
    """Whether a file of the cache is there, and is the one whose digest is beside it."""
    try:
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        return _name_digest(path).read_bytes() == digest.encode()
    except OSError:
        return False


def _name_digest(path: Path) -> Path:
    return path.with_name(f"{path.name}.sha256")


def append_digest(data: bytes) -> bytes:
    """Data as it is kept: its SHA-256 follows it."""
    return data + hashlib.sha256(data).digest()


def write_cached(path: Path, data: bytes) -> None:
    """Write a file of the cache, whole or not at all; its folders are made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, append_digest(data))


def read_cached(path: Path) -> bytes | None:
    """Data of a file of the cache; None where there is none or it is damaged."""
    try:
        kept = path.read_bytes()
    except OSError:
        return None
    data = kept[: -hashlib.sha256().digest_size]
    return data if append_digest(data) == kept else None
