"""Logs in the text format of KF-GINS."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.flights import sources
from pyhrg.common.errors import HrgError
from tests.ins_eval.imu.logs import resting


def write(folder: Path, extra: str = "") -> Path:
    log = resting(20.0)
    table = np.column_stack([log.bounds[1:], log.rotation, log.velocity])
    path = folder / "imu.txt"
    path.write_text("".join("  ".join(f"{x:.17g}" for x in row) + f"{extra}\n" for row in table))
    return path


@pytest.mark.parametrize("extra", ["", " 3.5"])
def test_increments_are_read_to_the_bit(tmp_path: Path, extra: str) -> None:
    found, truth = sources.read_record(write(tmp_path, extra)).increments, resting(20.0)
    np.testing.assert_array_equal(found.rotation, truth.rotation)
    np.testing.assert_array_equal(found.velocity, truth.velocity)
    assert found.start == pytest.approx(truth.start, abs=1e-9)


def test_what_is_wrong_is_named(tmp_path: Path) -> None:
    path = write(tmp_path)
    lines = path.read_text().splitlines()
    for changed, message in (
        ([*lines[:5], *lines[9:]], r"row 6, time_s: .* rows missing"),
        ([*lines[:5], "1 2 3", *lines[5:]], "row 6: found 3 fields, expected 7"),
    ):
        path.write_text("\n".join(changed))
        with pytest.raises(HrgError, match=message):
            sources.read_record(path)
