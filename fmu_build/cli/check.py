"""`hrg check`: an FMU of any maker, by our own rules and by other people's tools."""

import argparse
import sys
from pathlib import Path

from fmu_build.check.archive import UnusableError, opened
from fmu_build.check.report import Check, checks
from pyhrg.common.errors import HrgError

HELP = "check an FMU by rules of the standard and in other importers"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("fmu", type=Path, metavar="FILE.fmu", help="FMI 2.0 or 3.0")


def run(options: argparse.Namespace) -> None:
    try:
        fmu = opened(options.fmu)
    except UnusableError as error:
        raise HrgError(str(error)) from error
    count = skipped = 0
    for check in checks(fmu):
        print(_text(check), flush=True)
        count += len(check.findings)
        skipped += bool(check.skipped)
    remark = f"; {_count(skipped, 'check')} skipped" if skipped else ""
    print(f"{_count(count, 'finding')} in {options.fmu}{remark}")
    if count:
        sys.exit(1)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _text(check: Check) -> str:
    verdict = "FOUND" if check.findings else "SKIPPED" if check.skipped else "ok   "
    remark = f" ({check.remark})" if check.remark else ""
    reasons = [*check.findings, *([check.skipped] if check.skipped else [])]
    return "\n".join([f"{verdict} {check.name}{remark}", *(f"      {r}" for r in reasons)])
