"""Error budgets of the final position error: of known sensor errors, and of their variances."""

from collections.abc import Mapping

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.budget.adjoint import BODY, COMPONENTS, SENSORS, Weights
from ins_eval.error_model.budget.decomposition import sum_over_steps
from ins_eval.error_model.effects import Effect
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.states import COUNT, NAMES
from pyhrg.records.imu.increments import Increments

Array = NDArray[np.float64]


def compute_budget(
    weights: Weights, signals: Mapping[str, Increments], initial: Array | None = None
) -> xr.Dataset:
    """Compute the contributions to the final position error, whose sum is the linear model's error.

    docs/methods/error_model.md, Eq. 12.

    Args:
        weights: of the model, which may include the alignment.
        signals: sensor errors (measured less true) by effect; whole intervals fill a model's step.
        initial: (10,) errors at the model's start; None is no error.

    Returns:
        `contribution` (effect, axis, time, component) and `initial` (state, component), m.

    Raises:
        ValueError: signals that do not cover the model's steps.
    """
    model = weights.model
    steps = {
        n: sum_over_steps(s, model.time[0], model.step, len(model)) for n, s in signals.items()
    }
    errors = np.stack([np.concatenate([s.rotation, s.velocity], axis=1) for s in steps.values()])
    contribution = np.einsum("nos,ens->esno", weights.sensors, errors)
    start = weights.states[0].T * (np.zeros(COUNT) if initial is None else initial)[:, None]
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


def sum_contributions(budget: xr.Dataset) -> Array:
    """Return the sum (2,) of all contributions: the final error north and east, m."""
    return np.asarray(
        budget.contribution.sum(("effect", "axis", "time")) + budget.initial.sum("state")
    )


def coefficient_sigmas(
    effects: tuple[Effect, ...], sensors: SensorErrors, more: Mapping[str, float] | None = None
) -> Array:
    """Return the standard deviations (e, 3) of the effects' coefficients, SI.

    Args:
        effects: of the model.
        sensors: gives those of biases and of bias instabilities.
        more: gives those of other effects, by name.

    Raises:
        ValueError: an effect without a standard deviation, or a name that is not an effect's.
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


def compute_variance_budget(
    weights: Weights, initial: Array, spreads: Array, noise: SensorErrors
) -> xr.Dataset:
    """Compute the contributions to the variance of the final error, m^2.

    docs/methods/error_model.md, Eq. 13.

    Args:
        weights: of a model.
        initial: (10, 10) covariance at the model's start.
        spreads: (e, 3) from `coefficient_sigmas`.
        noise: gives angle and velocity random walk.

    Returns:
        `variance` (effect, axis, component), with the random walks among the effects (their weight
        is taken as constant within a step), and `initial` (component).
    """
    step, states = weights.model.step, weights.states[0]
    walks = {
        "angle random walk": noise.angle_random_walk * weights.sensors[..., :AXES],
        "velocity random walk": noise.velocity_random_walk * weights.sensors[..., AXES:],
    }
    shares = list(_sum_step_variances(weights) * spreads[:, :, None] ** 2)
    shares += [step * np.sum(walk**2, axis=0).T for walk in walks.values()]
    square = {"units": "m^2"}
    return xr.Dataset(
        {
            "variance": (("effect", "axis", "component"), np.stack(shares), square),
            "initial": (("component",), np.einsum("oi,ij,oj->o", states, initial, states), square),
        },
        {
            "effect": [effect.name for effect in weights.model.effects] + list(walks),
            "axis": list(BODY),
            "component": list(COMPONENTS),
        },
    )


def _sum_step_variances(weights: Weights) -> Array:
    """Return the variance (e, 3, 2) per coefficient of variance 1, constant or Gauss-Markov."""
    by_step = np.moveaxis(weights.step_coefficients, 1, -1)
    persistence = weights.model.persistence[:, None, None]
    after, variance = np.zeros(by_step.shape[1:]), np.zeros(by_step.shape[1:])
    for own in by_step[::-1]:
        variance += own * (own + 2 * after)
        after = persistence * (own + after)
    return variance
