"""Flights by the linear model: of its own kind, and against the nonlinear co-simulation."""

from dataclasses import fields

import numpy as np
import pytest

from ins_eval.mission_model.flown import flown, noise_errors
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission
from ins_eval.mission_model.triads import Triads
from ins_eval.study.block import Triad
from ins_eval.study.cosimulated import agreement, cosimulated, truth
from pyhrg.fmu import GyroFmu


def test_linear_flight_is_the_nonlinear_one(
    fmu: GyroFmu,
    some: list[Triad],
    triads: Triads,
    short: StudyMission,
    weights: MissionWeights,
) -> None:
    """Within 1 % of the rms, gyros that warm by up to 15 K; not that of another triad, nor without
    what the maps gain with specific force and heating."""
    parts = flown(triads, weights, 0)
    linear = parts.error - parts.noise
    flying = truth(short)
    nonlinear = np.array([cosimulated(fmu, flying, each) for each in some])
    found = agreement(linear, nonlinear)
    assert found.triads == 2
    assert found.share < 0.01
    assert agreement(linear - parts.environment, nonlinear).share > 0.02
    assert agreement(linear[::-1], nonlinear).share > 0.3


def test_parts_add_up(triads: Triads, weights: MissionWeights) -> None:
    found = flown(triads, weights, 0)
    parts = sum(getattr(found, field.name) for field in fields(found))
    assert np.array_equal(found.error, parts)
    assert found.radial[0, -1] == pytest.approx(np.linalg.norm(parts[0, -1]))


def test_noise_is_each_triads_own(triads: Triads, weights: MissionWeights) -> None:
    both = noise_errors(weights, triads.noise, triads.seeds, 0)
    alone = noise_errors(weights, triads.noise[1:], triads.seeds[1:], 0)
    assert alone[0] == pytest.approx(both[1], rel=1e-12)
    assert not np.allclose(noise_errors(weights, triads.noise, triads.seeds, 1), both)


def test_noise_has_the_covariance_of_the_weights(weights: MissionWeights) -> None:
    """2000 draws; the variance of each error within five standard deviations of its estimate."""
    count = 2000
    strengths = np.full((count, 4, 3), 1e-8)
    seeds = np.arange(2 * count, dtype=np.uint64).reshape(count, 2)
    drawn = noise_errors(weights, strengths, seeds, 0).reshape(count, -1)
    expected = np.diagonal((1e-8**2 * weights.noise).sum(axis=(0, 1)))
    assert np.var(drawn, axis=0) == pytest.approx(expected, rel=5 * np.sqrt(2 / count))
