"""Shares of a gap: they add up, and a planted coordinate has its own."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.gap.design import Group
from pyhrg.gap.localisation import located
from pyhrg.gap.unknown import Element
from tests.pyhrg.gap.made_up import design_of

Array = NDArray[np.float64]

N = 2000
TIME = np.arange(N) / N
FOURTH = Element("gyro_angle", "wave_angle", "harmonic 4", 4)
RATE = Element("gyro_angle", "rate", "rate")
HEAT = Element("gyro_angle", "temperature", "temperature")
COLUMNS: dict[Group, Array] = {
    FOURTH: np.column_stack([np.cos(60 * np.pi * TIME), np.sin(60 * np.pi * TIME)]),
    RATE: (TIME**2)[:, None],
    HEAT: np.exp(-TIME)[:, None],
}


def noise() -> Array:
    return np.random.default_rng(4).normal(size=N)


def test_a_planted_coordinate_is_found() -> None:
    fourth, rate = 4 * np.cos(60 * np.pi * TIME - 1), 6 * TIME**2
    places = located(design_of(COLUMNS, noise() + fourth + rate))
    assert sum(place.share for place in places) == pytest.approx(1)
    shares = {(place.coordinate, place.harmonic): place.share for place in places}
    whole = (fourth + rate) @ (fourth + rate)
    assert shares["wave_angle", 4] == pytest.approx(fourth @ fourth / whole, abs=0.05)
    assert shares["rate", None] == pytest.approx(rate @ rate / whole, abs=0.05)
    assert places[0].coordinate == "wave_angle"
    sigmas = sum(place.sigmas**2 for place in places)
    assert sigmas == pytest.approx(whole, rel=0.05)


def test_what_follows_no_coordinate_is_noise() -> None:
    places = located(design_of(COLUMNS, 2 * noise()))
    assert [place.coordinate for place in places] == ["noise"]
    assert places[0].share == 1


def test_noise_alone_is_no_gap() -> None:
    assert located(design_of(COLUMNS, noise())) == ()


def test_what_tests_share_is_found_though_none_shows_it_alone() -> None:
    """12 sigma in 16 tests, 3 in each; its power to 3 deviations."""
    generator = np.random.default_rng(5)
    fourth = 3 / np.sqrt(N / 2) * np.cos(60 * np.pi * TIME - 1)
    parts = [design_of(COLUMNS, generator.normal(size=N) + fourth) for _ in range(16)]
    blocks = [replace(part.blocks[0], test=f"test {i}") for i, part in enumerate(parts)]
    places = located(replace(parts[0], blocks=tuple(blocks)))
    assert {(place.coordinate, place.harmonic) for place in places} == {("wave_angle", 4)}
    assert sum(place.sigmas**2 for place in places) == pytest.approx(12**2, abs=3 * 2 * 12)
    assert sum(place.share for place in places) == pytest.approx(1)
    assert len(places) > 8
