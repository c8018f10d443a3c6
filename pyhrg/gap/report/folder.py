"""The folder of a diagnosis: its files appear together or not at all."""

from collections.abc import Callable
from pathlib import Path

from pyhrg.common.files import staging
from pyhrg.device import device_file
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.findings import diagnosis
from pyhrg.gap.report import sections
from pyhrg.gap.report.page import PAGE, page

BEFORE, AFTER = "before.toml", "after.toml"
"""The gyro as it was believed, and with what was found."""
FILES = (BEFORE, AFTER, diagnosis.FILE)


def keep(found: Diagnosed, out: Path) -> None:
    """Write a diagnosis, and the gyro before and after it.

    Raises:
        OSError: the folder can't be written.
    """
    with staging(out, FILES) as aside:
        _write(found, aside)


def keep_with_report(
    found: Diagnosed, out: Path, say: Callable[[str], None] = lambda text: None
) -> None:
    """The same with the report, and with the documents of its sections that others bring.

    Args:
        found: diagnosis, and what it rests on.
        out: folder.
        say: told how far it is.

    Raises:
        OSError: the folder can't be written.
    """
    documents = [f"{name}.json" for name in sections.names()]
    with staging(out, (*FILES, *documents, PAGE)) as aside:
        _write(found, aside)
        say("report")
        brought = sections.sections(aside, say)
        for name, section in brought.items():
            (aside / f"{name}.json").write_bytes(section.data())
        (aside / PAGE).write_text(page(found, brought), encoding="utf-8")


def _write(found: Diagnosed, folder: Path) -> None:
    device_file.write(found.believed, folder / BEFORE)
    device_file.write(found.closed, folder / AFTER)
    diagnosis.write(found.diagnosis, folder)
