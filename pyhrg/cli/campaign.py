"""`hrg campaign`: campaigns as folders."""

import argparse
from dataclasses import replace
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.files import replaced_folder
from pyhrg.common.toml_table import SpecificationError
from pyhrg.gap.soundness import sound
from pyhrg.records import LogError, campaign
from pyhrg.records.campaign_import.importing import Imported, imported
from pyhrg.records.campaign_import.mapping import read_mapping
from pyhrg.records.campaign_import.preview import preview

HELP = "make a campaign of a lab's own logs"


def add_options(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    action = actions.add_parser(
        "import",
        help="make a campaign of a lab's own logs",
        description="Make a campaign of a lab's own logs (docs/import.md).",
    )
    action.add_argument(
        "mapping", type=Path, metavar="MAPPING.toml", help="what the logs are: columns, units"
    )
    where = action.add_mutually_exclusive_group(required=True)
    where.add_argument(
        "--out", type=Path, metavar="DIR", help="campaign to write; not there yet, or empty"
    )
    where.add_argument(
        "--check", action="store_true", help="say what was understood, and write nothing"
    )


def run(options: argparse.Namespace) -> None:
    if options.out is not None:
        _check_free(options.out)
    try:
        found = imported(read_mapping(options.mapping))
    except (SpecificationError, LogError) as error:
        raise HrgError(str(error)) from error
    print(preview(found))
    print("\n" + _judged(found))
    if options.out is not None:
        _write(found, options.out)
        print(f"\nwritten to {options.out}")


def _judged(found: Imported) -> str:
    """What a diagnosis would say of it beforehand, beside what the preview notes."""
    tests = (
        replace(written, recording=replace(test.read, exclusions=()))
        for written, test in zip(found.campaign.tests, found.tests, strict=True)
    )
    try:
        _, exclusions = sound(replace(found.campaign, tests=tuple(tests)))
    except campaign.CampaignError as error:
        return f"a diagnosis would refuse it: {error}"
    if not exclusions:
        return "a diagnosis would use all of it"
    return "a diagnosis would leave out, or take for granted:\n" + "\n".join(
        f"  {sentence}" for sentence in exclusions
    )


def _check_free(out: Path) -> None:
    """Nobody's files are replaced."""
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise HrgError(f"can't write {out}: found something there, expected nothing yet")


def _write(found: Imported, out: Path) -> None:
    try:
        with replaced_folder(out) as aside:
            campaign.write(found.campaign, aside)
    except OSError as error:
        raise HrgError(f"can't write {out}: {error.strerror or error}") from error
