"""Discretization of linear systems, for many steps at once."""

from collections.abc import Iterator
from math import factorial

import numpy as np

from pyhrg.common.arrays import Array


def discretize(f: Array, density: Array, step: float) -> tuple[Array, Array]:
    """Return transition Phi and noise covariance Q, each (n, k, k), of steps, s, with constant
    dynamics f (n, k, k) and white noise of this density (n, k, k).

    docs/methods/error_model.md, Eq. 7 (Van Loan 1978, Theorem 1).
    """
    k = f.shape[-1]
    block = np.zeros((len(f), 2 * k, 2 * k))
    block[:, :k, :k] = -f
    block[:, :k, k:] = density
    block[:, k:, k:] = np.swapaxes(f, -1, -2)
    exponential = matrix_exponential(block * step)
    phi = np.swapaxes(exponential[:, k:, k:], -1, -2)
    covariance = phi @ exponential[:, :k, k:]
    return phi, 0.5 * (covariance + np.swapaxes(covariance, -1, -2))


def transitions_to_step_end(f: Array, step: float, parts: int) -> Iterator[Array]:
    """Yield the transitions (n, k, k) to the end of each step from parts + 1 equally spaced times
    in it, the last time first."""
    part = matrix_exponential(f * (step / parts))
    transition = np.broadcast_to(np.eye(f.shape[-1]), f.shape)
    yield transition
    for _ in range(parts):
        transition = transition @ part
        yield transition


def matrix_exponential(a: Array) -> Array:
    """Return the matrix exponentials (n, k, k) of a batch.

    The method is scaling and squaring with a Taylor polynomial of degree 15 (Higham 2008, section
    10.3; Paterson and Stockmeyer 1973). `scipy.linalg.expm` would call a threaded solver for each
    matrix, which is many times slower for thousands of small matrices on shared cores.
    """
    norm = float(np.max(np.sum(np.abs(a), axis=-1), initial=0.0))
    squarings = max(0, int(np.ceil(np.log2(max(norm, 0.5) / 0.5))))
    x = a / 2**squarings
    powers = [np.eye(a.shape[-1]), x, x @ x]
    powers.append(powers[2] @ x)
    fourth = powers[2] @ powers[2]
    total = np.zeros_like(a)
    for lowest in (12, 8, 4, 0):
        total = total @ fourth
        for k, power in enumerate(powers):
            total += power / factorial(lowest + k)
    for _ in range(squarings):
        total = total @ total
    return total
