"""Names that hold markup show as text on the pages that commands write.

Names in a diagnosis and in a study are tried beside their pages (`test_page.py`)."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.cli import main

EVIL = "<img src=x onerror=alert(1)>"
"""A name of a file, too."""
Arguments = list[str | Path]


@pytest.fixture
def record(tmp_path: Path) -> Path:
    """Five minutes of an IMU's noise."""
    path = tmp_path / f"record {EVIL}.csv"
    noise = np.random.default_rng(1).normal(0, 1e-6, (3000, 6))
    units = [(sensor, unit) for sensor, unit in (("gyro", "deg_s"), ("accelerometer", "m_s2"))]
    names = ["time_s", *(f"{sensor}_{axis}_{unit}" for sensor, unit in units for axis in "xyz")]
    table = np.column_stack([0.1 * np.arange(1, 3001), noise])
    np.savetxt(path, table, delimiter=",", header=",".join(names), comments="")
    return path


def bench(record: Path, out: Path) -> Arguments:
    device = record.with_name(f"device {EVIL}.toml")
    device.write_text(f'name = "{EVIL}"\n')
    return ["bench", "amplitude-sweep", "--device", device, "--out", out]


def allan(record: Path, out: Path) -> Arguments:
    return ["allan", record, "--trusted", "--out", out]


def diagnose(record: Path, out: Path) -> Arguments:
    belief = record.with_name(f"belief {EVIL}.toml")
    belief.write_text("[gyros]\nangle_random_walk_deg_sqrt_h = 1e-5\n")
    return ["gap", "diagnose", record, "--belief", belief, "--trusted", "--out", out]


@pytest.mark.parametrize("command", [bench, allan, diagnose])
def test_names_are_text(
    record: Path, tmp_path: Path, command: Callable[[Path, Path], Arguments]
) -> None:
    arguments = command(record, tmp_path / "out")
    assert main([str(argument) for argument in arguments]) == 0
    texts = [path.read_text() for path in (tmp_path / "out").rglob("*.html")]
    assert not any("<img src=x" in text for text in texts)
    assert any("&lt;img src=x" in text for text in texts)
