"""Sealed truths: their hashes are published before anything is diagnosed, so that no truth can be
changed afterwards."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

from pyhrg.challenge.truths.truth import Truth
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole


class SealError(HrgError):
    """A truth is missing, unreadable, or not the one whose hash was published."""


def seal_truth(truth: Truth, path: Path) -> str:
    """Write a truth, whole or not at all.

    Args:
        truth: to be kept.
        path: of the file, outside every folder that is diagnosed.

    Returns:
        The hash to be published.
    """
    text = _text(asdict(truth))
    write_whole(path, text)
    return _hash(text)


def hash_truth(path: Path) -> str:
    """The hash of a truth that was sealed.

    Raises:
        SealError: the file can't be read.
    """
    return _hash(_bytes(path))


def open_truth(path: Path, published: str) -> Truth:
    """A truth, if it is the one that was sealed.

    Raises:
        SealError: it isn't, or the file can't be read.
    """
    text = _bytes(path)
    found = _hash(text)
    if found != published:
        raise SealError(f"{path}: SHA-256 is {found}; {published} was published before diagnosing")
    values: Mapping[str, Any] = json.loads(text)
    known = {field.name for field in fields(Truth)}
    lists = ("effects", "strengths", "stand_ins")
    told: dict[str, Any] = {
        k: tuple(v) if k in lists else v for k, v in values.items() if k in known
    }
    return Truth(**told)


def _text(values: Mapping[str, Any]) -> bytes:
    return (json.dumps(values, indent=1, sort_keys=True, allow_nan=False) + "\n").encode()


def _hash(text: bytes) -> str:
    return hashlib.sha256(text).hexdigest()


def _bytes(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise SealError(f"{path}: can't be read: {error.strerror or error}") from error
