"""`hrg campaign`: campaigns as folders."""

import argparse
from pathlib import Path

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
    where.add_argument(
        "--check", action="store_true", help="say what was understood, and write nothing"
    )


def run(options: argparse.Namespace) -> None:
    from pyhrg.bench.session import describe_readiness
    from pyhrg.gap.soundness import describe_screening
    from pyhrg.records.campaign_import import import_campaign

    imported = import_campaign(options.mapping, options.out)
    campaign = imported.campaign_as_read
    print(f"{imported.preview}\n\n{describe_screening(campaign)}\n\n{describe_readiness(campaign)}")
    if options.out is not None:
        print(f"\nwritten to {options.out}")
