"""A step in which the output angle is counted, seen in the angles themselves."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS, NOISES, NoiseEffect
from pyhrg.gap.evidence.noise.noise_search import NORMAL_95, AddedNoise, NoiseFound
from pyhrg.gap.evidence.noise.unstated_noise import STILL
from pyhrg.gap.replay.observations import Observed

Array = NDArray[np.float64]

COUNTED = NOISE_EFFECTS["angle_quantisation"]
FINEST, COARSEST = 0.01 * ARCSEC, 10 * ARCSEC
"""Steps that are looked for, rad."""
SAMPLE = 200
"""Second differences that are compared."""
SAME = 1e-3 * FINEST
"""Distance below which two of them are one, rad."""
BETWEEN = 0.02
"""Share of neighbours that are neither one nor a step apart, on no lattice."""
LATTICE = 0.98
"""Length of the mean phasor of angles on a lattice; of noise that spreads over steps it is less."""
FEW_STEPS = 20
"""Steps from zero up to which the step is fitted."""
ROUGH = 2.0
"""Step over the noise of a reading up to which its error is noise: what repeats of it is less than
exp(-2 pi^2/ROUGH^2) of a step."""
KNOWN = 0.05
"""Share by which a believed step may differ from the one that is seen."""


def counted(
    found: NoiseFound,
    tests: Sequence[Observed],
    believed: float,
    noises: Sequence[NoiseEffect] = NOISES,
) -> NoiseFound:
    """Noises with the step that an output is counted in, in place of the noise of the angle that it
    is: white, or lasting where the angle moves slowly.

    Args:
        found: noises of the output angle.
        tests: that it was found in.
        believed: step, rad; 0 where none is.
        noises: of the catalogue.
    """
    step = quantum(tests) if COUNTED in noises else None
    if step is None or abs(step[0] - believed) < KNOWN * believed:
        return found
    value, spread = step
    ends = (value - NORMAL_95 * spread, value + NORMAL_95 * spread)
    others = [added for added in found.added if added.effect.name != "angle_white_noise"]
    lasting = found.nameless if found.nameless and found.nameless.correlated.of_rate else None
    counting = AddedNoise(COUNTED, value, ends, math.inf, 0.0)
    return replace(found, added=(*others, counting), nameless=lasting)


def is_rough(found: NoiseFound, believed: Device) -> bool:
    """Whether the output is counted in steps so large beside its noise that the error of counting
    repeats with the angle, and is no noise."""
    steps = [added.total for added in found.added if added.effect is COUNTED]
    return max(steps, default=believed.angle_quantum) > ROUGH * believed.pickoff_noise


def quantum(tests: Sequence[Observed]) -> tuple[float, float] | None:
    """Step of the output angle and its standard deviation, rad; None where there is none.

    Second differences of angles on a lattice are on it too.

    Args:
        tests: of which those without rotation count.
    """
    bends = _bends(tests)
    sample = np.sort(bends[:: max(1, len(bends) // SAMPLE)])
    gaps = np.diff(sample)
    steps = gaps[gaps >= FINEST]
    if len(sample) < SAMPLE / 2 or not len(steps):
        return None
    if np.mean((gaps > SAME) & (gaps < FINEST)) > BETWEEN:
        return None
    near = sample[np.abs(sample) < FEW_STEPS * steps.min()]
    counts = np.round(near / steps.min())
    power = float(counts @ counts)
    step = float(near @ counts) / power if power else 0.0
    if not FINEST <= step <= COARSEST:
        return None
    if abs(np.exp(2j * math.pi * bends / step).mean()) < LATTICE:
        return None
    off = float(np.std(near - step * counts))
    return step, max(off, SAME) / math.sqrt(power)


def _bends(tests: Sequence[Observed]) -> Array:
    parts = [
        np.diff(t.log.gyro_angle, 2)
        for t in tests
        if np.abs(t.inputs.table.rates).max() < STILL and not np.ptp(t.log.virtual_rotation)
    ]
    bends = np.concatenate(parts) if parts else np.empty(0)
    return np.asarray(bends[np.isfinite(bends)])
