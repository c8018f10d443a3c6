"""Maps that are estimated from a gyro's channels: as the position error that they make, and as a
correction.

Coefficients are those of `mission_model.signals`, over the pattern angle itself.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.mission_model.gyro_map import (
    HARMONICS,
    TERMS,
    evaluate_terms,
    start_maps,
    turn_weights,
)
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.mission_model.signals import (
    COUNT,
    compute_case_warming_rate,
    compute_resonator_warmth,
    slice_coefficients,
)
from ins_eval.study.predictors.prediction import NormalPrediction
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import POWERS
from pyhrg.witness.mechanisms import COUNT as MECHANISMS
from pyhrg.witness.mechanisms import (
    FOLLOWED,
    SIGNALS,
    STEADY,
    TEMPERATURE_RATE,
    change_device,
    read_values,
)
from pyhrg.witness.responses import Responses, measure_channels

OUTPUT, MAPS = 2, slice(0, 2)
"""Place of the output among the channels, and of bias and scale-factor error among its motions."""
ESTIMATED = POWERS + len(SIGNALS) - 1
"""Number of the mission's signals to which the response is known: powers of the warmth, then those
of `mechanisms.SIGNALS`."""


@dataclass(frozen=True)
class EstimatedMap:
    """Distribution of a gyro's coefficients in flight: (COUNT,) mean and (COUNT, COUNT)
    covariance."""

    mean: Array
    covariance: Array


def compute_estimated_map(
    fmu: GyroFmu,
    device: Device,
    changes: Array,
    covariance: Array,
    responses: Responses,
    rise: float,
) -> EstimatedMap:
    """The maps of a device with changes (MECHANISMS,) of a covariance.

    What they do under fast turning is taken for zero.

    fmu: `HRGSlow`; responses: of the changed device; rise: final rise of its temperature, K.
    """
    changed = change_device(device, changes)
    (channels,) = measure_channels(fmu, [changed])
    response = respond(responses, rise)
    values = np.where(TEMPERATURE_RATE, changes, read_values(changed))
    mean = response[:, ~STEADY] @ values[~STEADY]
    maps = channels[OUTPUT, :, MAPS].reshape(POWERS, -1) * _warm(rise)[:, None]
    mean[: maps.size] = maps.ravel()
    return EstimatedMap(mean, response @ covariance @ response.T)


def respond(responses: Responses, rise: float) -> Array:
    """(COUNT, MECHANISMS) coefficients per unit of each mechanism, of a gyro that warms by a rise,
    K."""
    maps = responses.output[:, :, MAPS].reshape(MECHANISMS, POWERS, -1) * _warm(rise)[:, None]
    response = np.zeros((COUNT, MECHANISMS))
    steady = maps.reshape(MECHANISMS, -1).T
    response[: len(steady)] = np.where(STEADY, steady, 0.0)
    # the mission's heating is a share of the rise
    for place, size in enumerate((rise, 1.0, 1.0)):
        follows = slice_coefficients(slice(POWERS + place, POWERS + place + 1))
        response[follows] = np.where(place + 1 == FOLLOWED, size * maps[:, 0].T, 0.0)
    return response


def _warm(rise: float) -> Array:
    """(POWERS,) powers of the temperature per power of the warmth."""
    return np.asarray(rise ** np.arange(POWERS))


def predict_error(
    weights: MissionWeights, estimated: Sequence[EstimatedMap], start_angle: Array, other: Array
) -> NormalPrediction:
    """Position error of one triad by its maps.

    weights: at k times; start_angle: (3,) of the patterns at power-on, rad; other: (1, k, 2, 2)
    covariance by noise, accelerometers and mounting, m^2.
    """
    maps = np.stack([each.mean for each in estimated], axis=-1)
    carried = turn_weights(weights.maps, start_angle)
    covariance = other.copy()
    for axis, each in enumerate(estimated):
        part = carried[..., axis]
        covariance[0] += np.einsum("kic,cd,kjd->kij", part, each.covariance, part)
    expected = compute_expected_error(weights, start_maps(maps, start_angle)[None])
    return NormalPrediction(expected, covariance)


def compute_angle_errors(
    estimated: EstimatedMap, pattern: Array, time: Array, rotation: Array, force: Array
) -> Array:
    """(n,) errors of a gyro's increments, rad, by its maps.

    pattern: (n + 1,) detected pattern angles at the bounds of the increments, rad; time: (n + 1,)
    since the alignment, s; rotation: (n,) increments of the gyro, rad; force: (n, 3) specific force
    along the axes of its case, m/s^2.
    """
    x, _, z = np.concatenate([force[:1], 0.5 * (force[1:] + force[:-1]), force[-1:]]).T
    warmth, interval = compute_resonator_warmth(time), np.diff(time)
    signals = np.stack(
        [*(warmth**power for power in range(POWERS)), compute_case_warming_rate(time), x, z]
    )
    maps = estimated.mean[slice_coefficients(slice(0, ESTIMATED))].reshape(ESTIMATED, 2, TERMS)
    bias, scale = (np.einsum("sn,st->nt", signals, maps[:, kind]) for kind in (0, 1))
    rate = np.einsum("nt,nt->n", evaluate_terms(pattern), bias)
    detected = np.einsum("nt,nt->n", _evaluate_angle_errors(pattern), scale[:, 1:])
    return np.asarray(interval * _halve(rate) + rotation * _halve(scale[:, 0]) + np.diff(detected))


def _evaluate_angle_errors(pattern: Array) -> Array:
    """(n, TERMS - 1) errors of the detected angle as an input angle, rad, per harmonic of the
    scale factor (mission_model.md, Eq. 4)."""
    waves = [
        wave
        for h in HARMONICS
        for wave in (
            -np.sin(h * pattern) / (h * ANGULAR_GAIN),
            np.cos(h * pattern) / (h * ANGULAR_GAIN),
        )
    ]
    return np.stack(waves, axis=-1)


def _halve(values: Array) -> Array:
    """Means of neighbours."""
    return 0.5 * (values[1:] + values[:-1])
