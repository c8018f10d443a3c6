"""Campaigns of another simulator, whose truth is known: named exactly, and sized, and also as a
lab's recorder would have brought them home. `benchmarks/recorded.py` diagnoses all of them."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log, campaign
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.spoil import added, change_logs, take_kinds

WIDER = 1.3
"""Half width over that of 95 %: six parameters, of which one in twenty lies outside."""


@pytest.mark.parametrize("number", range(1, 7))
def test_the_truth_is_named(simulation: Simulation, recorded_campaign: Path, number: int) -> None:
    folder = recorded_campaign.parent / f"dev-0{number}"
    found = diagnose(campaign.read_campaign(folder), simulation=simulation).diagnosis
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


def test_a_large_term_stands_alone(simulation: Simulation, recorded_campaign: Path) -> None:
    """Damping that goes with the square of the amplitude, 1 % of it: 10 000 standard deviations.
    What the linear response misses of it is not read as other terms."""
    folder = recorded_campaign.parent / "lab-12"
    nominal = campaign.read_campaign(folder).nominal
    found = diagnose(folder, simulation=simulation).diagnosis
    (term,) = found.terms
    assert not found.causes
    assert (term.place, term.function) == ("damping", "amplitude squared")
    true, name = 0.01 / nominal["decay_time_s"], "damping_amplitude2_per_s"
    low, high = term.interval_95[name]
    assert low < true < high
    assert term.parameters[name] == pytest.approx(true, rel=5e-3)


def test_lost_words_and_a_coarse_thermometer_make_no_gap(
    simulation: Simulation, recorded_campaign: Path
) -> None:
    given = campaign.read_campaign(recorded_campaign.parent / "dev-06")
    spoilt_by_recorder = change_logs(given, coarse)
    for test, field, size in SPARKS:
        rows = len(next(each.log.time for each in given.tests if each.id == test))
        spark = np.where(np.arange(rows) == rows // 2 + 100, size, 0.0)
        spoilt_by_recorder = change_logs(spoilt_by_recorder, added(spark, field), test)
    found = diagnose(spoilt_by_recorder, simulation=simulation).diagnosis
    assert found.verdict == "no_gap"
    assert sum("expected" in told for told in found.excluded) == len(SPARKS)


def test_a_noisy_encoder_makes_no_gap(simulation: Simulation, recorded_campaign: Path) -> None:
    given = campaign.read_campaign(recorded_campaign.parent / "dev-06")
    generator = np.random.default_rng(3)
    found = diagnose(
        change_logs(given, lambda log: noisy(log, generator)), simulation=simulation
    ).diagnosis
    assert found.verdict == "no_gap"
    (scatter,) = re.findall(
        r"table_angle_deg: scatters by (\S+) arcsec where the gyro", "\n".join(found.excluded)
    )
    assert float(scatter) == pytest.approx(1, rel=0.02)


def test_a_step_of_the_angle_is_told(simulation: Simulation, recorded_campaign: Path) -> None:
    whole = campaign.read_campaign(recorded_campaign.parent / "dev-06")
    given = take_kinds(whole, "positions", "manoeuvre")
    found = diagnose(stepped(given, "positions_8n", 900, ARCSEC), simulation=simulation).diagnosis
    assert found.verdict == "unexplained"
    assert found.causes == ()
    assert set(found.unnamed) == {"output alone: a step at 901 s in positions_8n (output angle)"}


SPARKS = (
    ("static_fixed", "gyro_angle", 100 * ARCSEC),
    ("phase_step", "quadrature_force", 1e-5),
    ("thermal_ramp", "frequency_offset", 6.0),
    ("amplitude_sweep", "amplitude", 1e-3),
)
"""One reading each, in the middle of a test, SI."""


def noisy(log: Log, generator: np.random.Generator) -> Log:
    """With 1 arcsec of noise in the encoder."""
    noise = ARCSEC * generator.normal(size=len(log.time))
    return replace(log, table_angle=log.table_angle + noise)


def coarse(log: Log) -> Log:
    return replace(log, temperature=np.round(log.temperature - 273.15, 1) + 273.15)


def stepped(given: Campaign, test: str, row: int, size: float) -> Campaign:
    rows = len(next(each.log.time for each in given.tests if each.id == test))
    step = np.where(np.arange(rows) >= row, size, 0.0)
    k = given.nominal["coriolis_factor"]
    return change_logs(
        change_logs(given, added(step, "gyro_angle"), test), added(-k * step, "wave_angle"), test
    )
