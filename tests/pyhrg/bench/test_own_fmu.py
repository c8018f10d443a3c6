"""An FMU of a user's own class in the place of the package's."""

import shutil
from pathlib import Path

import pandas as pd
import pytest

from fmu_build.bundle import build_fmu
from pyhrg import run_test
from pyhrg.common.errors import HrgError


def test_it_is_tested_with_the_parameters_of_a_device(tmp_path: Path) -> None:
    """The package's own gyro from a file gives the same numbers, under another identity. A class
    that holds a gyro is tested in docs/tutorials/mechanism.md."""
    file = Path(shutil.copy(build_fmu(), tmp_path / "mine.fmu"))
    plain = run_test("phase-step", "typical", out=tmp_path / "plain")
    own = run_test("phase-step", "typical", fmu=file, out=tmp_path / "own")
    pd.testing.assert_frame_equal(own.findings, plain.findings)
    assert own.identity["device"] == "typical in mine.fmu"
    assert own.identity["device_sha256"] != plain.identity["device_sha256"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mine.fmu", "own", "plain"]
    with pytest.raises(HrgError, match=r"device: found 'typical in mine.fmu', expected 'typical'"):
        run_test("phase-step", "typical", out=tmp_path / "own")


def test_it_needs_a_device(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="fmu: found no device beside it"):
        run_test("phase-step", fmu=tmp_path / "mine.fmu")
    with pytest.raises(HrgError, match=r"none\.fmu"):
        run_test("phase-step", "typical", fmu=tmp_path / "none.fmu")
