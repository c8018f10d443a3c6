"""From rates of change to steps of a linear system; batched over steps."""

from collections.abc import Iterator
from math import factorial

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def van_loan(f: Array, density: Array, step: float) -> tuple[Array, Array]:
    """Transition and covariance gained over a step, exact for constant F and density.

    Args:
        f: (n, k, k), 1/s; density: (n, k, k) of the white noise that drives the states; step: s.

    Returns:
        Phi and Q, each (n, k, k) (Van Loan 1978, Theorem 1).
    """
    k = f.shape[-1]
    block = np.zeros((len(f), 2 * k, 2 * k))
    block[:, :k, :k] = -f
    block[:, :k, k:] = density
    block[:, k:, k:] = np.swapaxes(f, -1, -2)
    whole = exponential(block * step)
    phi = np.swapaxes(whole[:, k:, k:], -1, -2)
    gained = phi @ whole[:, :k, k:]
    return phi, 0.5 * (gained + np.swapaxes(gained, -1, -2))


def to_end_of_step(f: Array, step: float, parts: int) -> Iterator[Array]:
    """Transitions (n, k, k) to the end of a step from its equally spaced moments, the last
    first: parts + 1 of them."""
    part = exponential(f * (step / parts))
    transition = np.broadcast_to(np.eye(f.shape[-1]), f.shape)
    yield transition
    for _ in range(parts):
        transition = transition @ part
        yield transition


def exponential(a: Array) -> Array:
    """Matrix exponentials (n, k, k) of a batch; scaling and squaring, Taylor to the 15th power
    (Higham 2008, section 10.3; Paterson and Stockmeyer 1973).

    `scipy.linalg.expm` goes matrix by matrix through a threaded solver, which takes many times as
    long for thousands of small ones where cores are shared.
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
