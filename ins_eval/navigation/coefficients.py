"""Coefficients of the coning, sculling and scrolling terms for 2 to 4 increments a step.

They are derived here from docs/methods/navigation.md, Eqs. 6 to 9: rate and specific force are the
polynomials whose integrals are the increments, and their products are integrated exactly. The
condition of the highest pair of powers is replaced by that of pure coning (Miller 1983). The unit
of time is the step.
"""

from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

SAMPLES_PER_STEP = (2, 3, 4)
"""Numbers of increments that a navigation step may have."""


class StepCoefficients(NamedTuple):
    """Factors of the products of a step's increments alpha_i (rotation) and beta_j (velocity).

    Attributes:
        turning: (n, n), antisymmetric: factors K_ij of alpha_i x alpha_j, i < j, in the rotation
            vector (coning) and of alpha_i x beta_j in the velocity change (sculling; the same
            numbers: Roscoe 2001).
        scrolling: (n, n): factors S_ij of alpha_i x beta_j in the mean of the velocity change.
        mean: (n,): factors m_j of beta_j in the mean of the velocity change.
    """

    turning: Array
    scrolling: Array
    mean: Array


@lru_cache
def derive_coefficients(samples: int) -> StepCoefficients:
    """Derive the coefficients for steps of 2, 3 or 4 increments."""
    if samples not in SAMPLES_PER_STEP:
        raise HrgError(f"samples: found {samples} increments a step, expected 2, 3 or 4")
    rates = _unit_integrals(samples)
    to_go = Polynomial([1.0, -1.0])
    products = [[rate_i.integ() * rate_j for rate_j in rates] for rate_i in rates]
    return StepCoefficients(
        turning=_turning(samples),
        scrolling=np.array([[_over_step(to_go * p) for p in row] for row in products]) - 1 / 6,
        mean=np.array([_over_step(to_go * rate) for rate in rates]),
    )


def _turning(samples: int) -> Array:
    """Solve docs/methods/navigation.md, Eqs. 6 and 7, for K (n, n).

    There is one condition for each pair of powers of time about the step's middle. The pair of the
    highest powers is replaced by the condition of pure coning (Miller 1983).
    """
    pairs = list(combinations(range(samples), 2))
    bounds = np.arange(samples + 1) / samples
    middle = Polynomial([-0.5, 1.0])
    moments = [np.diff((middle**k).integ()(bounds)) for k in range(samples)]
    conditions, values = [], []
    for k, l in pairs[:-1]:
        conditions.append(
            [moments[k][i] * moments[l][j] - moments[l][i] * moments[k][j] for i, j in pairs]
        )
        values.append(_excess_turn(middle**k, middle**l))
    p = 2 * samples - 1
    apart = [j - i for i, j in pairs]
    conditions.append([(m + 1.0) ** p + (m - 1.0) ** p - 2.0 * m**p for m in apart])
    values.append(samples**p / 2)
    solved = np.zeros((samples, samples))
    solved[tuple(np.transpose(pairs))] = np.linalg.solve(conditions, values)
    return solved - solved.T


def _excess_turn(a: Polynomial, b: Polynomial) -> float:
    """Return half the integral of A b - B a over the step; A and B are the integrals of the rates a
    and b from 0."""
    return 0.5 * _over_step(a.integ(lbnd=0) * b - b.integ(lbnd=0) * a)


def _over_step(p: Polynomial) -> float:
    return float(p.integ()(1.0))


def _unit_integrals(samples: int) -> list[Polynomial]:
    """Return the polynomial for each part of the step that integrates to 1 over that part and to 0
    over each other part."""
    powers = [Polynomial([0.0] * k + [1.0]).integ() for k in range(samples)]
    bounds = np.arange(samples + 1) / samples
    integrals = np.array([np.diff(power(bounds)) for power in powers]).T
    return [Polynomial(column) for column in np.linalg.inv(integrals).T]
