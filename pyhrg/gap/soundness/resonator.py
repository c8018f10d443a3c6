"""Checks of the amplitude and its force against the set point and the decay time."""

import math
from dataclasses import replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.soundness.exclusion import Exclusion, NominalEstimate, exclude_columns, find_runs
from pyhrg.records import Log
from pyhrg.records.campaign import INDEX, Campaign

AMPLITUDE_TOLERANCE = 0.1
"""Relative departure of the median amplitude from its set point above which the column is wrong.
Chosen: a working loop stays far below."""
MAX_DECAY_TIME_DEPARTURE = 0.2
"""Relative departure from the nominal decay time above which no effect explains it, near the
reference temperature. Chosen."""
TEMPERATURE_RANGE = 10.0
"""Departure from the reference temperature up to which a decay time is estimated, K. Chosen."""
MIN_RING_DOWN = 50.0
"""Shortest ring-down from which a decay time is estimated, s. Chosen."""


def mend_nominal_amplitude(campaign: Campaign, stated: float) -> tuple[Campaign, list[str]]:
    """The campaign with the amplitude at which its logs begin, and a sentence where it states
    another: a gyro is held at its set point. An amplitude test may begin elsewhere."""
    logs = [test.log for test in campaign.tests if test.kind != "amplitude"]
    held = {float(log.amplitude_setpoint[0]) for log in logs}
    if len(held) != 1 or held == {stated}:
        return campaign, []
    (amplitude,) = held
    sentence = f"{INDEX}: nominal.amplitude: {stated:g}, but every log begins with a set point of "
    nominal = {**campaign.nominal, "amplitude": amplitude}
    return replace(campaign, nominal=nominal), [f"{sentence}{amplitude:g}, which is taken"]


def check_amplitude(log: Log) -> list[Exclusion]:
    """Exclude an amplitude that is not at its set point."""
    driven = log.is_driven & (log.amplitude_setpoint > 0)
    if not log.has_values("amplitude") or not np.isfinite(log.amplitude[driven]).any():
        return []
    share = float(np.nanmedian(log.amplitude[driven] / log.amplitude_setpoint[driven]))
    if abs(share - 1) <= AMPLITUDE_TOLERANCE:
        return []
    trouble = f"{share:.4g} of amplitude_setpoint; expected about 1"
    return [exclude_columns(log, ("amplitude",), trouble)]


def check_swapped_forces(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude amplitude and quadrature forces that stand under each other's name."""
    pair = ("amplitude_force", "quadrature_force")
    low, high = _allowed_decay_times(nominal)
    own, other = (_compute_decay_time(getattr(log, field), log, nominal) for field in pair)
    if low <= own <= high or not low <= other <= high:
        return []
    trouble = f"the second holds 1/{other:.4g} s, the decay: are they swapped?"
    return [exclude_columns(log, pair, trouble)]


def estimate_decay_time(log: Log, nominal: Device) -> list[NominalEstimate]:
    """Estimates of the decay time from the amplitude's force and from a ring-down."""
    estimates = []
    decay_time = _compute_decay_time(log.amplitude_force, log, nominal)
    if math.isfinite(decay_time):
        limits = _allowed_decay_times(nominal)
        values = (nominal.decay_time, decay_time, *limits)
        estimates.append(NominalEstimate("decay_time_s", "amplitude_force", log.source, *values))
    return estimates + _estimate_from_ring_down(log, nominal)


def _allowed_decay_times(nominal: Device) -> tuple[float, float]:
    decay_time = nominal.decay_time
    return decay_time * (1 - MAX_DECAY_TIME_DEPARTURE), decay_time * (1 + MAX_DECAY_TIME_DEPARTURE)


def _compute_decay_time(force: Array, log: Log, nominal: Device) -> float:
    """Decay time at the reference temperature, s; NaN where no row allows an estimate."""
    change = log.temperature - nominal.reference_temperature
    chosen = log.is_driven & (np.abs(change) < TEMPERATURE_RANGE) & np.isfinite(force)
    if not chosen.any():
        return math.nan
    rates = force[chosen] * (1 + nominal.decay_time_per_kelvin * change[chosen])
    median = float(np.median(rates))
    return 1 / median if median else math.inf


def _estimate_from_ring_down(log: Log, nominal: Device) -> list[NominalEstimate]:
    """Estimate from the longest ring-down, if it is long enough.

    Energy decays with the decay time alone. A frequency split may hide up to half of the energy as
    quadrature, which widens the allowed range.
    """
    runs = find_runs(log.is_free)
    rows = slice(*max(runs, key=lambda run: run[1] - run[0], default=(0, 0)))
    amplitude = log.amplitude[rows]
    time = log.time[rows][np.isfinite(amplitude)]
    amplitude = amplitude[np.isfinite(amplitude)]
    if len(time) < 2 or time[-1] - time[0] < MIN_RING_DOWN or min(amplitude[[0, -1]]) <= 0:
        return []
    duration = float(time[-1] - time[0])
    decay = math.log(amplitude[0] / amplitude[-1]) / duration
    shortest, longest = _allowed_decay_times(nominal)
    shortest = 1 / (1 / shortest + math.log(2) / 2 / duration)
    estimate = 1 / decay if decay > 0 else math.inf
    values = (nominal.decay_time, estimate, shortest, longest)
    return [NominalEstimate("decay_time_s", "amplitude", log.source, *values)]
