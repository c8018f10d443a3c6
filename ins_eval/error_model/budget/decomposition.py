"""What the sensors actually did wrong, split into effects."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import Effect, Sensor
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import Motion, step_mean

Array = NDArray[np.float64]

REST = "noise and rest"
"""Name of what no effect explains."""


def sensor_error(measured: Increments, truth: Increments) -> Increments:
    """Measured less true.

    Raises:
        ValueError: increments of different times.
    """
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


def summed(increments: Increments, start: float, step: float, count: int) -> Increments:
    """Increments over longer intervals, as many as asked for.

    Raises:
        ValueError: steps that are no whole number of intervals, or that the increments don't span.
    """
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


@dataclass(frozen=True)
class Prior:
    """What is known of the sensors before: (e, 3) standard deviations of the effects'
    coefficients, SI, and the noise that they are seen in."""

    deviations: Array
    noise: SensorErrors

    def noise_of(self, sensor: Sensor, step: float) -> float:
        """Standard deviation of a step's sum, rad or m/s."""
        n = self.noise
        walk, instability, quantum = (
            (n.angle_random_walk, n.gyro_bias_instability, n.angle_quantum)
            if sensor == "gyro"
            else (n.velocity_random_walk, n.accelerometer_bias_instability, n.velocity_quantum)
        )
        return float(np.sqrt(walk**2 * step + (instability * step) ** 2 + quantum**2 / 6))


def decomposed(
    error: Increments, motion: Motion, effects: Sequence[Effect], prior: Prior | None = None
) -> dict[str, Increments]:
    """The error of the sensors, by family of effects, in the motion's steps.

    Each axis is fitted to the effects' signals along the motion. Without a prior by ordinary least
    squares; where signals are nearly alike, large parts cancel: a gyro whose pattern moves by a
    degree can't tell its bias from its map. With one to the likeliest coefficients, so that what
    signals have in common goes to those that it is expected of. The parts, `REST` among them, sum
    to the whole.

    Raises:
        ValueError: an error that doesn't span the motion.
    """
    whole = summed(error, motion.start, motion.step, len(motion))
    parts = {effect.family: np.zeros((len(motion), 2, AXES)) for effect in effects}
    rest = np.stack([whole.rotation, whole.velocity], axis=1)
    sensors: tuple[Sensor, Sensor] = ("gyro", "accelerometer")
    for place, sensor in enumerate(sensors):
        places = [i for i, effect in enumerate(effects) if effect.sensor == sensor]
        if not places:
            continue
        own = [effects[i] for i in places]
        signals = np.stack([motion.step * step_mean(e.regressor(motion)) for e in own], axis=-1)
        for axis in range(AXES):
            seen = signals[:, axis], rest[:, place, axis]
            if prior:
                noise = prior.noise_of(sensor, motion.step)
                fitted = signals[:, axis] * _likeliest(*seen, prior.deviations[places, axis], noise)
            else:
                fitted = signals[:, axis] * _least_squares(*seen)
            for effect, part in zip(own, fitted.T, strict=True):
                parts[effect.family][:, place, axis] += part
            rest[:, place, axis] -= fitted.sum(axis=1)
    parts[REST] = rest
    return {
        name: Increments(motion.step, part[:, 0], part[:, 1], motion.start)
        for name, part in parts.items()
    }


def _least_squares(signals: Array, values: Array) -> Array:
    size = np.linalg.norm(signals, axis=0)
    size = np.where(size > 0, size, 1.0)
    return np.asarray(np.linalg.lstsq(signals / size, values, rcond=1e-9)[0] / size)


def _likeliest(signals: Array, values: Array, deviations: Array, noise: float) -> Array:
    """Of normal coefficients seen in white noise, by least squares (Gelb 1974, section 4.3); noise
    too small to be told from rounding counts as that."""
    scaled = signals * deviations
    noise = max(noise, 1e-9 * float(np.max(np.abs(scaled))))
    if noise == 0:
        return np.zeros_like(deviations)
    system = np.concatenate([scaled / noise, np.eye(len(deviations))])
    target = np.concatenate([values / noise, np.zeros(len(deviations))])
    return np.asarray(np.linalg.lstsq(system, target)[0] * deviations)
