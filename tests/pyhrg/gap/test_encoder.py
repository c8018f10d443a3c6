"""Errors of the table's encoder: a ripple that it does not show, and the backlash of its drive."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import apply_play
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import EFFECTS, Catalogue
from pyhrg.gap.effects.coordinates import LAST_MOTION
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log, campaign
from tests.pyhrg.gap.closing.equation.planted import record_planted
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs, take_kinds

KINDS = ("positions", "rate", "manoeuvre")
"""Tests that turn the table."""
SLOW_KINDS = ("positions", "manoeuvre")
"""Those of them that show a ripple and a backlash apart."""
STEP = 360 * DEG / 2**21
BACKLASH = 1.2 * ARCSEC
"""Turn of the table by which the encoder stands still after each reversal."""


def test_ripple_and_backlash_are_told_apart(
    simulation: Simulation, recorded_campaign: Path
) -> None:
    def misread(log: Log) -> Log:
        ripple = np.sin(3 * log.table_angle + 0.7) - np.sin(0.7)
        turned = np.append(0.0, log.table_angle + 0.5 * ARCSEC * ripple)
        return replace(log, table_angle=apply_play(turned, BACKLASH)[1:])

    whole = campaign.read_campaign(recorded_campaign.parent / "lab-04")
    given = change_logs(take_kinds(whole, *SLOW_KINDS), misread)
    found = diagnose(given, simulation=simulation).diagnosis
    assert found.verdict == "unexplained"
    (cause,) = found.causes
    assert (cause.effect, cause.family) == ("table_ripple", "bench")
    assert cause.parameters == {"table_ripple_3_arcsec": pytest.approx(0.5, abs=0.02)}
    assert {(term.place, *term.coordinates) for term in found.terms} == {("bench", "table_angle")}
    (backlash,) = (term for term in found.terms if term.function == f"angle: {LAST_MOTION}")
    low, high = backlash.interval_95["readout_last_motion_arcsec"]
    assert 0.4 < low < BACKLASH / ARCSEC / 2 < high < 0.8


def test_steps_of_the_encoder_make_no_gap(simulation: Simulation, recorded_campaign: Path) -> None:
    """A table shows its angle in steps of 0.62 arcsec: neither the rests nor a rotation that passes
    the same angles again and again look like an effect."""

    def show(log: Log) -> Log:
        return replace(log, table_angle=STEP * np.round(log.table_angle / STEP))

    whole = campaign.read_campaign(recorded_campaign.parent / "lab-04")
    given = change_logs(take_kinds(whole, *KINDS), show)
    found = diagnose(given, simulation=simulation).diagnosis
    assert found.verdict == "no_gap"
    assert not found.terms
    assert found.unknown_probability < 0.05
    assert any("steps of 0.618 arcsec" in sentence for sentence in found.excluded)


def test_noise_of_the_encoder_is_no_slower_move_of_the_table(simulation: Simulation) -> None:
    """A filter's delay shows where moves begin and end. The logs of fast rotation rest too shortly
    to tell the encoder's noise: that of all logs counts."""
    generator = np.random.default_rng(9)

    def disturb(log: Log) -> Log:
        noise = 0.09 * ARCSEC * generator.standard_normal(len(log.time))
        return replace(log, table_angle=log.table_angle + noise)

    device = replace(NOMINAL, filter_delay=4e-4)
    recorded = record_planted(simulation.sampled, Disturbance(), 9, device=device)
    few = Catalogue((EFFECTS["filter_delay"], EFFECTS["loop_delay"]))
    found = diagnose(change_logs(recorded, disturb), catalogue=few, simulation=simulation).diagnosis
    (cause,) = found.causes
    assert (found.verdict, cause.effect) == ("explained", "filter_delay")
    low, high = cause.interval_95["filter_delay_s"]
    assert low <= 4e-4 <= high
    assert high - low < 1e-5
    assert not found.terms
