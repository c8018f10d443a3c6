"""`hrg study`: what it refuses, before anything is written; a complete study is told."""

from pathlib import Path

import pytest

from ins_eval.study import run_study, study_file
from ins_eval.study.run import block
from ins_eval.study.run.block import identify_study
from ins_eval.study.run.folder import claim_folder
from pyhrg.common.cli import main
from tests.ins_eval.study import cases
from tests.ins_eval.study.run.cheap import CHEAP, conclude, made


@pytest.fixture(autouse=True)
def cheap(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_study, "make_experiment", lambda study: CHEAP)
    monkeypatch.setattr(run_study.StudyResult, "verdict", "cheap")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            ["huge"],
            "huge: found no such file and no ready study of this name, expected a file or narrow",
        ),
        (["small", "--seed", "-1"], "small.toml: seed: found -1, expected a whole number from 0"),
        (["small", "--workers", "0"], "workers: found 0, expected a whole number from 1"),
        (["small", "--workers", "1", "--scheduler", "tcp://a:1"], "not allowed with argument"),
        (["small", "--scheduler", "a:1"], "a:1: found no address, expected tcp://HOST:PORT"),
    ],
)
def test_wrong_options_are_refused(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        status: int | str | None = main(["study", *options, "--out", str(tmp_path / "out")])
    except SystemExit as exited:
        status = exited.code
    assert status == 2
    assert message in capsys.readouterr().err


def test_folder_that_can_not_be_made_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    out = tmp_path / "file" / "out"
    assert main(["study", "small", "--out", str(out)]) == 2
    assert f"hrg: {out.parent}: it is no folder" in capsys.readouterr().err


def test_study_whose_blocks_are_all_there_is_concluded(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = cases.study_file(tmp_path), tmp_path / "out"
    study = study_file.read_study(file)
    with claim_folder(out, identify_study(study)) as folder:
        for number in range(block.count_blocks(study)):
            work = block.BlockWork(study, folder.identity, made)
            folder.keep(number, work(number))
    assert main(["study", str(file), "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert said.out == (
        f"cheap\n\nwritten to {out}: {', '.join(CHEAP.files)}\n"
        f"to read, open {out / 'report.html'} in a browser\n"
    )
    conclude(study, block.join_blocks([made(study, range(75))]), tmp_path)
    for name in CHEAP.files:
        assert (out / name).read_bytes() == (tmp_path / name).read_bytes()
