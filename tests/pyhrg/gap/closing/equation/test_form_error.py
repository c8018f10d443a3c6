"""A cause whose form no candidate term has is not read as a swarm of terms, effects and noises."""

import numpy as np
import pytest

from pyhrg.bench.bench import Bench
from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import find_ideal_pattern_angle
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.evidence.rounds.iteration import attribute_gap
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.bench import short
from tests.pyhrg.gap.closing.equation.planted import record_planted, triangle
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.test_diagnose import FEW


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


def test_a_periodic_bias_is_a_term_of_its_period(simulation: Simulation) -> None:
    """A controller's cycle of 23.7 s, of one phase since power-on."""

    def rate(course: Course, start: float) -> Array:
        return np.asarray(0.5 * DEG_PER_H * np.sin(2 * np.pi * course.time / 23.7))

    rests = short(Bench(simulation.sampled, NOMINAL))[:2]
    campaign = record_planted(simulation.sampled, Disturbance(rate=rate), 12, rests)
    tests = [observe_test(test, NOMINAL) for test in campaign.tests]
    found = attribute_gap(simulation, NOMINAL, tests, Catalogue(FEW))
    ((term, size),) = found.ranking.best.sizes.items()
    assert isinstance(term, CandidateTerm)
    assert (term.coordinate, term.function[:20]) == ("time", "bias: harmonic 1 of ")
    assert found.parts[0].test.line_period == pytest.approx(23.7, rel=0.01)
    assert np.hypot(*size) == pytest.approx(0.5 * DEG_PER_H, rel=0.1)
