"""What motions tell of the mechanisms, and what they leave confounded."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.witness.uncertainty import (
    compute_map_deviation,
    compute_mean_deviation,
    rank_directions,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.witness.design import TERMS, Motion, evaluate_angles, stack_signals
from pyhrg.witness.information import (
    accumulate_information,
    compute_maps_response,
    compute_posterior,
    factor_covariance,
)
from pyhrg.witness.mechanisms import COUNT, find
from pyhrg.witness.responses import Responses
from tests.pyhrg.witness.flights import GYRO, LINEAR_PRIOR

DURATION = 600.0
ROW = 0.1
DRIFTING = int(np.sum(np.diag(LINEAR_PRIOR.covariance) > 0))


def move(rate: float | Array, rotation: float | Array = 0.0) -> Motion:
    """The motion of a gyro at its reference temperature, 10 min at ten rows a second."""
    time = np.arange(0.0, DURATION, ROW)
    w, v = (np.broadcast_to(each, time.shape) for each in (rate, rotation))
    angle = 0.3 + ROW * GYRO.bryan_factor * np.cumsum(v - w)
    return Motion(ROW, angle, w, v, 0 * time, stack_signals(0 * time))


def alternate(size: float) -> Array:
    time = np.arange(0.0, DURATION, ROW)
    return size * np.sign(np.sin(2 * np.pi * time / 120))


def bound(responses: Responses, motion: Motion) -> Array:
    return compute_posterior(LINEAR_PRIOR.covariance, accumulate_information(responses, motion))


def take_amplitude_force(responses: Responses) -> Responses:
    """The sensitivities without those of the quadrature force, which sees electrode errors in
    proportion to the frequency split."""
    forces = responses.forces.copy()
    forces[:, 1] = 0.0
    return replace(responses, forces=forces)


def test_a_gyro_at_rest_does_not_see_its_own_bias(responses: Responses) -> None:
    """The bias is the slope of the amplitude force along the pattern angle, and a pattern at rest
    has no slope: what the bound says of the fourth harmonic there is the prior, within 3 %. A
    quarter of a period away the decay time is confounded with it, but for one that is known."""
    motion, responses = move(0.0), take_amplitude_force(responses)
    angle = motion.angle[:1]

    def compare(angle: Array) -> float:
        harmonics = evaluate_angles(angle)[:, 1:]
        response = harmonics @ compute_maps_response(responses, 0.0)[1:TERMS]
        before, after = (
            float(np.sqrt(response @ covariance @ response.T)[0, 0])
            for covariance in (prior, compute_posterior(prior, information))
        )
        return after / before

    prior, information = LINEAR_PRIOR.covariance, accumulate_information(responses, motion)
    assert compare(angle) == pytest.approx(1.0, abs=0.03)
    assert compare(angle + np.pi / 8) == pytest.approx(1.0, abs=0.03)
    prior = LINEAR_PRIOR.covariance.copy()
    prior[find("decay time, relative")] = prior[:, find("decay time, relative")] = 0.0
    assert compare(angle) == pytest.approx(1.0, abs=0.03)
    assert compare(angle + np.pi / 8) < 0.2


def test_one_rate_confounds_what_two_rates_part(responses: Responses) -> None:
    """At one rate a fourth harmonic has two numbers, for three vectors of mechanisms."""
    one = rank_directions(LINEAR_PRIOR.covariance, accumulate_information(responses, move(5 * DEG)))
    seen = [each.gain > 10 for each in one]
    assert sum(seen) == 3  # the decay time, and one vector
    two = accumulate_information(responses, move(alternate(5 * DEG)))
    assert sum(each.gain > 10 for each in rank_directions(LINEAR_PRIOR.covariance, two)) >= 5
    assert compute_map_deviation(responses, bound(responses, move(alternate(5 * DEG))), 0) < (
        0.7 * compute_map_deviation(responses, bound(responses, move(5 * DEG)), 0)
    )


def test_rates_alone_confound_drives_with_damping(responses: Responses) -> None:
    """A drive and a damping anisotropy that make the same amplitude force at rest make it at all
    rates. Virtual rotation parts them; the quadrature force does in proportion to the split."""
    responses = take_amplitude_force(responses)
    drive, damping = find("drive gain mismatch"), find("damping anisotropy, cosine")
    direction = np.zeros(COUNT)
    direction[drive], direction[damping] = 1.0, 1 / GYRO.decay_time
    turned = accumulate_information(responses, move(alternate(5 * DEG)))
    rotated = accumulate_information(responses, move(0.0, alternate(5 * DEG)))
    alone = np.eye(COUNT)[drive]

    def measure(information: Array, of: Array) -> float:
        return float(of @ information @ of)

    assert measure(turned, direction) < 1e-3 * measure(turned, alone)
    assert measure(rotated, direction) > 0.5 * measure(rotated, alone)


def test_virtual_rotation_tells_the_mean(responses: Responses) -> None:
    before = compute_mean_deviation(responses, LINEAR_PRIOR.covariance, 0.0)
    turned = compute_mean_deviation(responses, bound(responses, move(alternate(5 * DEG))), 0.0)
    rotated = compute_mean_deviation(responses, bound(responses, move(0.0, alternate(5 * DEG))), 0)
    assert turned > 0.2 * before
    assert rotated < 0.01 * before


def test_a_mechanism_without_drift_stays_known(responses: Responses) -> None:
    covariance = bound(responses, move(alternate(5 * DEG)))
    known = np.diag(LINEAR_PRIOR.covariance) == 0
    assert known.sum() == COUNT - DRIFTING
    assert not covariance[known].any()
    assert np.all(np.diag(covariance) <= np.diag(LINEAR_PRIOR.covariance) * (1 + 1e-9))


def test_information_grows_with_time(responses: Responses) -> None:
    motion = move(alternate(5 * DEG))
    whole = accumulate_information(responses, motion)
    half = accumulate_information(responses, motion.take(slice(0, len(motion.angle) // 2)))
    assert np.trace(half) == pytest.approx(np.trace(whole) / 2, rel=0.05)


def test_root_of_a_covariance_takes_rounding_for_zero() -> None:
    root = factor_covariance(np.diag([4.0, -1e-17, 0.0]))
    np.testing.assert_allclose(root @ root.T, np.diag([4.0, 0.0, 0.0]))
