"""The output folder of `hrg bench`: one run's tests, all of them on its page."""

import shutil
from pathlib import Path

import pytest

from tests.pyhrg.bench.quick import PROCEDURES
from tests.pyhrg.cli.bench_runs import contents, device, hrg

pytestmark = pytest.mark.usefixtures("short_tests")


def test_the_page_shows_all_tests_in_its_folder(done: Path, tmp_path: Path) -> None:
    """The tests one after the other give the page of all at once."""
    for procedure in reversed(PROCEDURES):
        assert hrg(procedure.name, "--out", tmp_path, "--seed", 7) == 0
    assert contents(tmp_path) == contents(done)


@pytest.mark.parametrize(
    ("arguments", "differs"),
    [
        (["--seed", "8"], "seed: found 7, expected 8"),
        (["--device", "table2"], "device: found 'typical', expected "),
        (["--device", "gyro.toml"], "device: found 'typical' with other values than now"),
    ],
    ids=["seed", "device", "parameters"],
)
def test_results_of_another_run_are_kept_unless_forced(
    done: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    differs: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    device(tmp_path, "name = 'typical'\n")
    shutil.copytree(done, tmp_path / "out")
    asked = ["fixed-position", "--out", "out", "--seed", "7", *arguments]
    assert hrg(*asked) == 2
    error = capsys.readouterr().err
    assert f"another run: {differs}" in error
    assert "--force" in error
    assert contents(tmp_path / "out") == contents(done)
    assert hrg(*asked, "--force") == 0
    folders = [path.name for path in (tmp_path / "out").iterdir() if path.is_dir()]
    assert folders == ["fixed-position"]


def test_results_of_another_version_are_kept(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(done, tmp_path / "out")
    file = tmp_path / "out" / "full-circumference" / "result.json"
    file.write_text(file.read_text().replace('"numpy": "', '"numpy": "0.'))
    assert hrg("fixed-position", "--out", tmp_path / "out", "--seed", 7) == 2
    assert "another run: made_by.numpy: found '0." in capsys.readouterr().err


def test_the_page_fits_a_phone(done: Path) -> None:
    """Its width is that of the screen, and a table that is wider scrolls by itself."""
    text = (done / "report.html").read_text()
    assert '<meta name="viewport" content="width=device-width' in text
    assert text.count("<table>") == text.count('<div class="wide"><table>') > 0
