"""Weights of a map in an hour of steady turning in heading: the linear model on a turntable.

Only the map of bias and scale factor at power-on and the gyros' noise have weights here: not
warming, specific force, accelerometers or mounting.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.common import earth
from ins_eval.error_model.aligning import model_alignment
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.linear_model import AXES, linearize
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.error_model.states import COUNT
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import STEP
from ins_eval.mission_model.missions import SETTLING, STILL
from ins_eval.mission_model.noise_weights import compute_error_weights, compute_noise_covariances
from ins_eval.mission_model.signals import list_signal_effects
from ins_eval.navigation.height import Clamped
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, HOUR

LATITUDE = 40 * DEG
"""Latitude of the turntable, rad. Chosen: about that of the ready car."""
DURATION = HOUR
"""Time of navigation, s. Chosen."""


@dataclass(frozen=True)
class TurningWeights:
    """Position error at the end per unit of each gyro error.

    maps: (1, 2, 2 TERMS, 3) m per coefficient of a map that starts at angle 0, as
    `MissionWeights.gyros`; noise: (KINDS, 3, 2, 2) covariance, m^2, per squared unit of each kind
    of each gyro's noise.
    """

    maps: Array
    noise: Array


def compute_turning_weights(pattern_rate: float) -> TurningWeights:
    """Weights of `DURATION` of navigation in which the pattern of the vertical gyro turns at a
    rate, rad/s, after an alignment at rest."""
    effects = list_signal_effects()[: 2 * TERMS]
    aligning = model_alignment(_turn(0.0, SETTLING - STILL, 0.0), effects)
    turning = _turn(pattern_rate / ANGULAR_GAIN, 0.0, DURATION)
    flying = linearize(turning, Clamped(np.zeros(1)), effects)
    carried = np.zeros((COUNT, len(effects) * AXES))
    for model in (aligning, flying):
        inputs = model.inputs.reshape(len(model), COUNT, -1)
        for transition, given in zip(model.transition, inputs, strict=True):
            carried = transition @ carried + given
    transition = np.concatenate([aligning.transition, flying.transition])
    per_rate = np.concatenate([m.constant_errors[:, :, :AXES] for m in (aligning, flying)])
    by_rate = compute_error_weights(transition, per_rate, np.array([len(transition)]))
    return TurningWeights(
        maps=carried[:2].reshape(1, 2, len(effects), AXES),
        noise=compute_noise_covariances(by_rate, STEP, round(SETTLING / STEP)),
    )


def _turn(rate: float, start: float, end: float) -> Motion:
    """On a table that turns about the vertical at a rate, rad/s, from heading 0. Since power-on at
    -`STILL` the case has turned with the Earth."""
    count = round((end - start) / STEP)
    time = start + STEP / PARTS * np.arange(PARTS * count + 1.0)
    elapsed, zero = time - start, np.zeros_like(time)
    latitude = np.full_like(time, LATITUDE)
    cos, sin = np.cos(rate * elapsed), np.sin(rate * elapsed)
    mat_nb = np.zeros((len(time), AXES, AXES))
    mat_nb[:, 0, 0], mat_nb[:, 0, 1], mat_nb[:, 1, 0], mat_nb[:, 1, 1] = cos, -sin, sin, cos
    mat_nb[:, 2, 2] = 1.0
    rates = np.einsum("mji,mj->mi", mat_nb, earth.rotation_rate(latitude))
    rates[:, 2] += rate
    before = (start + STILL) * earth.rotation_rate(latitude[:1])
    mean = (rates[1:] + rates[:-1]) / 2 * STEP / PARTS
    return Motion(
        step=STEP,
        start=start,
        latitude=latitude,
        height=zero,
        velocity=np.zeros((len(time), AXES)),
        mat_nb=mat_nb,
        rate=rates,
        force=np.stack([zero, zero, -earth.gravity(latitude, zero)], axis=-1),
        turned=np.cumsum(np.concatenate([before, mean]), axis=0),
    )
