"""The command `hrg`: each package brings its own subcommands as entry points."""

import argparse
import difflib
import os
import signal
import sys
from collections.abc import Collection, Mapping, Sequence
from functools import partial
from importlib.metadata import EntryPoint, entry_points, version
from pathlib import Path
from typing import Any, NoReturn, Protocol

from pyhrg.common.errors import HrgError, fold_line

SINGLE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
"""Variables that make linear algebra run in one thread, unless the user sets them: more threads
slow its small matrices down, and large work is shared among processes."""
MIN_LIKENESS = 0.7
"""Share of equal letters from which an option that is not known is taken for a known one. Chosen:
`--devise` is `--device`, `--bogus` is nothing."""


class Command(Protocol):
    """A module of a package's `cli` folder: one subcommand of `hrg`.

    `hrg --help` loads all of them, so that a module imports nothing heavy at its top: it parses,
    calls the front door (`pyhrg`, `ins_eval`), and prints.
    """

    HELP: str
    """What the subcommand does, one line."""

    def add_options(self, parser: argparse.ArgumentParser) -> None:
        """Declare the options; called only when the subcommand is asked for."""

    def run(self, options: argparse.Namespace) -> None:
        """Do what the options ask for."""


class _Parser(argparse.ArgumentParser):
    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.register("type", int, partial(_parse_number, int))
        self.register("type", float, partial(_parse_number, float))
        self.add_argument(
            "--quiet", action="store_true", default=argparse.SUPPRESS, help="show no progress"
        )

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """As of any parser, but an option that is close to a known one is named."""
        options, unknown = super().parse_known_args(args, namespace)
        for text in unknown:
            name = text.partition("=")[0]
            known = [name for action in self._actions for name in action.option_strings]
            close = difflib.get_close_matches(name, known, n=1, cutoff=MIN_LIKENESS)
            if name.startswith("--") and close:
                self.error(f"found {name}, expected {close[0]}")
        return options, unknown

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """As of any parser, but of many choices the closest one is named."""
        if action.choices is not None and value not in action.choices:
            known = [str(choice) for choice in action.choices]
            close = difflib.get_close_matches(str(value), known, n=1)
            expected = " or ".join(close) or f"one of {', '.join(known)}"
            raise argparse.ArgumentError(action, f"found {value!r}, expected {expected}")

    def error(self, message: str) -> NoReturn:
        """One clear line, as for every user's error."""
        self.exit(2, f"{fold_line(f'{self.prog}: {message}')}\n")


def _parse_number(kind: type[int] | type[float], text: str) -> float:
    """A number in ASCII digits; Python's own readers take `1_0`, blanks and any script's digits."""
    try:
        if "_" in text or not text.isascii() or text != text.strip():
            raise ValueError
        return kind(text)
    except ValueError:
        number = "a whole number" if kind is int else "a number"
        raise argparse.ArgumentTypeError(f"found {text!r}, expected {number}") from None


def main(arguments: Sequence[str] | None = None) -> int:
    """Run `hrg`; returns the exit status: 0, 2 for a user's error, 130 when interrupted, 141 when
    nobody reads the output to its end."""
    try:
        return _report_errors(arguments)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141


def _report_errors(arguments: Sequence[str] | None) -> int:
    try:
        return _dispatch(arguments)
    except HrgError as error:
        print(f"hrg: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        raise
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        print(f"hrg: {fold_line(f'{place}{error.strerror or error}')}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as interruption:
        print(f"hrg: {str(interruption) or 'interrupted; nothing was written'}", file=sys.stderr)
        return 130
    finally:
        sys.stdout.flush()


def _find_commands() -> dict[str, EntryPoint]:
    installed = sorted(entry_points(group="hrg.commands"), key=lambda entry: entry.name)
    return {entry.name: entry for entry in installed}


def _make_parser(commands: Mapping[str, Command], asked: Collection[str]) -> _Parser:
    """The parser of `hrg` with these subcommands, and with the options of those that are asked."""
    parser = _Parser(
        prog="hrg", description="Whole-angle hemispherical resonator gyro: model, bench, navigation"
    )
    parser.add_argument("--version", action="version", version=version("hrg"))
    parser.add_argument(
        "--completion",
        action=_Completion,
        choices=("bash", "zsh"),
        help="print the shell's script that completes commands and options, and exit",
    )
    subparsers = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, command in commands.items():
        subparser = subparsers.add_parser(name, help=command.HELP, description=command.HELP)
        if name in asked:
            command.add_options(subparser)
    return parser


class _Completion(argparse.Action):
    """Prints a shell's script, from the options of all subcommands."""

    def __call__(self, parser: argparse.ArgumentParser, *values: Any) -> NoReturn:
        import shtab

        commands = {name: entry.load() for name, entry in _find_commands().items()}
        whole = _make_parser(commands, commands)
        _mark_files(whole)
        print(shtab.complete(whole, values[1]))
        parser.exit()


def _mark_files(parser: argparse.ArgumentParser) -> None:
    """Tell shtab which arguments are files or folders."""
    import shtab

    for action in parser._actions:
        if isinstance(action.choices, Mapping):  # subcommands
            for subparser in action.choices.values():
                _mark_files(subparser)
        elif action.type is Path:
            is_folder = action.metavar == "DIR"
            action.complete = shtab.DIRECTORY if is_folder else shtab.FILE  # type: ignore[attr-defined]


def _dispatch(arguments: Sequence[str] | None) -> int:
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    for variable in SINGLE_THREAD:  # before a subcommand imports numpy
        os.environ.setdefault(variable, "1")
    os.environ["MPLBACKEND"] = "agg"  # figures go to files; a notebook's backend is not for them
    given = sys.argv[1:] if arguments is None else arguments
    asked = [text for text in given if not text.startswith("-")][:1]
    installed = _find_commands()
    # the subcommand that is asked for, alone; all of them where none is
    chosen = {name: entry for name, entry in installed.items() if name in asked} or installed
    commands: dict[str, Command] = {name: entry.load() for name, entry in chosen.items()}
    parser = _make_parser(commands, asked)
    options = parser.parse_args(arguments, argparse.Namespace(quiet=False))
    commands[options.command].run(options)
    return 0


def collect_given(options: argparse.Namespace, names: Sequence[str]) -> dict[str, Any]:
    """The options among these that were given, as keyword arguments; the others keep the front
    door's defaults."""
    values = {name: getattr(options, name) for name in names}
    return {name: value for name, value in values.items() if value is not None}


def refuse(options: argparse.Namespace, names: Sequence[str], reason: str) -> None:
    """Refuse options that do not go with the others."""
    for name in names:
        if getattr(options, name) not in (None, False):
            raise HrgError(f"--{name.replace('_', '-')}: {reason}")
