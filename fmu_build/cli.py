"""The command `hrg`: each package brings its own subcommands as entry points."""

import argparse
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import entry_points
from typing import NoReturn


class UserError(Exception):
    """Something that the user can mend; one clear line, exit status 2."""


@dataclass(frozen=True)
class Command:
    """A subcommand: what it is for, its options, and what it does with them."""

    help: str
    add_options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], None]


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """One clear line, as for every user's error."""
        self.exit(2, f"{self.prog}: {message}\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run `hrg`; returns the exit status: 0, 2 for a user's error, 130 when interrupted."""
    parser = _Parser(
        prog="hrg", description="Whole-angle hemispherical resonator gyro: model, bench, navigation"
    )
    subparsers = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    commands = {}
    for entry in sorted(entry_points(group="hrg.commands"), key=lambda e: e.name):
        command: Command = entry.load()
        commands[entry.name] = command
        command.add_options(
            subparsers.add_parser(entry.name, help=command.help, description=command.help)
        )
    options = parser.parse_args(arguments)
    try:
        commands[options.command].run(options)
    except UserError as error:
        print(f"hrg {options.command}: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"hrg {options.command}: interrupted; nothing was written", file=sys.stderr)
        return 130
    return 0
