"""Restricted likelihood of the noises of an angle record that is evenly sampled, without a gap.

The angle is white noise plus the integral of rates whose two-sided densities are N^2, B^2/(2 pi f)
and K^2/(2 pi f)^2 (IEEE Std 952, annex C). In the cosine transform (DCT-II) of the record the
coefficients of such noises are independent but for a straight line and a parabola: exactly for
white noise and for both random walks, since the transform diagonalizes the second difference with
free ends and a walk of rate is a bridge plus the line between its ends; nearly for flicker. Line,
parabola and other signals are estimated along with the noises (restricted likelihood, H. D.
Patterson, R. Thompson, Biometrika 58 (1971)), so that none of them biases the noises. Unlike points
of an Allan deviation, the coefficients are not correlated, and none of the record's information is
lost. Units are rad and samples.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dct
from scipy.special import zeta

from pyhrg.common.arrays import Array

POWERS = (0, 2, 3, 4)
"""Exponents p of the angle's spectral densities f^-p: angle white noise, N, B, K."""
SINGLE_BANDS = 32
"""Number of lowest coefficients that are bands of their own. Chosen; above them, a band is about a
forty-fifth of an octave."""
MIN_TREND_SHARE = 1e-9
"""A trend is dropped if its part orthogonal to the earlier ones is a smaller share than this.
Chosen."""


@dataclass(frozen=True)
class Bands:
    """Narrow bands, b of them, of the coefficients 1 to n - 1 of a cosine transform.

    Attributes:
        starts: (b,) place of the first coefficient of each band.
        count: (b,) number of coefficients in each band.
        harmonics: (b,) geometric mean of the coefficients' numbers in each band.
        shapes: (4, b) density of each noise at unit strength, in the order of `POWERS`.
    """

    starts: NDArray[np.int64]
    count: Array
    harmonics: Array
    shapes: Array

    def add_up(self, values: Array) -> Array:
        """(..., b) sums over the bands of values (..., n - 1) of the coefficients."""
        return np.asarray(np.add.reduceat(values, self.starts, axis=-1))


def divide_into_bands(n: int) -> Bands:
    """The bands of a record of n angles."""
    starts = _place_band_starts(n - 1)
    count = np.diff(starts, append=n - 1).astype(np.float64)
    harmonics = np.exp(np.add.reduceat(np.log(np.arange(1, n)), starts) / count)
    return Bands(starts, count, harmonics, compute_shapes(harmonics / (2 * n)))


@dataclass(frozen=True)
class Spectrum:
    """Sufficient statistics of a record: its cosine transform, summed over b narrow bands.

    Its m trends are orthonormal: line, parabola, and the orthogonal parts of the others.

    Attributes:
        rest: (n,) angles without their trends (least squares), rad.
        bands: of the transform.
        power: (b,) sum of their squares, rad^2.
        squares: (m, m, b) sum of products of the transformed trends.
        products: (m, b) sum of their products with the record, rad.
    """

    rest: Array
    bands: Bands
    power: Array
    squares: Array
    products: Array


def compute_spectrum(angle: Array, trends: Sequence[Array] = ()) -> Spectrum:
    """The spectrum of a record.

    Trends are (n,) signals that the angles may contain in any size, beside an offset, a constant
    rate and a rate ramp.
    """
    n = len(angle)
    time = np.linspace(-1.0, 1.0, n)
    basis = orthonormalize([np.ones(n), time, time**2, *trends])
    rest = angle - basis @ (basis.T @ angle)
    record, columns = (dct(x, norm="ortho")[..., 1:] for x in (rest, basis.T[1:]))
    bands = divide_into_bands(n)
    return Spectrum(
        rest=rest,
        bands=bands,
        power=bands.add_up(record**2),
        squares=bands.add_up(columns[:, np.newaxis] * columns),
        products=bands.add_up(columns * record),
    )


def orthonormalize(columns: Sequence[Array]) -> Array:
    """(n, m) orthonormal basis of the space that columns (n,) span, in their order; a column that
    depends on those before it is left out."""
    matrix = np.column_stack(columns)
    matrix = matrix / np.linalg.norm(matrix, axis=0).clip(np.finfo(float).tiny)
    basis, share = np.linalg.qr(matrix)
    return np.asarray(basis[:, np.abs(np.diag(share)) > MIN_TREND_SHARE])


def _place_band_starts(coefficients: int) -> NDArray[np.int64]:
    wide = np.geomspace(
        SINGLE_BANDS, coefficients, max(2, int(45 * np.log2(coefficients / SINGLE_BANDS)))
    )
    return np.unique(np.concatenate([np.arange(SINGLE_BANDS), wide[:-1].astype(np.int64)]))


def compute_shapes(frequency: Array) -> Array:
    """(4, b) densities of sampled angles: the sum of omega^-p over all aliases, by Hurwitz' zeta.

    Frequencies are (b,) cycles a sample, below 1/2.
    """
    walks = [(zeta(p, frequency) + zeta(p, 1 - frequency)) / (2 * np.pi) ** p for p in POWERS[1:]]
    return np.array([np.ones_like(frequency), *walks])


@dataclass(frozen=True)
class Misfit:
    """Minus twice the restricted log likelihood at some strengths, and its quadratic model.

    Attributes:
        value: minus twice the log likelihood, without constants.
        information: (4, 4) expected second derivative, twice the inverse covariance of the
            strengths.
        right_side: (4,) the model is least where information @ strengths equals it.
    """

    value: float
    information: Array
    right_side: Array


def compute_misfit(records: Sequence[Spectrum], strengths: Array) -> Misfit:
    """Misfit of strengths to records that share them.

    Strengths are (4,) variances, rad^2, in the order of `POWERS`, not all zero.
    """
    parts = [_compute_record_misfit(record, strengths) for record in records]
    return Misfit(
        value=sum(part.value for part in parts),
        information=np.sum([part.information for part in parts], axis=0),
        right_side=np.sum([part.right_side for part in parts], axis=0),
    )


def _compute_record_misfit(record: Spectrum, strengths: Array) -> Misfit:
    bands = record.bands
    density = strengths @ bands.shapes
    trends = len(record.products)
    root = np.linalg.cholesky(np.sum(record.squares / density, axis=-1))
    inverse = np.linalg.inv(root)
    # trends that the density's inverse makes orthonormal
    both = np.einsum("ij,kl->ikjl", inverse, inverse).reshape(trends**2, trends**2)
    squares = both @ record.squares.reshape(trends**2, -1)
    products = inverse @ record.products
    size = np.sum(products / density, axis=1)
    value = np.sum(bands.count * np.log(density) + record.power / density)
    value += 2 * np.sum(np.log(np.diag(root))) - size @ size
    scaled = bands.shapes / density
    taken = np.sum(squares[:: trends + 1], axis=0) / density
    lost = (scaled / density) @ squares.T
    information = (scaled * (bands.count - 2 * taken)) @ scaled.T + lost @ lost.T
    detrended = record.power - 2 * size @ products + np.outer(size, size).ravel() @ squares
    slope = scaled @ (bands.count - taken - detrended / density)
    return Misfit(float(value), information, information @ strengths - slope)


def describe_estimator(
    records: Sequence[Spectrum], model: Misfit, strengths: Array, index: int
) -> tuple[float, float]:
    """Standard deviation, rad^2, and skewness of one strength's estimate, the others fitted too.

    `model` is the misfit at the true strengths (4,), rad^2. The skewness is that without trends.
    """
    inverse = np.linalg.inv(model.information)[index]
    cubes = squares = 0.0
    for record in records:
        bands = record.bands
        influence = inverse @ (bands.shapes / (strengths @ bands.shapes))
        squares += float(bands.count @ influence**2)
        cubes += float(bands.count @ influence**3)
    return float(np.sqrt(2 * inverse[index])), float(np.sqrt(8) * cubes / squares**1.5)
