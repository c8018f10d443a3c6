"""The command `hrg`: each package brings its own subcommands as entry points."""

import argparse
import os
import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points, version
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
    """Run `hrg`; returns the exit status: 0, 2 for a user's error, 130 when interrupted, 141 when
    nobody reads the output to its end."""
    try:
        return _reported(arguments)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141


def _reported(arguments: Sequence[str] | None) -> int:
    try:
        return _dispatch(arguments)
    except UserError as error:
        print(f"hrg: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as interruption:
        print(f"hrg: {interruption or 'interrupted; nothing was written'}", file=sys.stderr)
        return 130
    finally:
        sys.stdout.flush()


def _dispatch(arguments: Sequence[str] | None) -> int:
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    parser = _Parser(
        prog="hrg", description="Whole-angle hemispherical resonator gyro: model, bench, navigation"
    )
    parser.add_argument("--version", action="version", version=version("hrg"))
    subparsers = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    commands = {}
    for entry in _asked_for(sys.argv[1:] if arguments is None else arguments):
        command: Command = entry.load()
        commands[entry.name] = command
        command.add_options(
            subparsers.add_parser(entry.name, help=command.help, description=command.help)
        )
    options = parser.parse_args(arguments)
    commands[options.command].run(options)
    return 0


def _asked_for(arguments: Sequence[str]) -> list[EntryPoint]:
    """The subcommand that the arguments begin with, alone: others bring libraries that take
    seconds to load. All, to say what there is, where they begin otherwise."""
    every = sorted(entry_points(group="hrg.commands"), key=lambda e: e.name)
    return [entry for entry in every if entry.name in arguments[:1]] or every
