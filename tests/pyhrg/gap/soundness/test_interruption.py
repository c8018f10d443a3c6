"""A drive that was lost for seconds while the log has it on."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.soundness.interruption import find_interruptions
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL


@pytest.fixture(scope="module")
def campaign(simulation: Simulation) -> Campaign:
    """A rest with the drive off for 2 s, of which the log says nothing."""
    bench = Bench(simulation.sampled, NOMINAL)
    rest = bench.programme().rest(200).command(drive_on=0.0).rest(2).command(drive_on=1.0).rest(300)
    power_ons = [PowerOn("still", "static", rest)]
    given = recorded(simulation.sampled, NOMINAL, power_ons=power_ons)
    (test,) = given.tests
    log = replace(test.log, drive_on=np.ones(len(test.log.time)))
    return replace(given, tests=(replace(test, recording=log),))


def test_the_rows_are_found(campaign: Campaign) -> None:
    (test,) = campaign.tests
    found = find_interruptions(test.log, NOMINAL)
    assert test.log.time[found].tolist() == [201.0, 202.0]


def test_a_wrong_reading_is_no_interruption(campaign: Campaign) -> None:
    (test,) = campaign.tests
    amplitude = np.ones(len(test.log.time))
    amplitude[100] -= 2e-3
    assert not find_interruptions(replace(test.log, amplitude=amplitude), NOMINAL).any()


def test_it_makes_no_gap_and_is_stated(simulation: Simulation, campaign: Campaign) -> None:
    found = diagnose(campaign, catalogue=Catalogue(known=()), simulation=simulation).diagnosis
    assert found.verdict == "no_gap"
    assert any("the drive was lost at time_s 200 for about 2 s" in note for note in found.excluded)
