"""The diagnosis of a static record from file to result."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.gap.static_record.allan import RecordNoise, measure_noise
from pyhrg.gap.static_record.belief import Belief, read_beliefs
from pyhrg.gap.static_record.fit.diagnosis import diagnose_channel
from pyhrg.gap.static_record.fit.hypotheses import FALSE_ALARMS
from pyhrg.gap.static_record.fit.unknowns import split_octaves
from pyhrg.gap.static_record.record import Channel, StaticRecord, read_static_record
from pyhrg.gap.static_record.result import RecordDiagnosis

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


def diagnose_record(
    record: StaticRecord | Path | str,
    belief: Mapping[str, Belief] | Path | str,
    *,
    trusted: bool = False,
    out: Path | str | None = None,
    seed: int = 0,
) -> RecordDiagnosis:
    """Find the noise terms of a static record that exceed a belief (docs/methods/noise.md).

    Args:
        record: a record, or its file (`record.read_static_record`).
        belief: noise by channel (`gyro_x`) or by kind of sensor (`gyros`, `accelerometers`), or a
            TOML file of it (`belief.read_beliefs`).
        trusted: whether units and axes of a file are taken as stated, though gravity or Earth's
            rate in it contradict them.
        out: folder that `diagnosis.json`, `report.html` and `closed.toml` are written to.
        seed: of the importance samples.

    Raises:
        HrgError: the belief is wrong, or holds none of the record's sensors; the file can't be
            used.
        OSError: the folder can't be written.
    """
    beliefs = belief if isinstance(belief, Mapping) else read_beliefs(Path(belief))
    if not isinstance(record, StaticRecord):
        record = read_static_record(Path(record), trusted)
    result = _compare_with_beliefs(record, beliefs, seed)
    if out is not None:
        # the figures of the page load matplotlib
        from pyhrg.gap.static_record.report.page import write_record_report

        write_record_report(result, Path(out))
    return result


def compute_allan(
    record: Path | str, *, trusted: bool = False, out: Path | str | None = None
) -> RecordNoise:
    """Bias, Allan deviation and noise coefficients (IEEE Std 952) of a record at rest.

    Args:
        record: file of an IMU's log (docs/imus.md) or of a bench log (docs/records.md).
        trusted: as in `diagnose_record`.
        out: folder that `allan.json`, `allan.csv` and `report.html` are written to.

    Raises:
        LogError, HrgError: the file can't be used.
        NoiseError: a channel has no noise.
        OSError: the folder can't be written.
    """
    noise = measure_noise(read_static_record(Path(record), trusted))
    if out is not None:
        from pyhrg.gap.static_record.report.allan_page import write_noise_report

        write_noise_report(noise, Path(out))
    return noise


def _compare_with_beliefs(
    record: StaticRecord, beliefs: Mapping[str, Belief], seed: int
) -> RecordDiagnosis:
    """Diagnose the channels that have a belief. Each channel gets an equal part of the record's
    false-alarm rate."""
    belief_of = {c.name: beliefs.get(c.name, beliefs.get(c.kind.table)) for c in record.channels}
    known = {name: belief for name, belief in belief_of.items() if belief is not None}
    channels = [c for c in record.channels if c.name in known]
    if not channels:
        kinds = " and ".join(sorted({c.kind.table for c in record.channels}))
        raise HrgError(f"{record.source}: found a record of {kinds}, expected a belief of them")
    false_alarms = FALSE_ALARMS / len(channels)
    diagnoses = tuple(diagnose_channel(c, known[c.name], false_alarms, seed) for c in channels)
    shared = compute_shared_power([c.part(0, c.half) for c in record.channels])
    kept = [i for i, c in enumerate(record.channels) if c.name in known]
    skipped = [f"{c.name}: it has no belief" for c in record.channels if c.name not in known]
    return RecordDiagnosis(record.source, (*record.notes, *skipped), diagnoses, shared[kept], seed)
