"""The report on a file: all checks that were made of it."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from fmu_build.check.archive import open_fmu
from fmu_build.check.check import Check
from fmu_build.check.fmu_checks import run_checks
from fmu_build.check.system.archive import is_system, open_system
from fmu_build.check.system.system_checks import check_system
from pyhrg.common.errors import describe_briefly


@dataclass(frozen=True)
class CheckReport:
    """All checks of an FMU or a system, in the order in which they were made."""

    path: Path
    checks: tuple[Check, ...]

    __repr__ = describe_briefly

    @property
    def finding_count(self) -> int:
        """Number of findings; 0 means that every check that ran was passed."""
        return sum(len(check.findings) for check in self.checks)

    @property
    def skipped_count(self) -> int:
        """Number of checks that could not run here."""
        return sum(bool(check.skipped) for check in self.checks)


def check_fmu(path: Path | str, *, progress: Callable[[Check], None] | None = None) -> CheckReport:
    """Check an FMU of any maker, or a system of FMUs (SSP), and report on it.

    An FMU is checked by our own rules and by FMPy's validation, and run in four importers. In a
    system, each FMU is checked, and the system's description is; two importers run it.

    Args:
        path: an FMU of FMI 2.0 or 3.0, or an SSP.
        progress: function that is called with each check as it ends.

    Raises:
        HrgError: the file is no FMU and no system that can be read.
    """
    path = Path(path)
    done = []
    for check in _list_checks(path):
        if progress is not None:
            progress(check)
        done.append(check)
    return CheckReport(path, tuple(done))


def _list_checks(path: Path) -> Iterator[Check]:
    if is_system(path):
        with open_system(path) as system:
            yield from check_system(system)
    else:
        yield from run_checks(open_fmu(path))
