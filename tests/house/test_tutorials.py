"""Every block of every tutorial runs, in the order of its page, in an empty folder."""

import re
import shlex
from pathlib import Path

import matplotlib as mpl
import pytest

from pyhrg.common.cli import main

TUTORIALS = sorted((Path(__file__).parents[2] / "docs" / "tutorials").glob("[a-z]*.md"))


@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_a_tutorial_runs(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A block is a file (its name stands behind the language), commands, or Python."""
    monkeypatch.chdir(tmp_path)
    mpl.use("agg")
    names: dict[str, object] = {}
    blocks = re.findall(r"```(\w+) ?(\S*)\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
    for language, name, text in blocks:
        if name:
            (tmp_path / name).write_text(text, encoding="utf-8")
        elif language == "python":
            exec(compile(text, page.name, "exec"), names)
        else:
            assert language == "console"
            for command in re.findall(r"^\$ hrg (.*)$", text, re.M):
                assert main(shlex.split(command)) == 0, capsys.readouterr()
    assert len(blocks) > 2
