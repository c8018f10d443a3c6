"""Units that all logs of a campaign share: the frequency from which offsets count, and volts of the
nominal amplitude."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pyhrg.records.campaign_import.drafting.guesses import (
    AMPLITUDE_REMARK,
    FREQUENCY_REMARK,
    VOLTS_REMARK,
    Guess,
)
from pyhrg.records.campaign_import.drafting.sketch import Sketch
from pyhrg.records.campaign_import.units import FREQUENCY

NOMINAL_FREQUENCY = 7000.0
"""Hz, where no log has the loop's frequency itself."""
STEADY_RANGE = 0.01
"""Largest relative range of an amplitude whose set point was not changed. Chosen."""
SAME_UNIT_TOLERANCE = 0.1
"""Largest relative difference of an amplitude and its set point in the same unit. Chosen."""


def align_frequencies(guesses: Sequence[dict[str, Guess]]) -> float:
    """Nominal frequency, Hz, of the gyro: that of the first log that has the loop's frequency, to
    three digits. The offsets of all logs are set to it."""
    nominal = 0.0
    for own in guesses:
        guess = own.get("frequency_offset")
        if not guess or guess.remark != FREQUENCY_REMARK:
            continue
        factor = FREQUENCY[str(guess.get("unit"))].factor / FREQUENCY["Hz"].factor
        keys = dict(guess.keys)
        nominal = nominal or float(f"{-float(str(keys['offset'])) * factor:.3g}")
        keys["offset"] = -nominal / factor
        own["frequency_offset"] = replace(guess, keys=tuple(keys.items()))
    return nominal or NOMINAL_FREQUENCY


def align_amplitudes(sketches: Sequence[Sketch], guesses: Sequence[dict[str, Guess]]) -> float:
    """Scale that turns a laboratory's amplitudes, as in volts, into nominal ones: one over the
    median of the longest log in which the amplitude is steady; 1 where none needs it. All logs get
    it, with their set points and their quadrature forces in volts per second."""
    longest, scale = 0, 1.0
    for sketch, own in zip(sketches, guesses, strict=True):
        guess = own.get("amplitude")
        if not guess or guess.remark != AMPLITUDE_REMARK:
            continue
        values = guess.read_values(sketch)
        values = values[np.isfinite(values)]
        middle = float(np.median(values))
        if len(values) > longest and np.ptp(values) < STEADY_RANGE * abs(middle):
            longest, scale = len(values), float(f"{1 / middle:.9g}")
    if not longest:
        return 1.0
    for sketch, own in zip(sketches, guesses, strict=True):
        for stem in _list_in_volts(sketch, own):
            kept = {**dict(own[stem].keys), "scale": scale}
            own[stem] = replace(own[stem], keys=tuple(kept.items()), remark=AMPLITUDE_REMARK)
    return scale


def _list_in_volts(sketch: Sketch, guesses: Mapping[str, Guess]) -> list[str]:
    """Stems of a log that have the unit of its amplitude: that, a set point near it, and a force
    that says so."""
    stems = [stem for stem in ("amplitude", "amplitude_setpoint") if stem in guesses]
    firsts = {stem: float(guesses[stem].read_values(sketch)[:1].sum()) for stem in stems}
    amplitude = firsts.get("amplitude", 0.0)
    listed = [
        stem
        for stem, first in firsts.items()
        if abs(first - amplitude) <= SAME_UNIT_TOLERANCE * abs(amplitude)
    ]
    force = guesses.get("quadrature_force")
    return [*listed, *(["quadrature_force"] if force and force.remark == VOLTS_REMARK else [])]
