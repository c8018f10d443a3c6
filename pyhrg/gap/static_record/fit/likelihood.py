"""Likelihood of many noise models at once, of one integrated record.

The cosine transform of `noise_likelihood`, whose coefficients are independent. What is no noise
enters as columns: some in any size (restricted likelihood), some as random effects of a given
variance, so that "is there a ramp" is asked as "is there a random walk" is.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dct

from pyhrg.noise.likelihood import SAME, spectrum

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Data:
    """Sums over b bands; of m columns the first `free` are there in any size.

    coefficients: (n - 1,) cosine transform of the record without its free columns;
    columns: (m, n - 1) of the columns, the free ones orthonormal, the others without these and of
    unit length; lengths: (r,) of the others as they came, without the free ones;
    starts: (b,) first coefficient of each band; shapes: (4, b) densities at unit strength;
    count: (b,); power: (b,) and products: (m, b), squares: (m, m, b) as in `Spectrum`.
    """

    coefficients: Array
    columns: Array
    lengths: Array
    free: int
    names: tuple[str, ...]
    """Of the columns that are random effects."""
    starts: NDArray[np.int64]
    count: Array
    shapes: Array
    power: Array
    products: Array
    squares: Array

    @property
    def n(self) -> int:
        """Of angles."""
        return len(self.coefficients) + 1

    @property
    def harmonics(self) -> Array:
        """(b,) mean number of half waves of each band."""
        numbers = np.log(np.arange(1, self.n))
        return np.asarray(np.exp(np.add.reduceat(numbers, self.starts) / self.count))


def data_of(angle: Array, free: list[Array], random: dict[str, Array]) -> Data:
    """Transform a record.

    Args:
        angle: (n,) integrated record, SI.
        free: columns (n,) each, in any size, beside an offset and a constant rate.
        random: columns (n,) by name; one that is but a sum of free ones is left out.
    """
    n = len(angle)
    time = np.linspace(-1.0, 1.0, n)
    basis = _orthonormal([np.ones(n), time, *free])

    def rest(values: Array) -> Array:
        return np.asarray(values - basis @ (basis.T @ values))

    left = {name: rest(values) for name, values in random.items()}
    names = tuple(
        name for name in random if np.linalg.norm(left[name]) > SAME * np.linalg.norm(random[name])
    )
    lengths = np.array([np.linalg.norm(left[name]) for name in names])
    others = [left[name] / length for name, length in zip(names, lengths, strict=True)]
    record = dct(rest(angle), norm="ortho")[1:]
    columns = dct(np.array([*basis.T[1:], *others]), norm="ortho")[:, 1:]
    bands = spectrum(angle)
    starts = np.concatenate([[0], np.cumsum(bands.count)[:-1]]).astype(np.int64)

    def summed(values: Array) -> Array:
        return np.asarray(np.add.reduceat(values, starts, axis=-1))

    return Data(
        coefficients=record,
        columns=columns,
        lengths=lengths,
        free=basis.shape[1] - 1,
        names=names,
        starts=starts,
        count=bands.count,
        shapes=bands.shapes,
        power=summed(record**2),
        products=summed(columns * record),
        squares=summed(columns[:, np.newaxis] * columns),
    )


def _orthonormal(columns: list[Array]) -> Array:
    """(n, m) basis of what they span."""
    matrix = np.column_stack(columns)
    matrix = matrix / np.linalg.norm(matrix, axis=0).clip(np.finfo(float).tiny)
    basis, share = np.linalg.qr(matrix)
    return np.asarray(basis[:, np.abs(np.diag(share)) > SAME])


def log_likelihoods(data: Data, strengths: Array, variances: Array) -> Array:
    """(s,) logarithms, but for a constant that all models of the record share.

    Args:
        data: of the record.
        strengths: (s, 4) variances of the noises.
        variances: (s, r) of the random columns' coefficients; 0 is none.
    """
    density = strengths @ data.shapes
    noise = -0.5 * np.sum(data.count * np.log(density) + data.power / density, axis=1)
    square, product = _normal_equations(data, density)
    free = slice(0, data.free)
    inverse = np.asarray(np.linalg.inv(square[:, free, free]), np.float64)
    noise += 0.5 * (
        np.linalg.slogdet(inverse)[1]
        + np.einsum("si,sij,sj->s", product[:, free], inverse, product[:, free])
    )
    square, product = _without(data.free, square, product, inverse)
    root = np.sqrt(variances)
    matrix = np.eye(len(data.names)) + root[:, :, np.newaxis] * square * root[:, np.newaxis]
    pull = root * product
    gained = np.einsum("si,si->s", pull, np.linalg.solve(matrix, pull[..., np.newaxis])[..., 0])
    return np.asarray(noise + 0.5 * (gained - np.linalg.slogdet(matrix)[1]))


def _normal_equations(data: Data, density: Array) -> tuple[Array, Array]:
    m, _, b = data.squares.shape
    square = (1 / density) @ data.squares.reshape(m * m, b).T
    return square.reshape(-1, m, m), (1 / density) @ data.products.T


def _without(free: int, square: Array, product: Array, inverse: Array) -> tuple[Array, Array]:
    """Of the random columns, when the free ones are estimated along."""
    across = square[:, free:, :free] @ inverse
    return (
        square[:, free:, free:] - across @ square[:, :free, free:],
        product[:, free:] - np.einsum("sij,sj->si", across, product[:, :free]),
    )


def column_estimates(data: Data, strengths: Array, variances: Array) -> tuple[Array, Array]:
    """Coefficients (s, r) of the random columns, and their covariances (s, r, r).

    Args: as of `log_likelihoods`.
    """
    square, product = _normal_equations(data, strengths @ data.shapes)
    inverse = np.asarray(np.linalg.inv(square[:, : data.free, : data.free]), np.float64)
    square, product = _without(data.free, square, product, inverse)
    prior = np.maximum(variances, np.finfo(float).tiny ** 0.5)
    covariance = np.asarray(
        np.linalg.inv(square + np.eye(len(data.names)) / prior[:, np.newaxis]), np.float64
    )
    return np.einsum("sij,sj->si", covariance, product), covariance


def whitened(data: Data, strengths: Array, variances: Array) -> Array:
    """(n - 1,) coefficients, their columns taken out, in standard deviations of one model.

    Args:
        data: of the record.
        strengths: (4,) variances of the noises.
        variances: (r,) of the random columns.
    """
    density = strengths @ data.shapes
    weight = np.concatenate([np.full(data.free, 0.0), 1 / np.maximum(variances, 1e-300)])
    square, product = _normal_equations(data, density[np.newaxis])
    scale = 1 / np.sqrt(np.diag(square[0]) + weight)
    matrix = (square[0] + np.diag(weight)) * np.outer(scale, scale)
    size = scale * np.linalg.solve(matrix, scale * product[0])
    numbers = np.arange(1, data.n)
    fine = np.exp(np.interp(np.log(numbers), np.log(data.harmonics), np.log(density)))
    return np.asarray((data.coefficients - size @ data.columns) / np.sqrt(fine))
