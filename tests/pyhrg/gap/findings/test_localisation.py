"""Shares of a gap: they add up, and a planted coordinate has its own."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import EACH_POWER_ON, CandidateTerm
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.design import Block, remove_effects
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.findings.localisation import locate_gap
from tests.pyhrg.gap.made_up import design_of

N = 2000
TIME = np.arange(N) / N
FOURTH = CandidateTerm("gyro_angle", "wave_angle", "harmonic 4", 4)
RATE = CandidateTerm("gyro_angle", "rate", "rate")
HEAT = CandidateTerm("gyro_angle", "temperature", "temperature")
COLUMNS: dict[Group, Array] = {
    FOURTH: np.column_stack([np.cos(60 * np.pi * TIME), np.sin(60 * np.pi * TIME)]),
    RATE: (TIME**2)[:, None],
    HEAT: np.exp(-TIME)[:, None],
}


def noise() -> Array:
    return np.random.default_rng(4).normal(size=N)


def test_a_planted_coordinate_is_found() -> None:
    fourth, rate = 4 * np.cos(60 * np.pi * TIME - 1), 6 * TIME**2
    places = locate_gap(design_of(COLUMNS, noise() + fourth + rate))
    assert sum(place.share for place in places) == pytest.approx(1)
    shares = {(place.coordinate, place.harmonic): place.share for place in places}
    whole = (fourth + rate) @ (fourth + rate)
    assert shares["wave_angle", 4] == pytest.approx(fourth @ fourth / whole, abs=0.05)
    assert shares["rate", None] == pytest.approx(rate @ rate / whole, abs=0.05)
    assert places[0].coordinate == "wave_angle"
    sigmas = sum(place.sigmas**2 for place in places)
    assert sigmas == pytest.approx(whole, rel=0.05)


def test_a_residual_beyond_all_noise_is_placed() -> None:
    """A gap of 1e9 sigma: its power of 1e18 hides small differences by rounding."""
    places = locate_gap(design_of(COLUMNS, noise() + 1e9 * TIME**2))
    assert places[0].coordinate == "rate"


def test_power_that_no_term_explains_is_noise() -> None:
    places = locate_gap(design_of(COLUMNS, 2 * noise()))
    assert [place.coordinate for place in places] == ["noise"]
    assert places[0].share == 1


def test_noise_alone_is_no_gap() -> None:
    assert locate_gap(design_of(COLUMNS, noise())) == ()


def test_what_has_its_identified_size_is_no_part_of_the_gap() -> None:
    """A parameter that is 1e6 sigma off and has its size leaves what a term of 400 sigma makes."""
    known = EFFECTS["nominal_frequency"]
    column = np.sin(7 * TIME)[:, None]
    residual = noise() + 1e6 * column[:, 0] + 20 * TIME**2
    design = design_of({known: column, **COLUMNS}, residual)
    assert locate_gap(design)[0].sigmas > 1e6
    (place,) = locate_gap(remove_effects(design, {known: np.array([1e6])}))
    (alone,) = locate_gap(design_of(COLUMNS, noise() + 20 * TIME**2))
    assert place.coordinate == alone.coordinate == "rate"
    assert place.sigmas == pytest.approx(alone.sigmas, rel=1e-6)


def test_a_term_shared_by_tests_is_found_though_none_shows_it_alone() -> None:
    """A term of 12 sigma in 16 tests, 3 in each; its power to 3 standard deviations."""
    generator = np.random.default_rng(5)
    fourth = 3 / np.sqrt(N / 2) * np.cos(60 * np.pi * TIME - 1)
    parts = [design_of(COLUMNS, generator.normal(size=N) + fourth) for _ in range(16)]
    blocks = [replace(part.blocks[0], test=f"test {i}") for i, part in enumerate(parts)]
    places = locate_gap(replace(parts[0], blocks=tuple(blocks)))
    assert {(place.coordinate, place.harmonic) for place in places} == {("wave_angle", 4)}
    assert sum(place.sigmas**2 for place in places) == pytest.approx(12**2, abs=3 * 2 * 12)
    assert sum(place.share for place in places) == pytest.approx(1)
    assert len(places) > 8


def test_a_harmonic_is_named_only_where_the_angle_moves_through_a_period_of_it() -> None:
    fourth = 4 * np.cos(60 * np.pi * TIME - 1)
    design = design_of(COLUMNS, noise() + fourth)
    (name,) = {block.test for block in design.blocks}
    for travel, harmonic in ((0.0, None), (1.5, None), (1.6, 4)):
        places = locate_gap(design, {(name, "wave_angle"): travel})
        assert {(p.coordinate, p.harmonic) for p in places} == {("wave_angle", harmonic)}


def test_the_first_of_equally_good_coordinates_is_taken() -> None:
    """A constant, though a squared force that is one in almost all rows explains as much."""
    mean = CandidateTerm("gyro_angle", "wave_angle", "mean", 0)
    force = CandidateTerm("gyro_angle", "acceleration", "acceleration z squared")
    squared = np.ones((N, 1))
    squared[:20] = 0.0
    residual = noise() + 0.3
    residual[:20] -= 0.3
    places = locate_gap(design_of({mean: np.ones((N, 1)), force: squared}, residual))
    assert {(place.coordinate, place.harmonic) for place in places} == {("wave_angle", 0)}


@pytest.mark.parametrize(("values", "coordinate"), [((3, 3), "wave_angle"), ((5, -5), "time")])
def test_a_value_for_each_power_on_is_taken_where_nothing_else_explains(
    values: tuple[float, float], coordinate: str
) -> None:
    mean = CandidateTerm("gyro_angle", "wave_angle", "mean", 0)
    each = CandidateTerm("gyro_angle", "time", EACH_POWER_ON)
    generator = np.random.default_rng(6)
    blocks = []
    for i, value in enumerate(values * 2):
        residual = generator.normal(size=N) + value / np.sqrt(N)
        both = np.column_stack([np.ones(N), np.ones(N), residual])
        columns = np.array([0, 1 + i])
        blocks.append(Block(f"test {i}", "gyro_angle", columns, both.T @ both, N, 0.0))
    whole = design_of({mean: np.ones((N, 1)), each: generator.normal(size=(N, 4))}, noise())
    places = locate_gap(replace(whole, blocks=tuple(blocks)))
    assert {place.coordinate for place in places} == {coordinate}
