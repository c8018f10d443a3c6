"""Which terms are proposed: the false discovery rate, names, and every candidate term written."""

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from pyhrg.gap.closing.equation.places import find_acting
from pyhrg.gap.closing.equation.proposal import (
    list_coefficients,
    make_terms,
    propose_terms,
)
from pyhrg.gap.closing.equation.series import estimate_terms
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.jump import Jump, make_bias_jump, make_step
from pyhrg.gap.evidence.hypothesis import NO_ERROR
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.evidence.search import rank_sets
from tests.pyhrg.gap.made_up import design_of

CUBED = CandidateTerm("gyro_angle", "rate", "bias: rate cubed")
WARM = CandidateTerm("gyro_angle", "temperature", "bias: temperature^1")


def posterior_of(nearness: float, size: float = 1.0) -> Posterior:
    """Of a residual in which one form takes part; another form of another coordinate differs from
    it by a share of its columns."""
    first, other, noise = np.random.default_rng(1).normal(size=(3, 400))
    columns = {CUBED: first[:, None], WARM: (first + nearness * other)[:, None]}
    design = design_of(columns, size * first + noise)
    hypothesis = SimpleNamespace(ranking=rank_sets(design), design=design, forms=NO_ERROR)
    made = SimpleNamespace(best=hypothesis, hypotheses=(hypothesis,), probabilities=(1.0,))
    return cast(Posterior, made)


def test_of_forms_that_cannot_be_told_apart_one_is_written_and_all_are_listed() -> None:
    (term,) = propose_terms(posterior_of(0.02))
    other = {CUBED.function: WARM, WARM.function: CUBED}[term.function]
    assert list(term.rivals) == [other.words]
    assert term.probability > term.rivals[other.words] > 0.05
    assert term.probability < 0.95 < term.discovery_probability
    total = term.probability + sum(term.rivals.values())
    assert total == pytest.approx(term.discovery_probability)


def test_what_may_be_noise_is_not_proposed() -> None:
    """The most probable set has a term, but it is false with a probability above 5 %."""
    posterior = posterior_of(1.0, size=0.24)
    (term,) = make_terms(posterior, estimate_terms(posterior.best))
    assert 0.5 < term.discovery_probability < 0.95
    assert propose_terms(posterior) == ()


def test_a_form_that_explains_less_is_no_rival() -> None:
    (term,) = propose_terms(posterior_of(1.0))
    assert term.function == CUBED.function
    assert term.rivals == {}
    assert term.probability == pytest.approx(term.discovery_probability)


@pytest.mark.parametrize(
    ("channel", "coordinate", "function", "place", "names"),
    [
        ("gyro_angle", "wave_angle", "bias: harmonic 6 of the pattern angle", "bias",
         ["bias_cos6_deg_h", "bias_sin6_deg_h"]),
        ("gyro_angle", "wave_angle", "angle: harmonic 2 of the pattern angle", "readout",
         ["readout_cos2_arcsec", "readout_sin2_arcsec"]),
        ("gyro_angle", "table_angle", "angle: harmonic 1 of the table angle", "bench",
         ["readout_cos1_table_arcsec", "readout_sin1_table_arcsec"]),
        ("gyro_angle", "table_angle", "bias: harmonic 2 of the table angle", "bias",
         ["bias_cos2_table_deg_h", "bias_sin2_table_deg_h"]),
        ("gyro_angle", "rate", "bias: rate cubed", "bias", ["bias_rate3_deg_h_per_deg3_s3"]),
        ("amplitude_force", "amplitude", "amplitude squared", "damping",
         ["damping_amplitude2_per_s"]),
        ("quadrature_force", "temperature", "temperature^2", "stiffness",
         ["stiffness_temperature2_per_s_per_K2"]),
        ("frequency_offset", "time", "settling in 300 s", "stiffness",
         ["frequency_settling_300s_Hz"]),
        ("amplitude", "time", "time since power-on", "electronics",
         ["electronics_time_amplitude_per_h"]),
    ],
)  # fmt: skip
def test_place_and_names(
    channel: str, coordinate: str, function: str, place: str, names: list[str]
) -> None:
    term = CandidateTerm(channel, coordinate, function)
    assert find_acting(term).place == place
    assert [c.name for c in list_coefficients(term)] == names


@pytest.mark.parametrize(
    "term",
    [
        CandidateTerm("amplitude", "time", "a value for each power-on"),
        make_step([("still", 30.0)], 0.0, "pattern"),
    ],
)
def test_steps_of_the_pattern_and_values_for_each_power_on_are_no_equations(
    term: CandidateTerm,
) -> None:
    assert list_coefficients(term) == ()


@pytest.mark.parametrize(
    ("jump", "name"),
    [
        (make_step([("still", 30.0)], 0.0, "output"), "readout_jump1_arcsec"),
        (make_bias_jump([("still", 30.0)], 0.0), "bias_jump1_deg_h"),
    ],
)
def test_a_jump_has_a_size_in_its_test(jump: Jump, name: str) -> None:
    (coefficient,) = list_coefficients(jump)
    assert (coefficient.name, coefficient.basis.test) == (name, "still")
