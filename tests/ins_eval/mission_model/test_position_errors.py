"""Flights by the linear model: of its own kind, and against the nonlinear co-simulation."""

from dataclasses import fields

import numpy as np
import pytest

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission
from ins_eval.mission_model.position_errors import (
    TriadBlock,
    compute_linear_position_errors,
    draw_noise_errors,
)
from ins_eval.study.cosimulated import compare_errors, cosimulate, sample_truth
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from pyhrg.fmu import GyroFmu


def test_linear_flight_is_the_nonlinear_one(
    fmu: GyroFmu,
    some: list[DrawnTriad],
    triads: TriadBlock,
    short: StudyMission,
    weights: MissionWeights,
) -> None:
    """Within 1 % of the rms, gyros that warm by up to 15 K; not that of another triad, nor without
    what the maps gain with specific force and heating."""
    parts = compute_linear_position_errors(triads, weights, 0)
    linear = parts.error - parts.noise
    flying = sample_truth(short)
    nonlinear = np.array([cosimulate(fmu, flying, each) for each in some])
    found = compare_errors(linear, nonlinear)
    assert found.triads == 2
    assert found.share < 0.01
    assert compare_errors(linear - parts.environment, nonlinear).share > 0.02
    assert compare_errors(linear[::-1], nonlinear).share > 0.3


def test_parts_add_up(triads: TriadBlock, weights: MissionWeights) -> None:
    found = compute_linear_position_errors(triads, weights, 0)
    parts = sum(getattr(found, field.name) for field in fields(found))
    assert np.array_equal(found.error, parts)
    assert found.radial[0, -1] == pytest.approx(np.linalg.norm(parts[0, -1]))


def test_noise_is_each_triads_own(triads: TriadBlock, weights: MissionWeights) -> None:
    both = draw_noise_errors(weights, triads.noise, triads.seeds, 0)
    alone = draw_noise_errors(weights, triads.noise[1:], triads.seeds[1:], 0)
    assert alone[0] == pytest.approx(both[1], rel=1e-12)
    assert not np.allclose(draw_noise_errors(weights, triads.noise, triads.seeds, 1), both)


def test_noise_has_the_covariance_of_the_weights(weights: MissionWeights) -> None:
    """2000 draws; the variance of each error within five standard deviations of its estimate."""
    count = 2000
    strengths = np.full((count, 4, 3), 1e-8)
    seeds = np.arange(2 * count, dtype=np.uint64).reshape(count, 2)
    drawn = draw_noise_errors(weights, strengths, seeds, 0).reshape(count, -1)
    expected = np.diagonal((1e-8**2 * weights.noise).sum(axis=(0, 1)))
    assert np.var(drawn, axis=0) == pytest.approx(expected, rel=5 * np.sqrt(2 / count))
