"""Every block of every tutorial and first page runs, in order, in an empty folder, and prints what
the page shows."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import pytest

from pyhrg.common.cli import main
from tests.ins_eval.flights.test_documentation import assert_alike
from tests.modules import load_file

DOCS = Path(__file__).parents[2] / "docs"
OUTPUT = re.compile(r"\n*^```\n(.*?)^```$", re.DOTALL | re.MULTILINE)
"""What a block prints: a fence without a language, right behind it."""
PAGES = sorted((*DOCS.glob("tutorials/[a-z]*.md"), *DOCS.glob("start/[a-z]*.md")))


def run_command(command: str) -> None:
    """Run one command line: `hrg` within this process, other programs in a shell."""
    if command.startswith("hrg "):
        assert main(shlex.split(command)[1:]) == 0
        return
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    subprocess.run(command, shell=True, check=True, env={**os.environ, "PATH": path})


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_tutorial_runs(
    page: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A block is a file (its name stands behind the language), commands, or Python."""
    monkeypatch.chdir(tmp_path)
    mpl.use("agg")
    names: dict[str, object] = {}
    notebooks = load_file(DOCS / "site" / "notebooks.py")
    source = page.read_text(encoding="utf-8")
    blocks = list(notebooks.BLOCK.finditer(source))
    for block in blocks:
        language, name, text = block.groups()
        if name:
            (tmp_path / name).write_text(text, encoding="utf-8")
        elif language == "python":
            exec(compile(text, page.name, "exec"), names)
        else:
            assert language == "console"
            for command in re.findall(r"^\$ (.*)$", text, re.M):
                run_command(command)
        printed = capsys.readouterr().out.splitlines()
        if shown := OUTPUT.match(source, block.end()):
            for found, expected in zip(printed, shown[1].splitlines(), strict=True):
                assert_alike(found, expected)
    assert len(blocks) > 2
