"""Likelihood of the slow and fast noises of an angle record that is sampled evenly and has no gap.

The angle is white noise plus the integral of rates whose two-sided densities are N^2, B^2/(2 pi f)
and K^2/(2 pi f)^2 (IEEE Std 952, annex C). In the cosine transform (DCT-II) of the record the
coefficients of such noises are independent but for a straight line and a parabola: exactly for
white noise and for both random walks, since the transform diagonalizes the second difference with
free ends and a walk of rate is a bridge plus the line between its ends; nearly for flicker. Line
and parabola are estimated along (restricted likelihood), so that neither a constant rate nor a rate
ramp touches the noises. Unlike points of an Allan curve, the coefficients are not correlated, and
none of the record's information is lost. Everything here is in units of rad and samples.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dct
from scipy.special import zeta

Array = NDArray[np.float64]

POWERS = (0, 2, 3, 4)
"""Density of the angle falls as frequency to this: white angle noise, N, B, K."""
SINGLE = 32
"""Coefficients that are bands of their own; above, a band is a thirty-second of an octave or so."""
FLICKER_TREND = 1.9
"""Variance of the flicker's ramp that the transform leaves to the parabola, times (n/B)^2."""


@dataclass(frozen=True)
class Spectrum:
    """Sufficient statistics of a record: its cosine transform, summed over b narrow bands."""

    samples: int
    """Number of angles."""
    ramp: float
    """Second derivative of the parabola that was taken out, rad per square of a sample."""
    count: Array
    """(b,) coefficients in each band."""
    power: Array
    """(b,) sum of their squares, rad^2."""
    trends: Array
    """(2, b) sum of squares of the transformed line and parabola."""
    products: Array
    """(2, b) sum of their products with the record, rad."""
    shapes: Array
    """(4, b) density of each noise at unit strength, in the order of `POWERS`."""


def spectrum(angle: Array) -> Spectrum:
    """Transform a record.

    Args:
        angle: (n,) rad.
    """
    n = len(angle)
    time = np.arange(n) - (n - 1) / 2
    polynomial = np.polynomial.Polynomial.fit(time, angle, 2)
    rest = angle - polynomial(time)
    record, line, parabola = (dct(x, norm="ortho")[1:] for x in (rest, time, time**2 / 2))
    edges = _band_edges(n - 1)
    trends = np.array([line, parabola])

    def summed(values: Array) -> Array:
        return np.asarray(np.add.reduceat(values, edges, axis=-1))

    count = summed(np.ones(n - 1))
    centre = np.exp(summed(np.log(np.arange(1, n))) / count) / (2 * n)
    return Spectrum(
        samples=n,
        ramp=float(polynomial.deriv(2)(0.0)),
        count=count,
        power=summed(record**2),
        trends=summed(trends**2),
        products=summed(trends * record),
        shapes=_shapes(centre),
    )


def _band_edges(coefficients: int) -> NDArray[np.int64]:
    wide = np.geomspace(SINGLE, coefficients, max(2, int(45 * np.log2(coefficients / SINGLE))))
    return np.unique(np.concatenate([np.arange(SINGLE), wide[:-1].astype(np.int64)]))


def _shapes(frequency: Array) -> Array:
    """Density of sampled angles, (4, b): the sum over all aliases of omega^-p, by Hurwitz' zeta.

    Args:
        frequency: (b,) cycles a sample, below 1/2.
    """
    walks = [(zeta(p, frequency) + zeta(p, 1 - frequency)) / (2 * np.pi) ** p for p in POWERS[1:]]
    return np.array([np.ones_like(frequency), *walks])


@dataclass(frozen=True)
class Misfit:
    """Minus twice the restricted log likelihood at some strengths, and its quadratic model."""

    value: float
    information: Array
    """(4, 4) expected second derivative: twice the inverse covariance of the strengths."""
    pull: Array
    """(4,) the model is least where information @ strengths = pull."""


def misfit(record: Spectrum, strengths: Array) -> Misfit:
    """Judge strengths by a record.

    Args:
        record: of the angles.
        strengths: (4,) variance of each noise, rad^2, in the order of `POWERS`; not all zero.
    """
    density = strengths @ record.shapes
    weight = (record.trends / density).sum(axis=1)
    trend = (record.products / density).sum(axis=1) / weight
    value = np.sum(record.count * np.log(density) + record.power / density)
    value += np.sum(np.log(weight) - trend**2 * weight)
    detrended = record.power - 2 * trend @ record.products
    detrended += (trend**2 + 1 / weight) @ record.trends
    scaled = record.shapes / density
    share = record.trends / density / weight[:, np.newaxis]
    lost = scaled @ share.T
    information = (scaled * (record.count - 2 * share.sum(axis=0))) @ scaled.T + lost @ lost.T
    slope = scaled @ (record.count - detrended / density)
    return Misfit(float(value), information, information @ strengths - slope)


def ramp_misfit(record: Spectrum, strengths: Array, ramp: float) -> float:
    """Minus twice the log likelihood of strengths and a rate ramp.

    The parabola of the record is the ramp and what the slow noises add to it: the ends of a rate
    random walk differ by a variance of K^2 times the record's length.

    Args:
        record: of the angles less their parabola.
        strengths: (4,) as for `misfit`.
        ramp: rad per square of a sample, less that of the parabola taken out.
    """
    centre, deviation = ramp_estimate(record, strengths)
    off = (ramp - centre) / deviation
    return misfit(record, strengths).value + 2 * float(np.log(deviation)) + off**2


def ramp_estimate(record: Spectrum, strengths: Array) -> tuple[float, float]:
    """Rate ramp beyond that of the record's parabola, and its standard deviation.

    Args:
        record: of the angles.
        strengths: (4,) as for `misfit`.
    """
    density = strengths @ record.shapes
    weight = np.sum(record.trends[1] / density)
    ends = strengths[3] / record.samples + FLICKER_TREND * strengths[2] / record.samples**2
    return float(np.sum(record.products[1] / density) / weight), float(np.sqrt(1 / weight + ends))
