"""Evidence by samples against quadrature."""

import numpy as np
import pytest
from scipy.special import logsumexp

from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.evidence import DECADE, Problem, build_problem, compute_posterior
from pyhrg.gap.static_record.fit.likelihood import transform_record
from tests.pyhrg.noises import noisy_angle


def problem_of(extra: tuple[float, float]) -> Problem:
    """Random walk of 1 is believed; flicker and random walk of the rate may be there."""
    angle = noisy_angle(2048, (0, 1, *extra, 0), np.random.default_rng(1))
    belief = Belief(np.array([0.0, 1.0, 0.0, 0.0]), tolerance=0.05)
    return build_problem(transform_record(angle, [], {}), belief, 1.0)


@pytest.mark.parametrize("extra", [(0.0, 0.0), (0.0, 0.02), (0.3, 0.0)])
@pytest.mark.parametrize("effect", [2, 3])
def test_evidence_is_the_integral(extra: tuple[float, float], effect: int) -> None:
    """Over both parameters on a grid; the samples' own error is a tenth or so."""
    of = problem_of(extra)
    believed = np.linspace(-0.3, 0.3, 121)
    level = of.centres[effect] + DECADE * np.linspace(-6, 6, 241)
    grid = np.stack(np.meshgrid(believed, level, indexing="ij"), axis=-1).reshape(-1, 2)
    cell = np.log((believed[1] - believed[0]) * (level[1] - level[0]))
    expected = logsumexp(of.log_posterior((effect,), grid)) + cell
    assert compute_posterior(of, (effect,)).log_evidence == pytest.approx(expected, abs=0.35)


def test_the_level_is_found() -> None:
    of = problem_of((0.0, 0.02))
    found = compute_posterior(of, (3,))
    level = found.levels[:, 3]
    mean = found.weights @ level
    assert mean == pytest.approx(0.02, rel=0.5)
    assert 1 / np.sum(found.weights**2) > 50
    assert found.log_evidence > compute_posterior(of, ()).log_evidence + 10


def test_the_same_seed_gives_the_same_bits() -> None:
    of = problem_of((0.0, 0.02))
    assert (
        compute_posterior(of, (3,), 1).log_evidence == compute_posterior(of, (3,), 1).log_evidence
    )
    assert (
        compute_posterior(of, (3,), 1).log_evidence != compute_posterior(of, (3,), 2).log_evidence
    )
