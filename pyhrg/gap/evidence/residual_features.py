"""What a residual shows besides steady white noise: a spectral line, a stretch of other noise,
noise that comes and goes, or far more than noise.

No coordinate of a test predicts any of them (docs/methods/evidence.md, Eqs. (16) to (17a)).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit, logsumexp, ndtri
from scipy.stats import rankdata

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.design import Sizes
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.evidence.evidence import HALF_UNNAMED_ODDS, compute_log_evidence
from pyhrg.gap.evidence.hypothesis import Hypothesis
from pyhrg.gap.evidence.noise.noise_posterior import STATED_LEVEL_SIGMA
from pyhrg.gap.evidence.residuals import Residual, compute_residuals
from pyhrg.gap.evidence.unexplained import find_excesses
from pyhrg.gap.replay.observations import CHANNEL_WORDS, CHANNELS
from pyhrg.gap.whitening.smoothing import is_coarsely_quantized, is_table_coarse

MIN_READINGS = 16
"""Readings that a stretch must have. Chosen."""
BLOCK_ROWS = (1, 8, 64)
"""Numbers of rows that are summed to one reading. Over more rows, wandering noise stands out.
Chosen."""
MAX_LEVEL_RATIO = 10.0
"""Largest ratio, either way, of a stretch's noise to that of its test: end of the prior. Chosen."""
GAUSSIAN_SQUARE_VARIANCE = 2.0
"""Variance of the square of a standard normal number."""
MIN_CYCLES = 5
"""Cycles of a line in the longest test; a slower one is a drift. Chosen."""
FREQUENCIES_PER_WIDTH = 2
"""Frequencies that are tried within the width of a line: zero padding of the transform. Chosen."""


SPELL_ROWS = (4, 16, 64, 256)
"""Lengths of spells of louder noise that are looked for, in rows. Chosen."""
MIN_SPELLS = 4
"""Spells of such a length that a test must have room for. Chosen."""


@dataclass(frozen=True)
class ResidualFeature:
    """A line, or noise that is not steady, that may be there.

    words: what it is and where.
    log_odds: posterior log odds that it is there.
    period: of a line, s.
    """

    words: str
    log_odds: float
    period: float | None = None

    @property
    def probability(self) -> float:
        """Posterior probability that it is there."""
        return float(expit(self.log_odds))


def compute_checked_residuals(
    hypothesis: Hypothesis, removed: Sizes, parts: Sequence[LinearTest]
) -> list[Residual]:
    """Residuals in which features are looked for, without these groups, under the noise of a
    hypothesis.

    An output angle that is coarsely quantized is left out: its quantization error repeats with the
    angle. So are channels in which the steps of a turning table's encoder show, or the noise of a
    coarse thermometer.
    """
    noise = hypothesis.channel_noise
    channels = CHANNELS[1:] if is_coarsely_quantized(parts[0].nominal) else CHANNELS
    errors = hypothesis.design.model_error
    coarse = {
        (part.test.test.id, channel)
        for part in parts
        if is_table_coarse(part.test, part.nominal)
        for channel in part.test.reading_noise
    }
    return [
        r
        for r in compute_residuals(parts, removed, noise, channels, errors)
        if not (r.channel in noise.per_kelvin and noise.reading_steps[r.test])
        and (r.test, r.channel) not in coarse
    ]


def find_residual_features(residuals: Sequence[Residual]) -> tuple[ResidualFeature, ...]:
    """The most probable line, stretch, length of spells and excess, each with the odds of any, in
    residuals of all tests and channels. Those of a few rows, and those that are zero throughout,
    are left out."""
    usable = _list_usable(residuals)
    kinds = [
        list(find(usable))
        for find in (_find_lines, _find_stretches, _find_spells, _describe_excesses)
    ]
    return tuple(_combine(alternatives) for alternatives in kinds if alternatives)


def _list_usable(residuals: Sequence[Residual]) -> list[Residual]:
    return [r for r in residuals if len(r.values) >= 2 * MIN_READINGS and r.values.any()]


def _combine(alternatives: Sequence[ResidualFeature]) -> ResidualFeature:
    """Words of the most probable alternative, odds of any; all equally probable beforehand."""
    best = max(alternatives, key=lambda feature: feature.log_odds)
    total = float(logsumexp([feature.log_odds for feature in alternatives]))
    log_odds = total - math.log(len(alternatives)) + math.log(HALF_UNNAMED_ODDS)
    return replace(best, log_odds=log_odds)


def find_period(residuals: Sequence[Residual]) -> float | None:
    """Period of the most probable line, s, where a line is more probable than not."""
    lines = list(_find_lines(_list_usable(residuals)))
    line = _combine(lines) if lines else None
    return line.period if line and line.log_odds > 0 else None


def _find_lines(residuals: Sequence[Residual]) -> Iterator[ResidualFeature]:
    """A line in each test alone, and in all tests of one row length together, of any phase in each
    or of one phase since power-on, by channel."""
    order = sorted(residuals, key=lambda r: (r.channel, r.interval))
    for (channel, interval), group in groupby(order, key=lambda r: (r.channel, r.interval)):
        members = list(group)
        rows = [np.round(r.times / interval).astype(int) for r in members]
        spans = [int(row[-1]) + 1 for row in rows]
        size = 1 << math.ceil(math.log2(FREQUENCIES_PER_WIDTH * max(spans)))
        slowest = [math.ceil(MIN_CYCLES * size / span) for span in spans]
        spectra = np.array(
            [_compute_spectrum(*own, size) for own in zip(members, rows, slowest, strict=True)]
        )
        powers = np.abs(spectra) ** 2
        sets = [([k], power, 2) for k, power in enumerate(powers)]
        if len(members) > 1:
            everywhere, lengths = list(range(len(members))), np.array([len(row) for row in rows])
            in_phase = np.abs(np.sqrt(lengths) @ spectra) ** 2 / lengths.sum()
            sets.append((everywhere, powers.sum(axis=0), 2 * len(members)))
            sets.append((everywhere, in_phase, 2))
        for tests, power, degrees in sets:
            first = min(slowest[k] for k in tests)
            score = compute_log_evidence(power[first:-1], degrees)
            period = size * interval / _find_peak(power, first + int(np.argmax(score)))
            where = members[tests[0]].test if len(tests) == 1 else f"{len(tests)} tests"
            yield ResidualFeature(
                f"periodic in {period:.4g} s in {where} ({CHANNEL_WORDS[channel]})",
                float(logsumexp(score)) - math.log(len(score)),
                period,
            )


def _find_peak(power: Array, index: int) -> float:
    """Where the parabola through the largest value and its neighbours is largest, as an index."""
    before, peak, after = power[index - 1 : index + 2]
    return float(index + (before - after) / (2 * (before - 2 * peak + after)))


def _compute_spectrum(
    r: Residual, rows: NDArray[np.int64], slowest: int, size: int
) -> NDArray[np.complex128]:
    """(size / 2 + 1,) root of the decrease of chi-square by a line at each frequency, with its
    phase since power-on; zero below the slowest.

    Sigma is that of the residual itself where it exceeds that of the noise model.
    """
    series = np.zeros(size)
    series[rows] = r.white
    level = max(float(np.mean(r.white**2)), 1.0)
    lines = np.fft.rfft(series) * math.sqrt(2 / (len(rows) * level * (1 + r.model_error)))
    lines[:slowest] = 0.0
    return np.asarray(lines)


def _find_stretches(residuals: Sequence[Residual]) -> Iterator[ResidualFeature]:
    """Half of a test, a quarter, and so on, each compared with the level of the whole test."""
    for r in residuals:
        for rows in BLOCK_ROWS:
            count = len(r.white) // rows
            if count < 2 * MIN_READINGS:
                break
            readings = r.white[: count * rows].reshape(count, rows).sum(axis=1)
            squares = readings**2 / np.mean(readings**2)
            variance = max(float(np.var(squares)), GAUSSIAN_SQUARE_VARIANCE)
            information = GAUSSIAN_SQUARE_VARIANCE / variance / (1 + r.model_error)
            summed = np.concatenate([[0.0], np.cumsum(squares)])
            length = count // 2
            while length >= MIN_READINGS:
                begins = np.arange(0, count - length + 1, length // 2)
                level = (summed[begins + length] - summed[begins]) / length
                score = _compute_level_evidence(level, length, information)
                first = r.times[begins[int(np.argmax(score))] * rows]
                yield ResidualFeature(
                    f"noise of its own in {r.test} from {first:.0f} s ({CHANNEL_WORDS[r.channel]})",
                    float(logsumexp(score)) - math.log(len(score)),
                )
                length //= 2


def _compute_level_evidence(level: Array, readings: int, information: float) -> Array:
    """Log evidence that stretches have a level of their own, flat in its logarithm (Eq. (17)).

    `level` is the (n,) mean square of each stretch over that of its test, `readings` the number in
    a stretch. A reading has a share `information` of a Gaussian reading's: below 1 for heavier
    tails.
    """
    log_ratio = np.log(level) / 2
    log_ratio = np.sign(log_ratio) * np.maximum(np.abs(log_ratio) - STATED_LEVEL_SIGMA, 0.0)
    n = readings * information
    gain = n / 2 * (np.exp(2 * log_ratio) - 1 - 2 * log_ratio)
    prior = math.log(2 * math.log(MAX_LEVEL_RATIO))
    return np.asarray(gain + math.log(math.pi / n) / 2 - prior)


def _find_spells(residuals: Sequence[Residual]) -> Iterator[ResidualFeature]:
    """Noise whose level varies within all tests of a channel, by the length of its louder spells:
    squares that are near each other are then alike (Eq. (17a)). Normal scores of their ranks count,
    so that single large readings do not. The noise of a thermometer, which is white only about, is
    no such noise."""
    order = sorted(residuals, key=lambda r: r.channel)
    for channel, group in groupby(order, key=lambda r: r.channel):
        members = [(r, _correlate_squares(r.white)) for r in group if not r.noise.lagged]
        for length in SPELL_ROWS:
            own = [(r, by_lag) for r, by_lag in members if len(r.white) >= MIN_SPELLS * length]
            if not own:
                continue
            products = sum(float(by_lag[1:length].sum()) / (1 + r.model_error) for r, by_lag in own)
            pairs = sum(sum(range(len(r.white) - length + 1, len(r.white))) for r, _ in own)
            score = max(products, 0.0) / math.sqrt(pairs)
            yield ResidualFeature(
                f"noise that comes and goes in spells of {length} rows ({CHANNEL_WORDS[channel]})",
                float(compute_log_evidence(np.array([score**2]), 1)[0]),
            )


def _describe_excesses(residuals: Sequence[Residual]) -> Iterator[ResidualFeature]:
    """Residuals that are more than noise."""
    for r, excess in find_excesses(residuals):
        ratio = math.sqrt(float(np.mean(r.white**2)))
        words = f"{ratio:.3g} times the noise in {r.test} ({CHANNEL_WORDS[r.channel]})"
        yield ResidualFeature(words, excess / 2)


def _correlate_squares(white: Array) -> Array:
    """Sums of products of the normal scores of the squares' ranks, over all pairs of rows, by their
    distance in rows."""
    n = len(white)
    scores = ndtri((rankdata(white**2) - 0.5) / n)
    spectrum = np.fft.rfft(scores, 2 * n)
    return np.asarray(np.fft.irfft(np.abs(spectrum) ** 2))
