"""Format, style, types and import rules: the same tools that a developer runs."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    "command",
    [
        ["ruff", "format", "--check", "."],
        ["ruff", "check", "."],
        [sys.executable, "-m", "mypy"],
        ["lint-imports"],
    ],
    ids=["format", "style", "types", "imports"],
)
def test_tool_finds_nothing(command: list[str]) -> None:
    if command[0] != sys.executable:
        command = [str(Path(sys.executable).parent / command[0]), *command[1:]]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
