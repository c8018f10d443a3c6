"""How far each coefficient of a gyro's map carries the position in a mission: once for all devices.

With the pattern angle th = th0 - k Psi(t), Psi the true turn about the axis, the map's harmonics
are known signals along the mission; the linear error model, alignment included, makes of each its
error over time. What any device does is then a sum (`flights`).
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.aligning import alignment_model
from ins_eval.error_model.effects import (
    Effect,
    accelerometer_bias,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    pick_off_map,
)
from ins_eval.error_model.linear_model import AXES, LinearModel, joined, linear_model
from ins_eval.error_model.motion import Motion, along
from ins_eval.error_model.states import COUNT
from ins_eval.navigation.height import Clamped
from ins_eval.study.gyro_map import HARMONICS, TERMS
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

STEP = 1.0
"""Of the linear model, s."""
KEPT = 600.0
"""Between the times that errors are told at, s."""


@dataclass(frozen=True)
class MissionWeights:
    """name; time: (k,) s since alignment;
    gyros: (k, 2, 2 TERMS, 3) error north and east, m, per coefficient of `GyroMap`, started at
    pattern angle 0, of the gyro along each body axis;
    warming: the same for coefficients that grow as the gyro warms: times `warmth`;
    accelerometers: (k, 2, 3) m per m/s^2 of bias;
    transition: (n, 10, 10) and per_rate: (n, 10, 3): the linear model's steps of STEP seconds,
    alignment included, and what a gyro's mean rate error over one adds (per rad/s), for noise;
    kept: (k,) steps after which errors are told.
    """

    name: str
    time: Array
    gyros: Array
    warming: Array
    accelerometers: Array
    transition: Array
    per_rate: Array
    kept: NDArray[np.int64]


def mission_weights(
    trajectory: Trajectory, hours: float, still: float, settling: float, warm_up: float
) -> MissionWeights:
    """Weights of a mission.

    Args:
        trajectory: stands still from -`still` to 0.
        hours: of navigation.
        still: from power-on to the alignment's end, s.
        settling: from power-on to the alignment's beginning, s.
        warm_up: time constant of `warmth`, s.
    """
    model = _model(trajectory, round(hours * 3600 / STEP), still, settling, warm_up)
    aligning = round((still - settling) / STEP)
    kept = np.arange(aligning, len(model) + 1, round(KEPT / STEP))[1:]
    carried = _carried(model, kept)
    gyros, accelerometers = carried[:, :, :-1], carried[:, :, -1]
    half = gyros.shape[2] // 2
    return MissionWeights(
        name=trajectory.name,
        time=KEPT * np.arange(1.0, len(kept) + 1),
        gyros=gyros[:, :, :half],
        warming=gyros[:, :, half:],
        accelerometers=accelerometers,
        transition=model.transition,
        per_rate=model.constant_errors[:, :, :AXES],
        kept=kept,
    )


def warmth(time: Array, still: float, warm_up: float) -> Array:
    """How far a gyro has warmed since power-on, 0 to 1."""
    return np.asarray(1 - np.exp(-(time + still) / warm_up))


def _model(
    trajectory: Trajectory, steps: int, still: float, settling: float, warm_up: float
) -> LinearModel:
    start = settling - still
    from_power_on = trajectory.increments(-still, STEP, round(settling / STEP)).rotation.sum(axis=0)
    standing = _turned(along(trajectory, start, STEP, round(-start / STEP)), from_power_on)
    flying = _turned(along(trajectory, 0.0, STEP, steps), standing.turned[-1])
    effects = _effects(still, warm_up)
    held = linear_model(flying, Clamped(np.zeros(1)), effects)
    return joined(alignment_model(standing, effects), held)


def _turned(motion: Motion, before: Array) -> Motion:
    return replace(motion, turned=motion.turned + before)


def _effects(still: float, warm_up: float) -> list[Effect]:
    """Those of `GyroMap`, in its order; those again, growing with warmth; accelerometers."""
    zero = np.zeros(AXES)
    constant = [gyro_bias(), *(e for h in HARMONICS for e in bias_map(h, zero))]
    constant += [gyro_scale_factor(), *(e for h in HARMONICS for e in pick_off_map(h, zero))]
    assert len(constant) == 2 * TERMS
    growing = [_growing(effect, still, warm_up) for effect in constant]
    return [*constant, *growing, accelerometer_bias()]


def _growing(effect: Effect, still: float, warm_up: float) -> Effect:
    def regressor(motion: Motion) -> Array:
        nodes = len(motion.rate)
        time = np.linspace(motion.start, motion.start + motion.step * len(motion), nodes)
        return np.asarray(effect.regressor(motion) * warmth(time, still, warm_up)[:, None])

    return replace(effect, name=f"{effect.name}, warming", regressor=regressor)


def _carried(model: LinearModel, kept: NDArray[np.int64]) -> Array:
    """(k, 2, e, 3) error north and east per constant coefficient, after the kept steps."""
    inputs = model.inputs.reshape(len(model), COUNT, -1)
    carried, told = np.zeros(inputs.shape[1:]), []
    for k, transition in enumerate(model.transition):
        carried = transition @ carried + inputs[k]
        if k + 1 in kept:
            told.append(carried[:2].copy())
    return np.stack(told).reshape(len(kept), 2, -1, AXES)
