"""Whose the final error is: by effect, axis and time; as it happened, or as it may be expected."""

from collections.abc import Mapping

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.budget.adjoint import BODY, COMPONENTS, SENSORS, Weights
from ins_eval.error_model.budget.decomposition import summed
from ins_eval.error_model.effects import Effect
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.states import COUNT, NAMES

Array = NDArray[np.float64]


def budget(
    found: Weights, signals: Mapping[str, Increments], initial: Array | None = None
) -> xr.Dataset:
    """Contributions to the final error north and east, which sum to the linear model's.

    Args:
        found: weights of the model, alignment included where it was joined.
        signals: errors (measured less true) by effect; intervals that fill the model's steps.
        initial: (10,) errors at the model's start; none unless given.

    Returns:
        `contribution` (effect, axis, time, component) and `initial` (state, component), m.

    Raises:
        ValueError: signals that don't span the model's steps.
    """
    model = found.model
    steps = {n: summed(s, model.time[0], model.step, len(model)) for n, s in signals.items()}
    errors = np.stack([np.concatenate([s.rotation, s.velocity], axis=1) for s in steps.values()])
    contribution = np.einsum("nos,ens->esno", found.sensors, errors)
    start = found.states[0].T * (np.zeros(COUNT) if initial is None else initial)[:, None]
    metres = {"units": "m"}
    return xr.Dataset(
        {
            "contribution": (("effect", "axis", "time", "component"), contribution, metres),
            "initial": (("state", "component"), start, metres),
        },
        {
            "effect": list(signals),
            "axis": list(SENSORS),
            "time": ("time", model.time[1:], {"units": "s", "long_name": "end of the step"}),
            "component": list(COMPONENTS),
            "state": list(NAMES),
        },
    )


def total(found: xr.Dataset) -> Array:
    """(2,) final error north and east, m, that a budget's contributions sum to."""
    return np.asarray(
        found.contribution.sum(("effect", "axis", "time")) + found.initial.sum("state")
    )


def sigmas(
    effects: tuple[Effect, ...], sensors: SensorErrors, more: Mapping[str, float] | None = None
) -> Array:
    """(e, 3) standard deviations of the effects' coefficients: biases and their instabilities
    from `sensors`, others by name; SI.

    Raises:
        ValueError: an effect without a standard deviation, or one that isn't among the effects.
    """
    known = {
        "gyro bias": sensors.gyro_bias,
        "gyro bias instability": sensors.gyro_bias_instability,
        "accelerometer bias": sensors.accelerometer_bias,
        "accelerometer bias instability": sensors.accelerometer_bias_instability,
    }
    names = [effect.name for effect in effects]
    given = {**known, **(more or {})}
    wrong = [name for name in names if name not in given]
    wrong += [name for name in more or {} if name not in names]
    if wrong:
        raise ValueError(f"standard deviation of {wrong[0]!r}: expected one for each of {names}")
    return np.repeat([[given[name]] for name in names], AXES, axis=1)


def variance_budget(
    found: Weights, initial: Array, spreads: Array, noise: SensorErrors
) -> xr.Dataset:
    """Shares in the variance of the final error north and east, m^2.

    Args:
        found: weights of a model.
        initial: (10, 10) covariance at the model's start.
        spreads: (e, 3) from `sigmas`.
        noise: angle and velocity random walks.

    Returns:
        `variance` (effect, axis, component), white noise among the effects, which leaves out how
        the weight changes within a step; and `initial` (component).
    """
    step, states = found.model.step, found.states[0]
    walks = {
        "angle random walk": noise.angle_random_walk * found.sensors[..., :AXES],
        "velocity random walk": noise.velocity_random_walk * found.sensors[..., AXES:],
    }
    shares = list(_by_coefficients(found) * spreads[:, :, None] ** 2)
    shares += [step * np.sum(walk**2, axis=0).T for walk in walks.values()]
    square = {"units": "m^2"}
    return xr.Dataset(
        {
            "variance": (("effect", "axis", "component"), np.stack(shares), square),
            "initial": (("component",), np.einsum("oi,ij,oj->o", states, initial, states), square),
        },
        {
            "effect": [effect.name for effect in found.model.effects] + list(walks),
            "axis": list(BODY),
            "component": list(COMPONENTS),
        },
    )


def _by_coefficients(found: Weights) -> Array:
    """(e, 3, 2) variance per coefficient of variance 1, constant or wandering."""
    by_step = np.moveaxis(found.step_coefficients, 1, -1)
    stays = found.model.persistence[:, None, None]
    after, variance = np.zeros(by_step.shape[1:]), np.zeros(by_step.shape[1:])
    for own in by_step[::-1]:
        variance += own * (own + 2 * after)
        after = stays * (own + after)
    return variance
