"""Output files that appear together or not at all."""

import os
import shutil
from pathlib import Path
from types import TracebackType


class Staging:
    """A context manager: a folder aside, whose files move into `out` when the block succeeds.

    Raises:
        OSError: on entry, if the output folder can't be written.
    """

    def __init__(self, out: Path) -> None:
        self.out = out
        self.aside = out.parent / f".{out.name}.{os.getpid()}"

    def __enter__(self) -> Path:
        if self.out.exists() and not self.out.is_dir():
            raise NotADirectoryError(20, "not a folder")
        if self.out.exists() and not os.access(self.out, os.W_OK | os.X_OK):
            raise PermissionError(13, "permission denied")
        self.aside.mkdir(parents=True)
        return self.aside

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            if kind is None:
                self.out.mkdir(exist_ok=True)
                for file in sorted(self.aside.iterdir()):
                    file.replace(self.out / file.name)
        finally:
            shutil.rmtree(self.aside, ignore_errors=True)
