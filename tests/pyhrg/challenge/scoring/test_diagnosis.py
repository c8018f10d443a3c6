"""Reading `diagnosis.json`."""

import json
from pathlib import Path
from typing import Any

import pytest

from pyhrg.challenge.scoring import diagnosis
from pyhrg.records.campaign_index import CampaignError

CAUSE: dict[str, Any] = {
    "effect": "duffing_stiffness",
    "probability": 0.9,
    "parameters": {"duffing_Hz": 1e-3},
    "interval_95": {"duffing_Hz": [5e-4, 2e-3]},
    "equivalents": [],
}
SAID: dict[str, Any] = {
    "schema": "hrg-diagnosis/1",
    "verdict": "explained",
    "causes": [CAUSE],
    "unknown_probability": 0.05,
    "where": [{"test": "a", "channel": "b", "coordinate": "amplitude", "share": 0.8}],
    "gap": {
        "after": {"fit": {"angle_arcsec": 1.0}, "holdout": {"angle_arcsec": 1.2}},
        "floor": {"fit": {"angle_arcsec": 1.0}, "holdout": {"angle_arcsec": 1.0}},
    },
    "next_test": {"kind": "thermal", "why": "it would tell"},
}


def read(folder: Path, values: dict[str, Any]) -> diagnosis.Diagnosis:
    path = folder / diagnosis.FILE
    path.write_text(json.dumps(values))
    return diagnosis.read(path)


def test_all_parts_are_read(tmp_path: Path) -> None:
    found = read(tmp_path, SAID)
    assert found.causes[0].interval_95 == {"duffing_Hz": (5e-4, 2e-3)}
    assert found.where == (("amplitude", 0.8),)
    assert found.holdout_after_arcsec == pytest.approx(1.2)
    assert found.next_test == "thermal"


def test_stages_and_roles_may_be_nested_either_way(tmp_path: Path) -> None:
    gap = {"holdout": {"after": {"angle_arcsec": 1.2}, "floor": {"angle_arcsec": 1.0}}}
    assert read(tmp_path, {**SAID, "gap": gap}).holdout_after_arcsec == pytest.approx(1.2)


def test_what_is_not_given_is_none(tmp_path: Path) -> None:
    found = read(tmp_path, {**SAID, "gap": {}, "next_test": None})
    assert found.holdout_after_arcsec is None
    assert found.next_test is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"schema": "other"}, "schema: 'other'; expected 'hrg-diagnosis/1'"),
        ({"verdict": "maybe"}, "verdict: 'maybe'; expected one of no_gap"),
        ({"unknown_probability": 1.2}, "unknown_probability: 1.2; expected 0 to 1"),
        ({"causes": [{**CAUSE, "probability": None}]}, r"causes\[0\]\.probability: None"),
        (
            {"causes": [{**CAUSE, "interval_95": {"duffing_Hz": [2, 1]}}]},
            r"duffing_Hz: \[2, 1\]; expected \[low, high\]",
        ),
        ({"causes": [{**CAUSE, "equivalents": "x"}]}, "equivalents: 'x'; expected a list of names"),
        ({"next_test": {"why": "so"}}, "next_test: .*; expected null, or an object with a kind"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, change: dict[str, Any], message: str) -> None:
    with pytest.raises(CampaignError, match=message):
        read(tmp_path, {**SAID, **change})
