"""The command `hrg` loads what is asked for, and no more."""

import os
import re
import subprocess
import sys
from pathlib import Path
from unittest.mock import Mock

import pytest

from pyhrg.common.cli import main

HEAVY = ("dask", "fmpy", "matplotlib", "numba", "numpy", "pandas", "scipy", "xarray")
CODE = """
import sys
{statement}
print(sorted(set(sys.modules) & set({heavy!r})))
"""
HELP = """
from pyhrg.common.cli import main
try:
    main(["--help"])
except SystemExit:
    pass
"""


def loaded_by(statement: str) -> str:
    code = CODE.format(statement=statement, heavy=HEAVY)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return run.stdout.splitlines()[-1]


def test_another_programs_choice_of_figures_is_not_the_commands() -> None:
    """As in a notebook, whose shell commands are told its backend."""
    code = "import sys; from pyhrg.common.cli import main; sys.exit(main(['allan', 'nowhere']))"
    environment = {**os.environ, "MPLBACKEND": "nowhere"}
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stderr) == (
        2,
        "hrg: nowhere: can't be read: No such file or directory\n",
    )


def test_help_loads_nothing_heavy() -> None:
    assert loaded_by(HELP) == "[]"


def test_the_front_doors_load_nothing_heavy() -> None:
    assert loaded_by("import pyhrg, ins_eval") == "[]"


@pytest.mark.parametrize(
    "arguments",
    [
        ["gap", "diagnose", "nowhere", "--out", "file/out"],
        ["gap", "predict", "nowhere", "nowhere", "--campaign", "nowhere", "--out", "file/out.csv"],
        ["gap", "challenge", "--out", "file/out"],
        ["position", "file/out"],
        ["bench", "fixed-position", "--out", "file/out"],
        ["allan", "nowhere", "--out", "file/out"],
        ["campaign", "init", "nowhere", "--out", "file/mapping.toml"],
        ["campaign", "import", "nowhere", "--out", "file/out"],
        ["validate", "--out", "file/out"],
        ["study", "--out", "file/out"],
        ["study", "challenge", "--seed", "1", "--out", "file/out"],
        ["build", "--out", "file/HRG.fmu"],
        ["nav", "--out", "file/out"],
        ["align", "--out", "file/out"],
        ["parking", "--out", "file/out"],
        ["schedule", "--out", "file/out"],
    ],
    ids=lambda arguments: " ".join(arguments[:2]),
)
def test_an_output_that_cannot_be_written_is_refused_before_the_work(
    arguments: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    assert re.fullmatch(r"hrg: .*file: it is no folder\n", capsys.readouterr().err)


@pytest.mark.parametrize("text", ["1_0", " 1", "１", "1e400x", ""])
def test_numbers_are_ascii_digits(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    for option, kind in (("--workers", "whole number"), ("--hours", "number")):
        with pytest.raises(SystemExit) as end:
            main(["validate", option, text])
        assert end.value.code == 2
        assert f"found {text!r}, expected a {kind}" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("interruption", "said"),
    [
        (KeyboardInterrupt(), "hrg: interrupted; nothing was written\n"),
        (KeyboardInterrupt("interrupted; goes on"), "hrg: interrupted; goes on\n"),
    ],
)
def test_an_interruption_is_said(
    interruption: KeyboardInterrupt,
    said: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("pyhrg.cli.bench.run", Mock(side_effect=interruption))
    assert main(["bench", "fixed-position"]) == 130
    assert capsys.readouterr().err == said


@pytest.mark.parametrize(
    "arguments",
    [
        ["--quiet", "build", "--out", "HRG.fmu"],
        ["build", "--quiet", "--out", "HRG.fmu"],
        ["build", "--out", "HRG.fmu"],
    ],
    ids=lambda arguments: arguments[0],
)
def test_quiet_leaves_results_alone(
    arguments: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 0
    written = capsys.readouterr()
    assert written.out == "HRG.fmu\n"
    assert (written.err == "") == ("--quiet" in arguments)


@pytest.fixture(scope="module")
def completion(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The script for bash."""
    code = "from pyhrg.common.cli import main; main(['--completion', 'bash'])"
    script = tmp_path_factory.mktemp("completion") / "hrg.bash"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
    script.write_bytes(run.stdout)
    return script


@pytest.mark.needs("bash")
@pytest.mark.parametrize(
    ("words", "completed"),
    [
        (["be"], "bench"),
        (["bench", "full-c"], "full-circumference"),
        (["bench", "--dev"], "--device"),
        (["gap", "diagnose", "--bel"], "--belief"),
        (["validate", "--calibration", "me"], "mean"),
        (["allan", "rec"], "record.csv"),
        (["bench", "all", "--campaign", "c"], "campaign"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_the_shell_completes(
    completion: Path, words: list[str], completed: str, tmp_path: Path
) -> None:
    (tmp_path / "record.csv").touch()
    (tmp_path / "campaign").mkdir()
    code = 'source "$0"; COMP_WORDS=(hrg "$@"); COMP_CWORD=$#; _shtab_hrg; echo "${COMPREPLY[@]}"'
    command = ["bash", "-c", code, str(completion), *words]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (run.stdout.strip(), run.stderr) == (completed, "")
