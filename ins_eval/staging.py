"""Output files that appear together or not at all."""

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def staging(out: Path, names: tuple[str, ...]) -> Iterator[Path]:
    """A folder aside, within `out`, whose files move up when the block succeeds.

    Args:
        out: output folder; made if it isn't there, and removed again if the block fails.
        names: of the files that the block is going to write.

    Raises:
        OSError: on entry, if the folder can't be written or a name is taken by a folder.
    """
    made = [p for p in (out, *out.parents) if not p.exists()]
    try:
        out.mkdir(parents=True, exist_ok=True)
        for name in names:
            if (out / name).is_dir():
                raise IsADirectoryError(21, f"{name} is a folder")
        aside = Path(tempfile.mkdtemp(prefix=".partial-", dir=out))
        try:
            yield aside
            for name in names:
                (aside / name).replace(out / name)
        finally:
            shutil.rmtree(aside, ignore_errors=True)
    except BaseException:
        for folder in made:
            if folder.is_dir():
                folder.rmdir()
        raise
