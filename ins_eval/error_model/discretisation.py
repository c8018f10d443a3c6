"""From rates of change to steps of a linear system; batched over steps."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

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
    exponential = expm(block * step)
    phi = np.swapaxes(exponential[:, k:, k:], -1, -2)
    gained = phi @ exponential[:, :k, k:]
    return phi, 0.5 * (gained + np.swapaxes(gained, -1, -2))


def to_end_of_step(f: Array, step: float, parts: int) -> Iterator[Array]:
    """Transitions (n, k, k) to the end of a step from its equally spaced moments, the last
    first: parts + 1 of them."""
    part = expm(f * (step / parts))
    transition = np.broadcast_to(np.eye(f.shape[-1]), f.shape)
    yield transition
    for _ in range(parts):
        transition = transition @ part
        yield transition
