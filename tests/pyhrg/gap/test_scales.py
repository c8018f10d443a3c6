"""A laboratory that logs forces in volts knows their scales to percents, and says so."""

from dataclasses import replace

import pytest

from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import EFFECTS, Catalogue
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs
from tests.pyhrg.gap.test_diagnose import FEW


def misscale(log: Log) -> Log:
    return replace(
        log,
        amplitude_force=1.02 * log.amplitude_force,
        quadrature_force=0.99 * log.quadrature_force,
    )


@pytest.fixture(scope="module")
def campaign(simulation: Simulation) -> Campaign:
    return change_logs(recorded(simulation.sampled, NOMINAL), misscale)


def diagnose_within(simulation: Simulation, campaign: Campaign, tolerance: float) -> Diagnosis:
    stated = {"amplitude_force_scale": tolerance, "quadrature_force_scale": tolerance}
    given = replace(campaign, tolerances=stated)
    return diagnose(given, catalogue=Catalogue(FEW), simulation=simulation).diagnosis


def test_scales_within_their_tolerance_make_no_gap(
    simulation: Simulation, campaign: Campaign
) -> None:
    found = diagnose_within(simulation, campaign, 0.02)
    assert found.verdict == "no_gap"
    values = {known.name: known.interval_95 for known in found.within_tolerance}
    for name, true in (("amplitude_force_scale", 0.02), ("quadrature_force_scale", -0.01)):
        low, high = values[name]
        assert low < true < high
        assert high - low < 1e-3


def test_a_scale_beyond_its_tolerance_is_an_error_of_the_record(
    simulation: Simulation, campaign: Campaign
) -> None:
    found = diagnose_within(simulation, campaign, 1e-3)
    assert found.verdict == "explained"
    families = {cause.effect: cause.family for cause in found.causes}
    assert families == {"amplitude_force_scale": "record", "quadrature_force_scale": "record"}


def test_scales_that_nobody_states_are_named(simulation: Simulation, campaign: Campaign) -> None:
    """A force that reads low is not a smaller split, one that reads high is no damping."""
    few = Catalogue((*FEW, EFFECTS["frequency_split"]))
    found = diagnose(campaign, catalogue=few, simulation=simulation).diagnosis
    assert found.verdict == "explained"
    intervals = {cause.effect: cause.interval_95[cause.effect] for cause in found.causes}
    assert set(intervals) == {"amplitude_force_scale", "quadrature_force_scale"}
    for name, true in (("amplitude_force_scale", 0.02), ("quadrature_force_scale", -0.01)):
        low, high = intervals[name]
        assert low < true < high
