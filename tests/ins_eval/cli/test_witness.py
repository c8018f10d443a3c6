"""`hrg witness` from the command line, on a simulated flight."""

import argparse
import io
import json
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import pytest

import pyhrg
from ins_eval.cli import witness
from pyhrg.common.errors import HrgError
from pyhrg.device import device_file
from pyhrg.fmu import GyroFmu
from pyhrg.witness.mechanisms import change_device
from tests.pyhrg.witness.flights import GYRO, PRIOR, draw_changes, fly


def parse(*words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    witness.add_options(parser)
    return parser.parse_args(words)


@pytest.fixture(scope="module")
def folder(fmu: GyroFmu, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A flight's log and the device that was calibrated."""
    path = tmp_path_factory.mktemp("witness")
    changed = change_device(GYRO, draw_changes(PRIOR, np.random.default_rng(3)))
    pyhrg.write_log(fly(fmu, changed, 300.0, 3, self_test=True), path / "flight.csv")
    device_file.write(GYRO, path / "gyro.toml")
    return path


@pytest.fixture(scope="module")
def command(folder: Path) -> argparse.Namespace:
    words = [str(folder / "flight.csv"), "--device", str(folder / "gyro.toml"), "--hours", "0.2"]
    return parse(*words)


@pytest.fixture(scope="module")
def printed(command: argparse.Namespace) -> tuple[str, pyhrg.MapEstimate]:
    """What the command printed, and the estimate that it printed."""
    found: list[pyhrg.MapEstimate] = []
    estimate_map = pyhrg.estimate_map
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(io.StringIO()) as out:
        patch.setattr(pyhrg, "estimate_map", lambda *a: found.append(estimate_map(*a)) or found[0])
        witness.run(command)
    return out.getvalue(), found[0]


def test_it_prints_map_changes_and_worth(printed: tuple[str, pyhrg.MapEstimate]) -> None:
    text, _ = printed
    assert "bias map, deg/h" in text
    assert "drive non-orthogonality" in text
    worth = [line.split() for line in text.splitlines() if "gyro pointing" in line]
    assert len(worth) == 3
    assert all(float(words[3]) < float(words[-3]) for words in worth)


def test_a_program_reads_the_same(
    command: argparse.Namespace,
    printed: tuple[str, pyhrg.MapEstimate],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    text, found = printed
    monkeypatch.setattr(pyhrg, "estimate_map", lambda *_: found)
    witness.run(argparse.Namespace(**{**vars(command), "json": True}))
    read = json.loads(capsys.readouterr().out)
    lines = [line.split() for line in text.splitlines()]
    (mean,) = (words[1:] for words in lines if words[:1] == ["mean"])
    assert [f"{x:.5f}" for x in read["bias_map_deg_h"]["mean"].values()] == mean
    worth = {words[2]: words[3] for words in lines if words[:1] == ["gyro"]}
    assert {a: f"{x['with_log']:.0f}" for a, x in read["position_rms_m"].items()} == worth
    assert read["is_explained"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--age-days", "-1"], "--age-days"),
        (["--ageing-share", "2"], "--ageing-share"),
        (["--hours", "0"], "hours"),
    ],
)
def test_bad_options_are_refused(folder: Path, options: list[str], message: str) -> None:
    words = [str(folder / "flight.csv"), "--device", str(folder / "gyro.toml"), *options]
    with pytest.raises(HrgError, match=message):
        witness.run(parse(*words))
