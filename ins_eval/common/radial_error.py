"""Radial error of a normal pair (errors north and east) about any mean, with any covariance.

In the covariance's axes, u along the major and v along the minor one, the share within a circle of
radius r is an integral over u of normal densities and of the normal share of v between
+-sqrt(r^2 - u^2) (Gilliland 1962, J. Am. Stat. Assoc. 57, 758). Everything goes over arrays.
"""

import itertools

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import elementwise
from scipy.special import ndtr

Array = NDArray[np.float64]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)
_SLOPE = np.pi / 2 * _NODES
_REACH = 7.0
"""Standard deviations on either side that are looked at; 3e-12 of the share lies beyond."""
_THINNEST = 1e-12
"""Of minor over major standard deviation; a thinner pair counts as this thin."""


def share_within(radius: ArrayLike, mean: Array, covariance: Array) -> Array:
    """Share (...) of pairs with mean (..., 2) and covariance (..., 2, 2) within a radius (...)."""
    along, across, major, minor = _principal(mean, covariance)
    return _share(np.asarray(radius, dtype=float), along, across, major, minor)


def radius_at(share: float, mean: Array, covariance: Array) -> Array:
    """Radius (...) that this share of pairs stays within; shapes as `share_within`.

    Raises:
        ValueError: a share that is not between 0 and 1.
    """
    if not 0 < share < 1:
        raise ValueError(f"share {share}: expected more than 0 and less than 1")
    along, across, major, minor = _principal(mean, covariance)
    distance = np.hypot(along, across)
    sure = major <= 1e-9 * distance
    unit = np.where(sure, 1.0, major)
    scaled = [np.where(sure, 0.0, value / unit) for value in (along, across, minor)]

    def excess(radius: Array, u: Array, v: Array, thin: Array) -> Array:
        return _share(radius, u, v, np.ones_like(u), thin) - share

    spread = np.sqrt(-2 * np.log1p(-share)) + 1e-6
    centre = np.hypot(scaled[0], scaled[1])
    low = np.maximum(centre - _REACH, 0.0)
    found = elementwise.find_root(excess, (low, centre + spread), args=tuple(scaled))
    return np.where(sure, distance, found.x * unit)


def mean_radius(mean: Array, covariance: Array) -> Array:
    """Mean radius (...), by the shares beyond; shapes as `share_within`."""
    along, across, major, minor = _principal(mean, covariance)
    centre = np.hypot(along, across)
    low, high = np.maximum(centre - _REACH * major, 0.0), centre + _REACH * major
    turn = np.clip(across, low, high)
    pair = [value[..., None] for value in (along, across, major, minor)]
    total = low
    for start, end in ((low, turn), (turn, high)):
        radius, weight = _crowded(start, end)
        total = total + np.sum(weight * (1 - _share(radius, *pair)), axis=-1)
    return np.asarray(total)


def _principal(mean: Array, covariance: Array) -> tuple[Array, Array, Array, Array]:
    """Mean along the major and the minor axis, the latter not negative; standard deviations."""
    variances, axes = np.linalg.eigh(np.asarray(covariance, dtype=float))
    turned = np.einsum("...ij,...i->...j", axes, mean)
    minor, major = np.moveaxis(np.sqrt(np.maximum(variances, 0.0)), -1, 0)
    along, across, major, minor = np.broadcast_arrays(
        turned[..., 1], np.abs(turned[..., 0]), major, minor
    )
    return along, across, major, minor


def _share(radius: Array, along: Array, across: Array, major: Array, minor: Array) -> Array:
    """The integral over u, in panels that meet where the circle passes the mean of v."""
    thick = np.where(major > 0, major, 1.0)
    thin = np.maximum(minor, _THINNEST * thick)
    low = np.clip(along - _REACH * thick, -radius, radius)
    high = np.clip(along + _REACH * thick, -radius, radius)
    bend = np.sqrt(np.maximum(radius**2 - across**2, 0.0))
    edges = [low, np.clip(-bend, low, high), np.clip(bend, low, high), high]
    total = np.zeros(np.broadcast_shapes(np.shape(radius), np.shape(along)))
    for start, end in itertools.pairwise(edges):
        u, weight = _crowded(start, end)
        v = np.sqrt(np.maximum(radius[..., None] ** 2 - u**2, 0.0))
        pull = (u - along[..., None]) / thick[..., None]
        density = np.exp(-0.5 * pull**2) / (np.sqrt(2 * np.pi) * thick[..., None])
        within = ndtr((v - across[..., None]) / thin[..., None]) - ndtr(
            (-v - across[..., None]) / thin[..., None]
        )
        total += np.sum(weight * density * within, axis=-1)
    return np.asarray(np.where(major > 0, total, np.hypot(along, across) <= radius))


def _crowded(start: Array, end: Array) -> tuple[Array, Array]:
    """Nodes and weights (..., n) of a panel from start (...) to end, crowded at both."""
    half = 0.5 * (end - start)[..., None]
    nodes = start[..., None] + half * (1 + np.sin(_SLOPE))
    return nodes, np.asarray(np.pi / 2 * _WEIGHTS * np.cos(_SLOPE) * half)
