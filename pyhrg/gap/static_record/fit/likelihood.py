"""Likelihood of many noise models at once for one integrated record (docs/methods/noise.md, Eq. 3).

The coefficients of the cosine transform (`pyhrg.noise.likelihood`) are independent. Signals that
are no noise enter as columns: free columns of any size (restricted likelihood), and random columns
whose coefficient has a given variance. So a ramp is tested in the same way as a random walk.
"""

from dataclasses import dataclass

import numpy as np
from scipy.fft import dct

from pyhrg.common.arrays import Array
from pyhrg.noise.likelihood import MIN_TREND_SHARE, Bands, divide_into_bands, orthonormalize


@dataclass(frozen=True)
class Transform:
    """The cosine transform of a record with its m columns, and sums of it over b bands.

    coefficients: (n - 1,) of the record, with its free columns removed.
    columns: (m, n - 1) of the columns. The first `free` are free and orthonormal. The r others are
        random: orthogonal to the free ones and of unit length.
    lengths: (r,) of the random columns before they were scaled.
    free: number of free columns.
    names: of the random columns.
    bands: of the transform.
    power, products, squares: (b,), (m, b) and (m, m, b) sums as in `Spectrum`.
    """

    coefficients: Array
    columns: Array
    lengths: Array
    free: int
    names: tuple[str, ...]
    bands: Bands
    power: Array
    products: Array
    squares: Array

    @property
    def n(self) -> int:
        """Number of angles."""
        return len(self.coefficients) + 1


def transform_record(angle: Array, free: list[Array], random: dict[str, Array]) -> Transform:
    """Transform an integrated record (n,), SI, with free columns (n,) beside an offset and a
    constant rate, and random ones by name. A random column that free ones combine to is left out.
    """
    n = len(angle)
    time = np.linspace(-1.0, 1.0, n)
    basis = orthonormalize([np.ones(n), time, *free])

    def project(values: Array) -> Array:
        return np.asarray(values - basis @ (basis.T @ values))

    projected = {name: project(values) for name, values in random.items()}
    names = tuple(
        name
        for name in random
        if np.linalg.norm(projected[name]) > MIN_TREND_SHARE * np.linalg.norm(random[name])
    )
    lengths = np.array([np.linalg.norm(projected[name]) for name in names])
    others = [projected[name] / length for name, length in zip(names, lengths, strict=True)]
    record = dct(project(angle), norm="ortho")[1:]
    columns = dct(np.array([*basis.T[1:], *others]), norm="ortho")[:, 1:]
    bands = divide_into_bands(n)
    return Transform(
        coefficients=record,
        columns=columns,
        lengths=lengths,
        free=basis.shape[1] - 1,
        names=names,
        bands=bands,
        power=bands.add_up(record**2),
        products=bands.add_up(columns * record),
        squares=bands.add_up(columns[:, np.newaxis] * columns),
    )


def compute_log_likelihoods(data: Transform, strengths: Array, variances: Array) -> Array:
    """(s,) log likelihoods, up to a constant that all models of the record share.

    Args:
        data: of the record.
        strengths: (s, 4) variances of the noises.
        variances: (s, r) of the random columns' coefficients; 0 removes a column.
    """
    density = strengths @ data.bands.shapes
    noise = -0.5 * np.sum(data.bands.count * np.log(density) + data.power / density, axis=1)
    square, product, free_gain = _eliminate_free_columns(data, density)
    root = np.sqrt(variances)
    matrix = np.eye(len(data.names)) + root[:, :, np.newaxis] * square * root[:, np.newaxis]
    gradient = root * product
    gained = np.einsum(
        "si,si->s", gradient, np.linalg.solve(matrix, gradient[..., np.newaxis])[..., 0]
    )
    return np.asarray(noise + 0.5 * free_gain + 0.5 * (gained - np.linalg.slogdet(matrix)[1]))


def estimate_columns(data: Transform, strengths: Array, variances: Array) -> tuple[Array, Array]:
    """Coefficients (s, r) of the random columns, and their covariances (s, r, r), for arguments of
    `compute_log_likelihoods`."""
    square, product, _ = _eliminate_free_columns(data, strengths @ data.bands.shapes)
    prior = np.maximum(variances, np.finfo(float).tiny ** 0.5)
    covariance = np.asarray(
        np.linalg.inv(square + np.eye(len(data.names)) / prior[:, np.newaxis]), np.float64
    )
    return np.einsum("sij,sj->si", covariance, product), covariance


def _eliminate_free_columns(data: Transform, density: Array) -> tuple[Array, Array, Array]:
    """Normal equations (s, r, r) and (s, r) of the random columns for s densities (s, b), with the
    free ones eliminated, and (s,) what the free ones add to twice the log likelihood."""
    square, product = _sum_normal_equations(data, density)
    free, random = slice(0, data.free), slice(data.free, None)
    inverse = np.asarray(np.linalg.inv(square[:, free, free]), np.float64)
    gain = np.linalg.slogdet(inverse)[1] + np.einsum(
        "si,sij,sj->s", product[:, free], inverse, product[:, free]
    )
    across = square[:, random, free] @ inverse
    return (
        square[:, random, random] - across @ square[:, free, random],
        product[:, random] - np.einsum("sij,sj->si", across, product[:, free]),
        gain,
    )


def _sum_normal_equations(data: Transform, density: Array) -> tuple[Array, Array]:
    m, _, b = data.squares.shape
    square = (1 / density) @ data.squares.reshape(m * m, b).T
    return square.reshape(-1, m, m), (1 / density) @ data.products.T


def whiten_coefficients(data: Transform, strengths: Array, variances: Array) -> Array:
    """(n - 1,) coefficients without their columns, in standard deviations of one noise model of
    strengths (4,) and variances (r,) of the random columns."""
    density = strengths @ data.bands.shapes
    weight = np.concatenate([np.full(data.free, 0.0), 1 / np.maximum(variances, 1e-300)])
    square, product = _sum_normal_equations(data, density[np.newaxis])
    scale = 1 / np.sqrt(np.diag(square[0]) + weight)
    matrix = (square[0] + np.diag(weight)) * np.outer(scale, scale)
    size = scale * np.linalg.solve(matrix, scale * product[0])
    numbers = np.arange(1, data.n)
    fine = np.exp(np.interp(np.log(numbers), np.log(data.bands.harmonics), np.log(density)))
    return np.asarray((data.coefficients - size @ data.columns) / np.sqrt(fine))
