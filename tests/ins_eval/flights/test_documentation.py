"""docs/navigation.md says what the commands do."""

import argparse
from pathlib import Path

import pytest

from ins_eval.cli import align, nav
from ins_eval.flights import align_report
from ins_eval.results.quantities import ALL
from pyhrg.common.cli import Command, main
from tests.ins_eval.cli.test_nav import SIMULATED

PAGE = (Path(__file__).parents[3] / "docs" / "navigation.md").read_text()


def assert_alike(found: str, expected: str) -> None:
    """The same words; numbers, between punctuation, to 1 % or to 0.01 of their unit."""
    for word, wanted in zip(found.split(), expected.split(), strict=True):
        try:
            number, right = (float(each.strip("(),;:")) for each in (word, wanted))
            assert number == pytest.approx(right, rel=0.01, abs=0.01), found
        except ValueError:
            assert word == wanted, found


def test_example_prints_what_it_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    command, _, output = PAGE.split("```console\n$ hrg ")[1].split("```")[0].partition("\n")
    assert main(command.split()) == 0
    printed = capsys.readouterr().out
    assert len(printed.splitlines()) == len(output.splitlines()), printed
    for found, expected in zip(printed.splitlines(), output.splitlines(), strict=True):
        assert_alike(found, expected)


def test_every_column_is_listed() -> None:
    for quantity in ALL:
        assert f"| `{quantity.column}` | {quantity.meaning} |\n" in PAGE


@pytest.mark.parametrize("command", [nav, align])
def test_every_option_is_listed(command: Command) -> None:
    parser = argparse.ArgumentParser(add_help=False)
    command.add_options(parser)
    for action in parser._actions:
        for option in action.option_strings:
            assert f"`{option}`" in PAGE


def test_every_file_is_listed() -> None:
    for name in (*SIMULATED, *align_report.FILES):
        assert f"`{name}`" in PAGE
