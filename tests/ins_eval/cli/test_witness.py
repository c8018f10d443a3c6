"""`hrg witness` from the command line, on a simulated flight."""

import argparse
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


def test_it_prints_map_changes_and_worth(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = [str(folder / "flight.csv"), "--device", str(folder / "gyro.toml"), "--hours", "0.2"]
    witness.run(parse(*words))
    printed = capsys.readouterr().out
    assert "bias map, deg/h" in printed
    assert "drive non-orthogonality" in printed
    worth = [line.split() for line in printed.splitlines() if "gyro pointing" in line]
    assert len(worth) == 3
    assert all(float(words[3]) < float(words[-3]) for words in worth)


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
