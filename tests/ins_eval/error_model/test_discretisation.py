"""Exact steps."""

import numpy as np
import pytest
from scipy.linalg import expm

from ins_eval.error_model.discretisation import (
    discretize,
    matrix_exponential,
    transitions_to_step_end,
)


def test_double_integrator() -> None:
    """White acceleration of density q: q (t^3/3, t^2/2; t^2/2, t) (Groves 2013, Eq. 3.45)."""
    f = np.array([[[0.0, 1], [0, 0]]])
    phi, gained = discretize(f, np.array([np.diag([0.0, 2.0])]), 3.0)
    assert phi[0] == pytest.approx(np.array([[1, 3], [0, 1]]), rel=1e-14)
    assert gained[0] == pytest.approx(2.0 * np.array([[9, 4.5], [4.5, 3]]), rel=1e-13)


def test_two_steps_are_one() -> None:
    generator = np.random.default_rng(5)
    f = generator.normal(size=(20, 4, 4))
    root = generator.normal(size=(20, 4, 4))
    density = root @ np.swapaxes(root, -1, -2)
    phi, gained = discretize(f, density, 0.5)
    twice, all_gained = discretize(f, density, 1.0)
    assert phi @ phi == pytest.approx(twice, rel=1e-10)
    later = phi @ gained @ np.swapaxes(phi, -1, -2) + gained
    assert later == pytest.approx(all_gained, rel=1e-9, abs=1e-9)


def test_transitions_to_the_end() -> None:
    f = np.random.default_rng(6).normal(size=(3, 4, 4))
    result = list(transitions_to_step_end(f, 0.8, 4))
    assert len(result) == 5
    for back, transition in enumerate(result):
        expected, _ = discretize(f, np.zeros_like(f), 0.2 * back)
        assert transition == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("size", [1e-6, 0.3, 3.0, 1000.0])
def test_exponential_is_scipys(size: float) -> None:
    """A small one, and one of a rate that feeds what does not feed back, as gravity does."""
    a = 0.1 * np.random.default_rng(8).normal(size=(5, 6, 6))
    a[:, 3:, :3] = 0.0
    a[:, :3, 3:] *= size
    assert matrix_exponential(a) == pytest.approx(expm(a), rel=1e-11, abs=1e-13 * (1 + size))
    assert matrix_exponential(np.zeros((0, 6, 6))).shape == (0, 6, 6)
