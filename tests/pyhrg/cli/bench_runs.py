"""Runs of `hrg bench` for tests of the command."""

from pathlib import Path

from pyhrg.common.cli import main


def hrg(*arguments: object) -> int:
    """Exit status of `hrg bench`."""
    try:
        return main(["bench", *map(str, arguments)])
    except SystemExit as stop:
        return int(str(stop.code))


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def device(folder: Path, text: str) -> Path:
    path = folder / "gyro.toml"
    path.write_text(text)
    return path
