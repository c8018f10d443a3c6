"""A cause whose form no candidate term has is not read as a swarm of terms, effects and noises."""

import numpy as np

from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import find_ideal_pattern_angle
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.closing.equation.planted import record_planted, shift_angle, triangle
from tests.pyhrg.gap.soundness.conftest import NOMINAL
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


def test_a_triangular_bias_is_its_harmonic_and_no_noise(simulation: Simulation) -> None:
    """A noise without terms has no forms either: it faces the records as they are."""

    def rate(course: Course, start: float) -> Array:
        angle = find_ideal_pattern_angle(NOMINAL, course, start)
        return np.asarray(0.5 * DEG_PER_H * triangle(7 * angle))

    campaign = record_planted(simulation.sampled, Disturbance(rate=rate), 11)
    result = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation)
    found = result.diagnosis
    assert [term.function for term in found.terms] == ["bias: harmonic 7 of the pattern angle"]
    assert found.causes == ()
    assert result.attribution.noise.unnamed is None
