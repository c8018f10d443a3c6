"""Truths under seal."""

from pathlib import Path

import pytest

from pyhrg.challenge.truths import seal
from pyhrg.challenge.truths.truth import Truth
from pyhrg.common.errors import HrgError

TRUTH = Truth("single", ("duffing_stiffness",), {"duffing_Hz": 1e-3}, (7.5,), stand_ins=("a", "b"))


def test_a_truth_comes_back(tmp_path: Path) -> None:
    published = seal.seal_truth(TRUTH, tmp_path / "truth.json")
    assert seal.hash_truth(tmp_path / "truth.json") == published
    assert seal.open_truth(tmp_path / "truth.json", published) == TRUTH


def test_another_truth_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "truth.json"
    published = seal.seal_truth(TRUTH, path)
    path.write_text(path.read_text().replace("7.5", "7.6"))
    with pytest.raises(seal.ChallengeError, match=r"truth\.json: SHA-256 is .* was published"):
        seal.open_truth(path, published)


def test_a_missing_truth_is_said(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"gone\.json: can't be read: No such file"):
        seal.hash_truth(tmp_path / "gone.json")
