"""An importer in a process of its own, so that a crash is a finding.

The process is `python -m fmu_build.check.importer FILE`: standard input brings the importer and the
run, pickled, and the file gets what it recorded.
"""

import json
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Generic, TypeVar

from fmu_build.check.experiment import FailedError, Recording, Run, read_last_line
from pyhrg.common.reading.documents import read_json

Planned = TypeVar("Planned", bound=Run)

TIMEOUT = 60
"""Seconds after which an importer is taken to hang."""

MISSING_STATUS = 3
"""Exit status of the importer's process when the importer itself can't be loaded."""


class MissingError(Exception):
    """The importer isn't installed, or lacks a library; the message says how to install it."""


@dataclass(frozen=True)
class Importer(Generic[Planned]):
    """An importer: its name, the standards that it knows, and how to install it.

    Attributes:
        modules: Python modules that are loaded before the FMU, because an error of theirs is no
            fault of the FMU; none for a program that is no Python package.
        run: function of a module that makes the run.
    """

    name: str
    package: str
    standards: tuple[str, ...]
    install: str
    modules: tuple[str, ...]
    run: Callable[[Planned], Recording]

    def find_version(self) -> str:
        """Version of the package or the program.

        Raises:
            MissingError: there is none.
        """
        try:
            if self.modules:
                return version(self.package)
            command = [self.package, "--version"]
            run = subprocess.run(command, capture_output=True, text=True, check=False)
            return (run.stdout + run.stderr).replace("Error:", "").split()[1]
        except (PackageNotFoundError, FileNotFoundError) as error:
            raise MissingError(f"{self.name} is missing: {self.install}") from error

    def record(self, planned: Planned) -> Recording:
        """Run in another process.

        Raises:
            FailedError: the importer refused, failed, crashed or hung.
            MissingError: it can't be loaded.
        """
        with tempfile.TemporaryDirectory(prefix="hrg-check-") as folder:
            result = Path(folder) / "recording.json"
            command = [sys.executable, "-m", "fmu_build.check.importer", str(result)]
            try:
                run = subprocess.run(
                    command,
                    input=pickle.dumps((self, planned)),
                    capture_output=True,
                    timeout=TIMEOUT,
                    check=False,
                )
            except subprocess.TimeoutExpired as error:
                raise FailedError(f"no end within {TIMEOUT} s") from error
            said = (run.stdout + run.stderr).decode(errors="replace")
            if run.returncode < 0:
                raise FailedError(f"it crashed by signal {-run.returncode}")
            if run.returncode == MISSING_STATUS:
                reason = read_last_line(said)
                raise MissingError(f"{self.name} can't be loaded ({reason}): {self.install}")
            if run.returncode or not result.exists():
                raise FailedError(read_last_line(said))
            return Recording(**read_json(result))


def _main() -> None:
    importer, planned = pickle.load(sys.stdin.buffer)
    try:
        for module in importer.modules:
            import_module(module)
    except (ImportError, OSError) as error:
        print(error, file=sys.stderr)
        sys.exit(MISSING_STATUS)
    try:
        recording = importer.run(planned)
    except Exception as error:  # an importer raises what it likes
        sys.exit(str(error) or type(error).__name__)
    Path(sys.argv[1]).write_text(json.dumps(asdict(recording)))


if __name__ == "__main__":
    _main()
