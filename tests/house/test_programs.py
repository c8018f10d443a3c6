"""A test whose program is missing is listed as not run, and fails where all are required."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.programs import REQUIRE_VARIABLE

ROOT = Path(__file__).parents[2]
MODULE = """
import pytest

@pytest.fixture
def expensive():
    raise AssertionError("a fixture was made for a test that can't run")

@pytest.mark.needs("no-such-program")
def test_marked(expensive): pass

@pytest.mark.parametrize("x", [1, pytest.param(2, marks=pytest.mark.needs("no-such-program"))])
def test_parameter(x): pass

@pytest.mark.needs("python-of-nobody", "sh")
def test_other(): pass

@pytest.mark.needs("sh")
def test_present(): pass

@pytest.mark.skip(reason="its data are not here")
def test_data(): pass
"""


def run_pytest(folder: Path, processes: int, required: str) -> subprocess.CompletedProcess[str]:
    """Run the module above by itself."""
    (folder / "test_module.py").write_text(MODULE)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "tests.programs", "-c", os.devnull]
    command += ["-p", "no:cacheprovider", "-n", str(processes), str(folder)]
    environment = {**os.environ, REQUIRE_VARIABLE: required, "PYTHONPATH": str(ROOT)}
    environment.pop("PYTEST_XDIST_WORKER", None)
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("processes", [0, 2])
def test_what_could_not_run_is_listed(tmp_path: Path, processes: int) -> None:
    run = run_pytest(tmp_path, processes, required="")
    assert run.returncode == 0, run.stdout + run.stderr
    listed = [line for line in run.stdout.splitlines() if line.startswith("not run: ")]
    assert listed == [
        "not run: needs no-such-program: 2 tests",
        "not run: needs python-of-nobody: 1 test",
    ]
    assert "2 passed, 4 skipped" in run.stdout


def test_a_missing_program_fails_where_all_are_required(tmp_path: Path) -> None:
    run = run_pytest(tmp_path, 2, required="1")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "no-such-program is missing: CONTRIBUTING.md says how" in run.stdout
    assert "2 passed, 1 skipped, 3 errors" in run.stdout


def test_ci_requires_all_programs() -> None:
    assert f"export {REQUIRE_VARIABLE}=1\n" in (ROOT / ".ci" / "run").read_text()
