"""What channels of one record have in common: noise is each sensor's own, motion is not."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.static_record.fit.unknowns import octaves
from pyhrg.gap.static_record.record import Channel

Array = NDArray[np.float64]

BINS = 16
"""Frequencies over which one response of a channel to the others is taken, at most."""
CHANCE = 0.1
"""Share that is not told from chance."""


def shared_power(channels: Sequence[Channel]) -> Array:
    """Share of each channel's power that the others show too, octave by octave, fastest first.

    Multiple coherence (J. Bendat, A. Piersol, Random Data, 4th ed., 7.3) over narrow bands, less
    what as many channels of unrelated noise would show; powers of an octave together. A response
    that changes within a band, or in time, hides some: the true share is this or more.

    Args:
        channels: of one length and interval.

    Returns:
        (c, k); 0 where it may be chance or an octave has too few frequencies to tell.
    """
    spectra = np.array([_spectrum(channel) for channel in channels])
    m, others = spectra.shape[1], len(channels) - 1
    shares = np.zeros((len(channels), len(octaves(m))))
    for k, octave in enumerate(octaves(m)):
        if octave.stop - octave.start < BINS or not others:
            continue
        bands = np.array_split(spectra[:, octave], (octave.stop - octave.start) // BINS, axis=1)
        for c in range(len(channels)):
            powers = np.sum([_shared(band, c) for band in bands], axis=0)
            share = powers[0] / powers[1]
            shares[c, k] = share if share > CHANCE else 0.0
    return shares


def _spectrum(channel: Channel) -> Array:
    """(m,) complex, of the readings under a Hann window; every second frequency, as good as
    independent of the next."""
    readings = np.diff(channel.angle)
    readings = readings - np.mean(readings)
    return np.asarray(np.fft.rfft(readings * np.hanning(len(readings)))[2::2])


def _shared(band: Array, c: int) -> tuple[float, float]:
    """Power of channel c that the others explain beyond chance, and all its power."""
    own, others = band[c], np.delete(band, c, axis=0)
    scale = np.linalg.norm(others, axis=1, keepdims=True).clip(np.finfo(float).tiny)
    basis = np.linalg.qr((others / scale).T)[0]
    total = float(np.sum(np.abs(own) ** 2))
    explained = float(np.sum(np.abs(basis.conj().T @ own) ** 2))
    chance = basis.shape[1] / len(own)
    return (explained - chance * total) / (1 - chance), total
