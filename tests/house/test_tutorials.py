"""Every block of every tutorial and first page runs, in order, in an empty folder."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import pytest

from pyhrg.common.cli import main
from tests.modules import load_file

DOCS = Path(__file__).parents[2] / "docs"
PAGES = sorted((*DOCS.glob("tutorials/[a-z]*.md"), *DOCS.glob("start/[a-z]*.md")))


def run_command(command: str) -> None:
    """Run one command line: `hrg` within this process, other programs in a shell."""
    if command.startswith("hrg "):
        assert main(shlex.split(command)[1:]) == 0
        return
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    subprocess.run(command, shell=True, check=True, env={**os.environ, "PATH": path})


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_tutorial_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A block is a file (its name stands behind the language), commands, or Python."""
    monkeypatch.chdir(tmp_path)
    mpl.use("agg")
    names: dict[str, object] = {}
    notebooks = load_file(DOCS / "site" / "notebooks.py")
    blocks = notebooks.BLOCK.findall(page.read_text(encoding="utf-8"))
    for language, name, text in blocks:
        if name:
            (tmp_path / name).write_text(text, encoding="utf-8")
        elif language == "python":
            exec(compile(text, page.name, "exec"), names)
        else:
            assert language == "console"
            for command in re.findall(r"^\$ (.*)$", text, re.M):
                run_command(command)
    assert len(blocks) > 2
