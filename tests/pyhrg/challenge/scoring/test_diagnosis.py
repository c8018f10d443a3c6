"""The scored parts of a `diagnosis.json`."""

from dataclasses import replace
from pathlib import Path

import pytest

from pyhrg.challenge.scoring.diagnosis import read_scored
from pyhrg.gap.findings.diagnosis import FILE, DiagnosisError, NextTest, write
from pyhrg.gap.findings.localisation import Place
from tests.pyhrg.challenge.test_run import FIGURE, NO_GAP


def test_the_scored_parts_are_read(tmp_path: Path) -> None:
    gap = replace(NO_GAP.gap, holdout_angle_arcsec=replace(FIGURE, after=1.2))
    where = (Place("a", "amplitude", "time", 0.8, 12.0),)
    write(replace(NO_GAP, gap=gap, where=where, next_test=NextTest("thermal", "so", 2.5)), tmp_path)
    scored = read_scored(tmp_path / FILE)
    assert scored.where == (("time", 0.8),)
    assert scored.holdout_after_arcsec == 1.2
    assert (scored.next_test, scored.next_hours) == ("thermal", 2.5)


def test_without_held_out_tests_and_next_test(tmp_path: Path) -> None:
    write(NO_GAP, tmp_path)
    scored = read_scored(tmp_path / FILE)
    assert scored.holdout_after_arcsec is None
    assert scored.next_test is None


def test_a_missing_diagnosis_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DiagnosisError, match="can't be read"):
        read_scored(tmp_path / FILE)
