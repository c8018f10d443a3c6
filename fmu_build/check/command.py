"""`hrg check`: an FMU of any maker, by our own rules and by other people's tools."""

import argparse
import sys
from pathlib import Path

from fmu_build.check.archive import UnusableError, opened
from fmu_build.check.report import Check, checks
from fmu_build.cli import Command, UserError


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("fmu", type=Path, metavar="FILE.fmu", help="FMI 2.0 or 3.0")


def _run(options: argparse.Namespace) -> None:
    try:
        fmu = opened(options.fmu)
    except UnusableError as error:
        raise UserError(str(error)) from error
    count = 0
    for check in checks(fmu):
        print(_text(check), flush=True)
        count += len(check.findings)
    print(f"{count} finding{'' if count == 1 else 's'} in {options.fmu}")
    if count:
        sys.exit(1)


def _text(check: Check) -> str:
    verdict = "FOUND" if check.findings else "ok   "
    remark = f" ({check.remark})" if check.remark else ""
    return "\n".join([f"{verdict} {check.name}{remark}", *(f"      {f}" for f in check.findings)])


CHECK = Command("check an FMU by rules of the standard and in other importers", _add_options, _run)
