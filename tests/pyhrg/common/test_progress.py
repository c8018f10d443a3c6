"""One way to show progress: a bar on a terminal, lines everywhere, nothing unasked."""

import io
import sys

import pytest

from pyhrg.common import progress
from pyhrg.common.progress import Progress, Show


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def show(show: Show) -> None:
    """Three flights, the second of which says a line."""
    with Progress(show, "flights", "runs") as bar:
        for done in range(3):
            bar.update(done, 2)
            if done == 1:
                bar.say("one flew")


@pytest.fixture(autouse=True)
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "DELAY", 0.0)


def test_a_terminal_shows_share_and_remaining_time(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    show(True)
    first, after = terminal.getvalue().split("one flew\n")
    assert "flights   0%|" in first
    assert "0/2 runs [00:00<?]" in first
    assert "flights  50%|" in after
    assert "1/2 runs [00:00<00:00]" in after


def test_no_bar_goes_into_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    show(True)
    assert capsys.readouterr().err == "one flew\n"


def test_a_pipe_gets_a_line_now_and_then(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(progress, "LINE_SPACING", 0.0)
    show(True)
    assert capsys.readouterr().err == (
        "flights: 0 of 2 runs\nflights: 1 of 2 runs\none flew\nflights: 2 of 2 runs\n"
    )


def test_a_function_gets_each_line(capsys: pytest.CaptureFixture[str]) -> None:
    lines: list[str] = []
    show(lines.append)
    assert lines == ["one flew"]
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("asked", [None, False])
def test_unasked_it_is_silent(asked: Show, capsys: pytest.CaptureFixture[str]) -> None:
    show(asked)
    assert capsys.readouterr().err == ""
