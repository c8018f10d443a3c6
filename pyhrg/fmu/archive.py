"""The archive of an FMU: extracted, its description read."""

import contextlib
import hashlib
import shutil
from collections.abc import Iterable
from pathlib import Path

import fmpy
import numpy as np
from numpy.typing import NDArray

from pyhrg.common.errors import HrgError
from pyhrg.common.files import make_aside
from pyhrg.common.reading.archives import open_archive
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import LOG_BYTES, refuse_unreadable


class GyroError(HrgError):
    """The FMU refused a call; the message is its own."""


HELD = "gyro."
"""Beginning of the names of a gyro's variables in a class that holds it."""


class Archive:
    """An FMU, extracted beside its file.

    description: FMPy's model description; folder: the extracted archive; references: value
    reference of each variable, by name; kinds: FMI type of each variable, by name. Where a class
    holds the gyro as `gyro`, the gyro's variables have their own names too.
    """

    def __init__(self, path: Path) -> None:
        """Read the description and extract the archive, once."""
        with refuse_unreadable(path, "FMU"):
            self.description = fmpy.read_model_description(str(path))
        self.folder = _extract(path)
        variables = {v.name: v for v in self.description.modelVariables}
        held = {n.removeprefix(HELD): v for n, v in variables.items() if n.startswith(HELD)}
        variables = held | variables
        self.references: dict[str, int] = {n: v.valueReference for n, v in variables.items()}
        self.kinds: dict[str, str] = {n: v.type for n, v in variables.items()}

    def __repr__(self) -> str:
        """Name and digest of the archive: the same for the same bytes."""
        return f"{type(self).__name__}({self.folder.name})"

    @property
    def is_sampled(self) -> bool:
        """Whether the control loops run once a control period; in the slow model they have settled
        at any time."""
        return "controller.amplitudeLoop.naturalFrequency" in self.references

    def find_references(self, names: Iterable[str]) -> NDArray[np.uint32]:
        names = list(names)
        for name in names:
            if name not in self.references:
                raise GyroError(f"the FMU has no variable {name}")
        return np.array([self.references[name] for name in names], dtype=np.uint32)


def _extract(path: Path) -> Path:
    """Extract an FMU to a folder beside it that is named by its digest.

    The folder is made under another name and then renamed, so that it is never half there. One that
    is not as the archive is made anew.
    """
    digest = hashlib.sha256(read_bytes(path, LOG_BYTES)).hexdigest()[:16]
    folder = path.with_name(f"{path.stem}-{digest}")
    if not _is_extracted(path, folder):
        with make_aside(folder) as aside:
            fmpy.extract(str(path), str(aside))
            if not _is_extracted(path, folder):  # another process may have been faster
                shutil.rmtree(folder, ignore_errors=True)
            with contextlib.suppress(OSError):  # it was
                aside.rename(folder)
    return folder


def _is_extracted(path: Path, folder: Path) -> bool:
    """Whether every file of an archive is in the folder, byte by byte."""
    with open_archive(path) as archive:
        files = {e.filename: archive.read(e) for e in archive.entries if not e.is_dir()}
    try:
        return all((folder / name).read_bytes() == data for name, data in files.items())
    except OSError:
        return False
