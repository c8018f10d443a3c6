"""`hrg check`: an FMU or an SSP of any maker, by our own rules and by other people's tools."""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import fmu_build

if TYPE_CHECKING:
    from fmu_build.check.check import Check

HELP = "check an FMU or an SSP by rules of the standard and in other importers"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, metavar="FILE", help="FMU of FMI 2.0 or 3.0, or SSP")
    parser.add_argument(
        "--json", action="store_true", help="print an object of all checks instead of lines"
    )


def run(options: argparse.Namespace) -> None:
    if options.json:
        report = fmu_build.check_fmu(options.file)
        print(json.dumps(asdict(report), indent=1, default=str))
    else:
        report = fmu_build.check_fmu(options.file, progress=_print)
        skipped = report.skipped_count
        remark = f"; {_count(skipped, 'check')} skipped" if skipped else ""
        print(f"{_count(report.finding_count, 'finding')} in {report.path}{remark}")
    if report.finding_count:
        sys.exit(1)


def _print(check: Check) -> None:
    verdict = "FOUND" if check.findings else "SKIPPED" if check.skipped else "ok   "
    verdict = verdict if check.asked else "-    "
    remark = f" ({check.remark})" if check.remark else ""
    reasons = [*check.findings, *([check.skipped] if check.skipped else [])]
    lines = [f"{verdict} {check.name}{remark}", *(f"      {reason}" for reason in reasons)]
    print("\n".join(lines), flush=True)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
