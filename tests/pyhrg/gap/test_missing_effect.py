"""A gyro with an error that neither effects nor candidate terms express."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.fmu import GyroFmu
from pyhrg.gap import diagnose as diagnose_module
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import EFFECTS, FULL_CATALOGUE, Catalogue
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import WORSE_HELD_OUT, Gap
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.bench import short, tiny
from tests.pyhrg.gap.closing.equation.planted import record_planted
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.test_diagnose import FEW

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


def test_a_gyro_further_from_the_records_is_not_written(
    simulation: Simulation, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The search is made to find nine times the opposite of what is there."""
    effect = EFFECTS["damping_anisotropy"]

    def reverse(_: Simulation, attribution: Attribution, *__: object) -> Attribution:
        best = attribution.posterior.best
        (fit, *others), ranking = best.ranking.fits, best.ranking
        assert effect in fit.groups
        opposite = replace(fit, values=tuple(-9 * value for value in fit.values))
        ranking = replace(ranking, fits=(opposite, *others))
        hypotheses = (replace(best, ranking=ranking), *attribution.posterior.hypotheses[1:])
        posterior = replace(attribution.posterior, hypotheses=hypotheses)
        return replace(attribution, posterior=posterior)

    campaign = tiny(simulation, replace(NOMINAL, damping_anisotropy=3e-6))
    few = Catalogue(FEW)
    right = diagnose(campaign, catalogue=few, simulation=simulation)
    monkeypatch.setattr(diagnose_module, "refine_terms", reverse)
    wrong = diagnose(campaign, catalogue=few, simulation=simulation)
    assert right.verdict == "explained"
    assert wrong.verdict == "unexplained"
    assert not wrong.causes.size
    assert not wrong.diagnosis.settled
    assert wrong.identified == wrong.nominal
    for before, after in zip(wrong.before, wrong.after, strict=True):
        assert all(np.array_equal(before[name], after[name], equal_nan=True) for name in before)


@pytest.mark.parametrize("leaves_excess", [False, True])
def test_what_fits_records_that_no_set_explains_must_predict(
    simulation: Simulation, monkeypatch: pytest.MonkeyPatch, leaves_excess: bool
) -> None:
    """A worse prediction of the held-out tests is a caveat, but where no set explains the records
    nothing is named."""
    monkeypatch.setattr(Attribution, "leaves_excess", leaves_excess)
    monkeypatch.setattr(Gap, "is_wider_held_out", True)
    campaign = tiny(simulation, replace(NOMINAL, damping_anisotropy=3e-6))
    found = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation).diagnosis
    names = [cause.effect for cause in found.causes]
    assert names == ([] if leaves_excess else ["damping_anisotropy"])
    assert found.settled != leaves_excess
    assert WORSE_HELD_OUT in found.caveats
