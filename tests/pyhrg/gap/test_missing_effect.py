"""A gyro with an error that neither effects nor candidate terms express."""

from dataclasses import replace

from pyhrg.bench.bench import Bench
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.fmu import GyroFmu
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.bench import short
from tests.pyhrg.gap.closing.equation.planted import record_planted
from tests.pyhrg.gap.soundness.conftest import NOMINAL

DELAY = 1e-3
KEPT = ("still", "positions", "ride")


def test_what_no_set_explains_makes_no_swarm(fmu: GyroFmu, simulation: Simulation) -> None:
    """A delay of the output that the catalogue lacks leaves 300 times the noise where moves end. It
    is said, and neither made into terms nor blamed on an effect."""
    power_ons = [each for each in short(Bench(fmu, NOMINAL)) if each.id in KEPT]
    device = replace(NOMINAL, filter_delay=DELAY)
    campaign = record_planted(fmu, Disturbance(), 1, power_ons, device)
    catalogue = FULL_CATALOGUE.without(["filter_delay"])
    found = diagnose(campaign, catalogue=catalogue, simulation=simulation).diagnosis
    assert found.verdict == "unexplained"
    assert not found.causes
    assert not found.terms
    assert any("times the noise in positions" in words for words in found.unnamed)
    gap = found.gap.holdout_angle_arcsec
    assert gap is not None
    assert gap.after <= gap.before
