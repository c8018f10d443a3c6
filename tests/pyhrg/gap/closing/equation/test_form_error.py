"""A cause whose form no candidate term has is not read as a swarm of terms, effects and noises."""

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.units import ARCSEC
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.closing.equation.planted import record_planted, shift_angle, triangle
from tests.pyhrg.gap.test_diagnose import FEW


def test_a_triangular_error_of_the_angle_is_its_harmonics(simulation: Simulation) -> None:
    planted = Disturbance(
        shown=lambda log: shift_angle(log, 15 * ARCSEC * triangle(5 * log.wave_angle))
    )
    campaign = record_planted(simulation.sampled, planted)
    found = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation).diagnosis
    forms = {term.function for term in found.terms}
    assert "angle: harmonic 5 of the pattern angle" in forms
    assert forms <= {f"angle: harmonic {m} of the pattern angle" for m in (5, 15)}
    assert found.causes == ()
