"""Power that several channels of a record share. Sensors have independent noise; motion is
common."""

from collections.abc import Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.fit.unknowns import split_octaves
from pyhrg.gap.static_record.record import Channel

BAND_FREQUENCIES = 16
"""Smallest number of frequencies in a band over which one response is fitted (chosen)."""
SMALLEST_SHARE = 0.1
"""Coherent share of an octave's power below which it counts as chance (chosen)."""


def compute_shared_power(channels: Sequence[Channel]) -> Array:
    """Share of each channel's power that is coherent with the other channels, octave by octave,
    from the highest frequencies down (docs/methods/noise.md, Eq. 12).

    Multiple coherence (J. Bendat, A. Piersol, Random Data, 4th ed., 7.3) over narrow bands, less
    its expectation for independent channels. A response that changes within a band or in time
    lowers the estimate, so the true share is this or more. The result is (c, k) for c channels of
    one length and interval; 0 where the share may be chance or an octave has too few frequencies.
    """
    spectra = np.array([_compute_spectrum(channel) for channel in channels])
    m, others = spectra.shape[1], len(channels) - 1
    shares = np.zeros((len(channels), len(split_octaves(m))))
    for k, octave in enumerate(split_octaves(m)):
        if octave.stop - octave.start < BAND_FREQUENCIES or not others:
            continue
        bands = np.array_split(
            spectra[:, octave], (octave.stop - octave.start) // BAND_FREQUENCIES, axis=1
        )
        for c in range(len(channels)):
            powers = np.sum([_compute_coherent_power(band, c) for band in bands], axis=0)
            share = powers[0] / powers[1]
            shares[c, k] = share if share > SMALLEST_SHARE else 0.0
    return shares


def _compute_spectrum(channel: Channel) -> Array:
    """(m,) complex spectrum of the readings under a Hann window, at every second frequency: these
    are nearly independent."""
    readings = np.diff(channel.angle)
    readings = readings - np.mean(readings)
    return np.asarray(np.fft.rfft(readings * np.hanning(len(readings)))[2::2])


def _compute_coherent_power(band: Array, c: int) -> tuple[float, float]:
    """Power of channel c in a band (c, m) that is coherent with the others beyond chance, and its
    total power."""
    own, others = band[c], np.delete(band, c, axis=0)
    scale = np.linalg.norm(others, axis=1, keepdims=True).clip(np.finfo(float).tiny)
    basis = np.linalg.qr((others / scale).T)[0]
    total = float(np.sum(np.abs(own) ** 2))
    explained = float(np.sum(np.abs(basis.conj().T @ own) ** 2))
    chance = basis.shape[1] / len(own)
    return (explained - chance * total) / (1 - chance), total
