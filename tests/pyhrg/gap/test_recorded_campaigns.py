"""Campaigns of another simulator, whose truth is known: named exactly, and sized."""

import json
from pathlib import Path

import pytest

from pyhrg import campaign
from pyhrg.gap.diagnose import diagnosed
from pyhrg.gap.simulation import Simulation

WIDER = 1.3
"""Half width over that of 95 %: six parameters, of which one in twenty lies outside."""


@pytest.mark.parametrize("number", range(1, 7))
def test_the_truth_is_named(simulation: Simulation, recorded_campaign: Path, number: int) -> None:
    folder = recorded_campaign.parent / f"dev-0{number}"
    found = diagnosed(campaign.read(folder), simulation).diagnosis
    truth = json.loads((folder / "truth.json").read_text())
    assert {cause.effect for cause in found.causes} == set(truth["effects"])
    assert found.verdict == ("explained" if truth["effects"] else "no_gap")
    intervals = {k: v for cause in found.causes for k, v in cause.interval_95.items()}
    assert set(intervals) == set(truth["parameters"])
    for name, true in truth["parameters"].items():
        low, high = intervals[name]
        assert abs(true - (low + high) / 2) <= WIDER * (high - low) / 2, name
    held = found.gap.holdout_angle_arcsec
    assert held is not None
    assert held.after <= WIDER * held.floor_95[1]
