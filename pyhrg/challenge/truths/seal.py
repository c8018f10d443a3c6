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
from pyhrg.common.reading.documents import read_json
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES, refuse_unreadable


class ChallengeError(HrgError):
    """The folder is another challenge's or other code's, or a result in it can't be used."""


def seal_truth(truth: Truth, path: Path) -> str:
    """Write a truth, whole or not at all, outside every folder that is diagnosed; returns the hash
    to be published."""
    write_whole(path, encode_json(asdict(truth)))
    return hash_truth(path)


def hash_truth(path: Path) -> str:
    """The hash of a truth that was sealed."""
    return hashlib.sha256(read_bytes(path, DOCUMENT_BYTES)).hexdigest()


def open_truth(path: Path, published: str) -> Truth:
    """A truth; refused if it is not the one whose hash was published."""
    digest = hash_truth(path)
    if digest != published:
        raise ChallengeError(
            f"{path}: SHA-256 is {digest}; {published} was published before diagnosing"
        )
    known = {field.name for field in fields(Truth)}
    values: dict[str, Any] = {
        key: tuple(value) if isinstance(value, list) else value
        for key, value in read_json(path).items()
        if key in known
    }
    with refuse_unreadable(path, "truth of a challenge"):
        return Truth(**values)


def encode_json(values: Mapping[str, Any]) -> bytes:
    """Bytes of a JSON file: the same for the same values, which are finite."""
    return (json.dumps(values, indent=1, sort_keys=True, allow_nan=False) + "\n").encode()
