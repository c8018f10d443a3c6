"""Evidence that a noise term exceeds what is believed of it, its level marginalised."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag
from scipy.optimize import minimize
from scipy.special import gammaln, logsumexp

from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.likelihood import Data, log_likelihoods
from pyhrg.noise.likelihood import POWERS

Array = NDArray[np.float64]

DECADE = float(np.log(10))
"""Standard deviation of the logarithm of a level that nothing is believed of."""
DETECTABLE = 10.0
"""Strength at the middle of that prior, in standard deviations with which it could be found."""
FREEDOM = 4
"""Of the t-distribution that importance is sampled from."""
SAMPLES = 400
"""By which an integral is taken."""
STEP = 1e-3
"""Of the prior's deviations, by which derivatives are taken."""
RAMP = "ramp"
"""Name of the column that a constant change of the rate makes."""
FAR = 8.0
"""Standard deviations of the prior beyond which nothing is looked for."""


@dataclass(frozen=True)
class Problem:
    """A record and what is believed of it: parameters are logarithms of levels.

    The first are those of the believed noises, normal about belief with its tolerance. What exceeds
    belief adds to the strengths: normal in the logarithm of its level, a decade wide, about the
    level that the record would show with ten standard deviations if all else were as believed.
    """

    data: Data
    belief: Array
    """(4,) levels as roots of strengths: angles."""
    units: Array
    """(4,) SI level of a root of strength of 1."""
    tolerance: float
    walked: Array
    """(r,) variance of each column's coefficient that rate random walk of unit strength brings: it
    is a bridge, which the cosine transform knows, plus the line between its ends."""

    @cached_property
    def believed(self) -> NDArray[np.int64]:
        """(p,) indices of the noises that are believed to be there."""
        return np.flatnonzero(self.belief)

    @property
    def effects(self) -> int:
        """Number of what may exceed belief: four noises, then the random columns."""
        return len(self.belief) + len(self.data.names)

    @cached_property
    def without_extra(self) -> tuple[Array, Array]:
        """Mode (p,) and root (p, p) of the covariance of what is believed, if it is all."""
        mode = _mode(self, (), np.zeros(len(self.believed)))
        return mode, _root(self, (), mode)

    @cached_property
    def centres(self) -> Array:
        """(e,) logarithms of levels at which the prior of each is centred."""
        density = self.belief**2 @ self.data.shapes
        noise = np.sqrt(2 / ((self.data.shapes / density) ** 2 @ self.data.count))
        r = np.arange(self.data.free, len(self.data.columns))
        column = 1 / np.sum(self.data.squares[r, r] / density, axis=-1)
        return 0.5 * np.log(DETECTABLE * np.concatenate([noise, column]))

    def unpack(self, extra: Sequence[int], parameters: Array) -> tuple[Array, Array]:
        """Strengths (s, 4) and variances (s, r) of parameters (s, p + x)."""
        total = np.zeros((len(parameters), self.effects))
        centre, width = self.prior(extra)
        parameters = np.clip(parameters, centre - FAR * width, centre + FAR * width)
        p = len(self.believed)
        total[:, self.believed] = (self.belief[self.believed] * np.exp(parameters[:, :p])) ** 2
        total[:, list(extra)] += np.exp(2 * parameters[:, p:])
        return total[:, :4], total[:, 4:] + total[:, 3:4] * self.walked

    def log_prior(self, extra: Sequence[int], parameters: Array) -> Array:
        """(s,) of parameters (s, p + x)."""
        centre, width = self.prior(extra)
        away = (parameters - centre) / width
        return np.asarray(-0.5 * np.sum(away**2 + np.log(2 * np.pi * width**2), axis=1))

    def prior(self, extra: Sequence[int]) -> tuple[Array, Array]:
        """Means and standard deviations (p + x,) of the parameters."""
        p = len(self.believed)
        centre = np.concatenate([np.zeros(p), self.centres[list(extra)]])
        return centre, np.concatenate([np.full(p, self.tolerance), np.full(len(extra), DECADE)])

    def log_posterior(self, extra: Sequence[int], parameters: Array) -> Array:
        """(s,) but for the evidence."""
        return log_likelihoods(self.data, *self.unpack(extra, parameters)) + self.log_prior(
            extra, parameters
        )


def problem(data: Data, belief: Belief, interval: float) -> Problem:
    """With levels in the record's own units, where rates are of one interval."""
    units = interval ** ((1 - np.maximum(POWERS, 1)) / 2)
    ramp = np.array([name == RAMP for name in data.names])
    walked = ramp * data.lengths**2 / (data.n * interval**4)
    return Problem(data, belief.levels / units, units, belief.tolerance, walked)


@dataclass(frozen=True)
class Posterior:
    """What a model says after the record, as weighted samples.

    extra: what exceeds belief; log_evidence; parameters: (s, p + x); weights: (s,), sum 1.
    """

    problem: Problem
    extra: tuple[int, ...]
    log_evidence: float
    parameters: Array
    weights: Array

    @cached_property
    def levels(self) -> Array:
        """(s, e) square roots of all strengths and variances."""
        return np.sqrt(np.concatenate(self.problem.unpack(self.extra, self.parameters), axis=1))

    @property
    def best(self) -> tuple[Array, Array]:
        """(4,) strengths and (r,) variances: weighted means in the logarithm."""
        mean = self.weights @ self.parameters
        strengths, variances = self.problem.unpack(self.extra, mean[np.newaxis])
        return strengths[0], variances[0]

    @property
    def effective(self) -> float:
        """Number of independent samples that the weights amount to."""
        return float(1 / np.sum(self.weights**2))


def posterior(of: Problem, extra: Sequence[int], seed: int = 0) -> Posterior:
    """Evidence by importance sampling (t-distributions of 4 degrees of freedom): half about the
    posterior's mode; half where what is believed fits alone and the rest is as before the record.

    Args:
        of: the record and its belief.
        extra: indices of the noises and columns that exceed belief.
        seed: of the samples.
    """
    extra = tuple(extra)
    mode = max(
        (_mode(of, extra, start) for start in _starts(of, extra)),
        key=lambda x: float(of.log_posterior(extra, x[np.newaxis])[0]),
    )
    nothing, width = of.without_extra, DECADE * np.eye(len(extra))
    centres = np.array([mode, [*nothing[0], *of.centres[list(extra)]]])
    roots = np.array([_root(of, extra, mode), block_diag(nothing[1], width)])
    parameters = _drawn(centres, roots, np.random.default_rng([seed, *extra]))
    logs = of.log_posterior(extra, parameters) - _log_density(parameters, centres, roots)
    total = float(logsumexp(logs))
    return Posterior(of, extra, total - np.log(len(logs)), parameters, np.exp(logs - total))


def _drawn(centres: Array, roots: Array, generator: np.random.Generator) -> Array:
    """(s, d): as many of each multivariate t-distribution."""
    k, d = centres.shape
    normal = generator.standard_normal((k, SAMPLES // k, d))
    t = normal / np.sqrt(generator.chisquare(FREEDOM, (k, SAMPLES // k, 1)) / FREEDOM)
    return np.asarray(centres[:, np.newaxis] + t @ np.swapaxes(roots, 1, 2)).reshape(-1, d)


def _log_density(parameters: Array, centres: Array, roots: Array) -> Array:
    """(s,) of the even mixture."""
    d = parameters.shape[1]
    constant = gammaln((FREEDOM + d) / 2) - gammaln(FREEDOM / 2) - d / 2 * np.log(FREEDOM * np.pi)
    logs = []
    for centre, root in zip(centres, roots, strict=True):
        t = np.linalg.solve(root, (parameters - centre).T)
        tail = (FREEDOM + d) / 2 * np.log1p(np.sum(t**2, axis=0) / FREEDOM)
        logs.append(constant - tail - np.linalg.slogdet(root)[1])
    return np.asarray(logsumexp(logs, axis=0) - np.log(len(logs)))


def _starts(of: Problem, extra: tuple[int, ...]) -> list[Array]:
    """Levels at the prior's middle, and the largest that the record allows anywhere."""
    data, p = of.data, len(of.believed)
    noise = np.min(data.power / data.count / data.shapes, axis=1)
    density = np.maximum(of.belief**2 @ data.shapes, data.power / data.count)
    r = np.arange(data.free, len(data.columns))
    column = (
        np.sum(data.products[r] / density, axis=-1) / np.sum(data.squares[r, r] / density, axis=-1)
    ) ** 2
    most = 0.5 * np.log(np.maximum(np.concatenate([noise, column]), 1e-300))
    most = np.clip(most, of.centres - FAR * DECADE, of.centres + FAR * DECADE)
    return [
        np.concatenate([np.zeros(p), levels[list(extra)]])
        for levels in ((of.centres, most) if extra else (of.centres,))
    ]


def _mode(of: Problem, extra: tuple[int, ...], start: Array) -> Array:
    """By the gradient, in standard deviations of the prior."""
    centre, width = of.prior(extra)
    steps = STEP * np.concatenate([np.zeros((1, len(start))), np.eye(len(start))])
    steps = np.concatenate([steps, -steps[1:]])

    def falling(x: Array) -> tuple[float, Array]:
        values = -of.log_posterior(extra, centre + width * (x + steps))
        ahead, behind = np.split(values[1:], 2)
        return float(values[0]), (ahead - behind) / (2 * STEP)

    bounds = [(-FAR, FAR)] * len(start)
    options = {"ftol": 1e-9, "gtol": 0.01}
    begin = (start - centre) / width
    found = minimize(falling, begin, jac=True, method="L-BFGS-B", bounds=bounds, options=options)
    return np.asarray(centre + width * found.x)


def _root(of: Problem, extra: tuple[int, ...], mode: Array) -> Array:
    """Of the covariance at the mode by curvature, nowhere wider than the prior."""
    d, step = len(mode), 10 * STEP
    one = step * np.eye(d)
    signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    points = np.array(
        [a * one[i] + b * one[j] for a, b in signs for i in range(d) for j in range(d)]
    )
    values = of.log_posterior(extra, mode + points).reshape(4, d, d)
    curvature = -(values[0] - values[1] - values[2] + values[3]) / (4 * step**2)
    width = of.prior(extra)[1]
    size, axes = np.linalg.eigh((curvature + curvature.T) / 2 * np.outer(width, width))
    return np.asarray(width[:, np.newaxis] * axes / np.sqrt(np.maximum(size, 1.0)))
