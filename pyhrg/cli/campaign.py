"""`hrg campaign`: campaigns as folders."""

import argparse
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder, write_whole

HELP = "make a campaign of a laboratory's own logs"


def add_options(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    action = actions.add_parser(
        "import",
        help="make a campaign of a laboratory's own logs",
        description="Make a campaign of a laboratory's own logs (docs/import.md).",
    )
    action.add_argument(
        "mapping", type=Path, metavar="MAPPING.toml", help="columns and units of the logs"
    )
    where = action.add_mutually_exclusive_group(required=True)
    where.add_argument(
        "--out", type=Path, metavar="DIR", help="campaign to write; not there yet, or empty"
    )
    action.add_argument(
        "--force", action="store_true", help="replace the campaign that is in the output folder"
    )
    where.add_argument(
        "--check", action="store_true", help="say what was understood, and write nothing"
    )
    action.set_defaults(run_action=_import)
    action = actions.add_parser(
        "init",
        help="draft a mapping for the import of logs",
        description="Draft a mapping: columns and units guessed from the logs' headers, to edit.",
    )
    action.add_argument("logs", type=Path, nargs="+", metavar="LOG", help="text files, as CSV")
    action.add_argument(
        "--out",
        type=Path,
        default=Path("mapping.toml"),
        metavar="FILE",
        help="mapping to write; not there yet (default mapping.toml)",
    )
    action.set_defaults(run_action=_draft)


def run(options: argparse.Namespace) -> None:
    options.run_action(options)


def _import(options: argparse.Namespace) -> None:
    from pyhrg.bench.session import describe_readiness
    from pyhrg.gap.preparation import describe_preparation
    from pyhrg.records.campaign_import import import_campaign

    if options.out is not None:
        check_output_folder(options.out)
    imported = import_campaign(options.mapping, options.out, force=options.force)
    campaign = imported.campaign_as_read
    print(
        f"{imported.preview}\n\n{describe_preparation(campaign)}\n\n{describe_readiness(campaign)}"
    )
    if options.out is not None:
        print(f"\nwritten to {options.out}")


def _draft(options: argparse.Namespace) -> None:
    from pyhrg.records.campaign_import import draft_mapping

    if options.out.exists():
        raise HrgError(f"{options.out}: found a file, expected none: choose another --out")
    check_output_folder(options.out.parent)
    write_whole(options.out, draft_mapping(options.logs, options.out.parent).encode())
    print(f"written to {options.out}; edit it, then: hrg campaign import {options.out} --check")
