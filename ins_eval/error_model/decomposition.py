"""Decomposition of known sensor errors into effects."""

from collections.abc import Sequence

import numpy as np

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import Effect, Sensor
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import Motion, step_mean
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

UNEXPLAINED = "noise and rest"
"""Name of the residual that no effect explains."""


def sensor_error(measured: Increments, truth: Increments) -> Increments:
    """Return measured less true increments."""
    same = len(measured) == len(truth) and np.isclose(measured.interval, truth.interval)
    if not same or abs(measured.start - truth.start) > 1e-6:
        raise ValueError(
            f"measured: {len(measured)} x {measured.interval} s from {measured.start} s; true: "
            f"{len(truth)} x {truth.interval} s from {truth.start} s: expected the same"
        )
    return Increments(
        truth.interval,
        measured.rotation - truth.rotation,
        measured.velocity - truth.velocity,
        truth.start,
    )


def sum_over_steps(increments: Increments, start: float, step: float, count: int) -> Increments:
    """Sum increments over `count` steps of `step` seconds from time `start`."""
    each = round(step / increments.interval)
    first = round((start - increments.start) / increments.interval)
    off = start - increments.start - first * increments.interval
    if each < 1 or abs(each * increments.interval - step) > 1e-9 * step or abs(off) > 1e-6:
        raise ValueError(
            f"steps of {step} s from {start} s: expected whole intervals of "
            f"{increments.interval} s from {increments.start} s"
        )
    if first < 0 or first + each * count > len(increments):
        raise ValueError(
            f"increments span {increments.start} to {increments.bounds[-1]} s: "
            f"expected {start} to {start + count * step} s"
        )
    part = increments.between(first, first + each * count)
    rotation = part.rotation.reshape(count, each, 3).sum(axis=1)
    velocity = part.velocity.reshape(count, each, 3).sum(axis=1)
    return Increments(step, rotation, velocity, start)


def size_step_noise(noise: SensorErrors, sensor: Sensor, step: float) -> float:
    """Return the noise's standard deviation of a step's increment, rad or m/s."""
    if sensor == "gyro":
        walk, instability = noise.angle_random_walk, noise.gyro_bias_instability
        count = noise.angle_quantization_step
    else:
        walk, instability = noise.velocity_random_walk, noise.accelerometer_bias_instability
        count = noise.velocity_quantization_step
    return float(np.sqrt(walk**2 * step + (instability * step) ** 2 + count**2 / 6))


def decompose_errors(
    error: Increments,
    motion: Motion,
    effects: Sequence[Effect],
    deviations: Array,
    noise: SensorErrors,
) -> dict[str, Increments]:
    """Decompose the sensors' error into families of effects, in the motion's steps.

    For each axis, coefficients of the effects' signals along the motion are the maximum a
    posteriori estimate (docs/methods/error_model.md, Eq. 14) under their standard deviations (e,
    3), SI, and the superposed noise. Without a prior, large parts would cancel where signals are
    nearly collinear: a gyro whose pattern moves by one degree does not separate its bias from its
    map. The parts, with the residual `UNEXPLAINED`, sum to the error.
    """
    total = sum_over_steps(error, motion.start, motion.step, len(motion))
    parts = {effect.family: np.zeros((len(motion), 2, AXES)) for effect in effects}
    residual = np.stack([total.rotation, total.velocity], axis=1)
    sensors: tuple[Sensor, Sensor] = ("gyro", "accelerometer")
    for place, sensor in enumerate(sensors):
        places = [i for i, effect in enumerate(effects) if effect.sensor == sensor]
        if not places:
            continue
        own = [effects[i] for i in places]
        signals = np.stack([motion.step * step_mean(e.regressor(motion)) for e in own], axis=-1)
        size = size_step_noise(noise, sensor, motion.step)
        for axis in range(AXES):
            fitted = signals[:, axis] * _estimate_with_prior(
                signals[:, axis], residual[:, place, axis], deviations[places, axis], size
            )
            for effect, part in zip(own, fitted.T, strict=True):
                parts[effect.family][:, place, axis] += part
            residual[:, place, axis] -= fitted.sum(axis=1)
    parts[UNEXPLAINED] = residual
    return {
        name: Increments(motion.step, part[:, 0], part[:, 1], motion.start)
        for name, part in parts.items()
    }


def _estimate_with_prior(signals: Array, values: Array, deviations: Array, noise: float) -> Array:
    """Return the maximum a posteriori coefficients (Gelb 1974, section 4.3).

    The noise is at least 1e-9 of the largest scaled signal, which is the size of rounding.
    """
    scaled = signals * deviations
    noise = max(noise, 1e-9 * float(np.max(np.abs(scaled))))
    if noise == 0:
        return np.zeros_like(deviations)
    system = np.concatenate([scaled / noise, np.eye(len(deviations))])
    target = np.concatenate([values / noise, np.zeros(len(deviations))])
    return np.asarray(np.linalg.lstsq(system, target)[0] * deviations)
