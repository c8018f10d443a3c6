"""Distribution of the radial error of a normal pair (north, east) with any mean and covariance.

Let u be the component along the covariance's major axis and v along its minor axis. The probability
of a radius below r is the integral over u of the density of u times the probability that v lies
within +-sqrt(r^2 - u^2) (Gilliland 1962, J. Am. Stat. Assoc. 57, 758).
"""

import itertools

import numpy as np
from scipy.optimize import elementwise
from scipy.special import ndtr

from pyhrg.common.arrays import Array

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)
_SLOPE = np.pi / 2 * _NODES
_RANGE_SIGMA = 7.0
"""Range of the integral on either side of the mean, in standard deviations. Derived: the
probability beyond it is 3e-12."""
_MIN_AXIS_RATIO = 1e-12
"""Smallest ratio of minor to major standard deviation that is integrated; chosen far below any
effect on the result."""


def radius_quantile(probability: float, mean: Array, covariance: Array) -> Array:
    """Radius (...) that is not exceeded with a probability, of pairs with mean (..., 2) and
    covariance (..., 2, 2), in its unit."""
    if not 0 < probability < 1:
        raise ValueError(f"probability {probability}: expected more than 0 and less than 1")
    along, across, major, minor = _principal_axes(mean, covariance)
    distance = np.hypot(along, across)
    certain = major <= 1e-9 * distance
    scale = np.where(certain, 1.0, major)
    scaled = [np.where(certain, 0.0, value / scale) for value in (along, across, minor)]

    def excess(radius: Array, u: Array, v: Array, thin: Array) -> Array:
        return _integrate_probability(radius, u, v, np.ones_like(u), thin) - probability

    spread = np.sqrt(-2 * np.log1p(-probability)) + 1e-6
    centre = np.hypot(scaled[0], scaled[1])
    low = np.maximum(centre - _RANGE_SIGMA, 0.0)
    root = elementwise.find_root(excess, (low, centre + spread), args=tuple(scaled))
    return np.where(certain, distance, root.x * scale)


def _principal_axes(mean: Array, covariance: Array) -> tuple[Array, Array, Array, Array]:
    """Return the mean's components along the major and the minor axis, the latter without its sign,
    and the standard deviations along both."""
    variances, axes = np.linalg.eigh(np.asarray(covariance, dtype=float))
    turned = np.einsum("...ij,...i->...j", axes, mean)
    minor, major = np.moveaxis(np.sqrt(np.maximum(variances, 0.0)), -1, 0)
    along, across, major, minor = np.broadcast_arrays(
        turned[..., 1], np.abs(turned[..., 0]), major, minor
    )
    return along, across, major, minor


def _integrate_probability(
    radius: Array, along: Array, across: Array, major: Array, minor: Array
) -> Array:
    """Integrate over u, in panels that meet where the circle crosses the mean of v."""
    thick = np.where(major > 0, major, 1.0)
    thin = np.maximum(minor, _MIN_AXIS_RATIO * thick)
    low = np.clip(along - _RANGE_SIGMA * thick, -radius, radius)
    high = np.clip(along + _RANGE_SIGMA * thick, -radius, radius)
    bend = np.sqrt(np.maximum(radius**2 - across**2, 0.0))
    edges = [low, np.clip(-bend, low, high), np.clip(bend, low, high), high]
    total = np.zeros(np.broadcast_shapes(np.shape(radius), np.shape(along)))
    for start, end in itertools.pairwise(edges):
        u, weight = _panel_nodes(start, end)
        v = np.sqrt(np.maximum(radius[..., None] ** 2 - u**2, 0.0))
        normalised = (u - along[..., None]) / thick[..., None]
        density = np.exp(-0.5 * normalised**2) / (np.sqrt(2 * np.pi) * thick[..., None])
        within = ndtr((v - across[..., None]) / thin[..., None]) - ndtr(
            (-v - across[..., None]) / thin[..., None]
        )
        total += np.sum(weight * density * within, axis=-1)
    return np.asarray(np.where(major > 0, total, np.hypot(along, across) <= radius))


def _panel_nodes(start: Array, end: Array) -> tuple[Array, Array]:
    """Return nodes and weights (..., n) of a panel from `start` (...) to `end`, denser at both."""
    half = 0.5 * (end - start)[..., None]
    nodes = start[..., None] + half * (1 + np.sin(_SLOPE))
    return nodes, np.asarray(np.pi / 2 * _WEIGHTS * np.cos(_SLOPE) * half)
