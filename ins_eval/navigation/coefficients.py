"""Weights of coning, sculling and scrolling terms for 2 to 4 increments a step.

Rate and specific force are taken as the polynomials whose integrals the increments are, and the
weights integrate their products exactly; the last degree of freedom of coning and sculling goes to
exactness for pure coning. Derived here, not typed. Lengths are in steps.
"""

from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

Array = NDArray[np.float64]

SAMPLES = (2, 3, 4)
"""Numbers of increments that a step may have."""


class Weights(NamedTuple):
    """What products of a step's increments contribute beyond those of constant rate and force.

    turning: (n, n), antisymmetric. Coning: of alpha_i x alpha_j, i < j, to the rotation vector.
        Sculling: of alpha_i x beta_j to the velocity change (the same numbers: Roscoe 2001).
    scrolling: (n, n); of alpha_i x beta_j to the mean of the velocity change over the step.
    mean: (n,); of beta_j to the mean of the velocity change over the step.
    """

    turning: Array
    scrolling: Array
    mean: Array


@lru_cache
def weights(samples: int) -> Weights:
    """Weights for steps of so many increments.

    Raises:
        ValueError: a number that is not in `SAMPLES`.
    """
    if samples not in SAMPLES:
        raise ValueError(f"{samples} increments a step: expected {SAMPLES[0]} to {SAMPLES[-1]}")
    rates = _unit_integrals(samples)
    to_go = Polynomial([1.0, -1.0])
    products = [[rate_i.integ() * rate_j for rate_j in rates] for rate_i in rates]
    return Weights(
        turning=_turning(samples),
        scrolling=np.array([[_over_step(to_go * p) for p in row] for row in products]) - 1 / 6,
        mean=np.array([_over_step(to_go * rate) for rate in rates]),
    )


def _turning(samples: int) -> Array:
    """Solved from one condition for each pair of powers of time about the middle of the step; the
    highest pair's place takes pure coning at the order of its frequency that is still open
    (Miller 1983): sums over pairs m apart, D_m, have sum of D_m (second difference of m^p) = n^p/2,
    p = 2n - 1."""
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
    """Half the integral of (A b - B a), A and B the integrals of the rates a and b from 0."""
    return 0.5 * _over_step(a.integ(lbnd=0) * b - b.integ(lbnd=0) * a)


def _over_step(p: Polynomial) -> float:
    return float(p.integ()(1.0))


def _unit_integrals(samples: int) -> list[Polynomial]:
    """Polynomials over [0, 1] that integrate to 1 over their own part of it, to 0 over others."""
    powers = [Polynomial([0.0] * k + [1.0]).integ() for k in range(samples)]
    bounds = np.arange(samples + 1) / samples
    integrals = np.array([np.diff(power(bounds)) for power in powers]).T
    return [Polynomial(column) for column in np.linalg.inv(integrals).T]
