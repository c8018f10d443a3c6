"""The linear error model along a motion in discrete steps, and its mean and covariance.

A static alignment is a model too, joined before that of the navigation
(docs/methods/error_model.md, Eq. 10). It takes pitch and roll from the mean specific force and
heading from the mean rate (`alignment.analytic`), so that the sensors' errors at each time
contribute to the attitude error. The final error then includes the sensors' errors during
alignment, and a bias that alignment compensates has no effect until the vehicle turns.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import bias_sensitivity
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.discretisation import discretize, transitions_to_step_end
from ins_eval.error_model.dynamics import ATTITUDE, COUNT, dynamics, free_states, sensor_inputs
from ins_eval.error_model.effects import BIASES, Effect
from ins_eval.error_model.motion import BOOLE, PARTS, Motion, step_mean
from ins_eval.navigation.height import Height
from pyhrg.common.arrays import Array

AXES = 3


@dataclass(frozen=True)
class LinearModel:
    """Steps x[k+1] = transition[k] x[k] + inputs[k] c + noise of covariance `noise_covariance[k]`.

    Attributes:
        time: (n + 1,) bounds of the steps, s.
        transition: (n, 10, 10).
        inputs: (n, 10, e, 3) per coefficient of each effect and axis.
        constant_errors: (n, 10, 6) per error of each gyro, rad/s, and accelerometer, m/s^2, that is
            constant over the step.
        noise_covariance: (n, 10, 10).
    """

    time: Array
    effects: tuple[Effect, ...]
    transition: Array
    inputs: Array
    constant_errors: Array
    noise_covariance: Array

    def __len__(self) -> int:
        return len(self.transition)

    @property
    def step(self) -> float:
        """Duration of a step, s."""
        return float(self.time[1] - self.time[0])

    @property
    def persistence(self) -> Array:
        """(e,) correlation of each coefficient from one step to the next; 1 for constants."""
        times = np.array([effect.correlation_time for effect in self.effects])
        return np.exp(-self.step / times)


def linearize(
    motion: Motion,
    height: Height,
    effects: Sequence[Effect] = BIASES,
    noise: SensorErrors | None = None,
) -> LinearModel:
    """Linearize the navigator along a motion; the angle and velocity random walks of `noise` drive
    the model (docs/methods/error_model.md, Eqs. 2 to 8)."""
    model = assemble_model(
        motion, dynamics(motion, height), sensor_inputs(motion, height), effects, noise
    )
    return replace(model, transition=model.transition * free_states(height)[:, None])


def assemble_model(
    motion: Motion,
    f: Array,
    g: Array,
    effects: Sequence[Effect],
    noise: SensorErrors | None,
) -> LinearModel:
    """Assemble a model from dynamics f (n, 10, 10) of the steps and inputs g (m, 10, 6) at nodes.

    Transition and noise covariance are exact for the step's mean dynamics and noise density (Van
    Loan 1978). The rotation of the sensors within a step is integrated by Boole's rule.
    """
    transition, covariance = discretize(
        f, step_mean(_density(g, noise or SensorErrors())), motion.step
    )
    regressors, columns = _signals(effects, motion)
    inputs = np.zeros((len(f), COUNT, len(effects), AXES))
    constant = np.zeros((len(f), COUNT, 2 * AXES))
    for back, to_end in enumerate(transitions_to_step_end(f, motion.step, PARTS)):
        node = slice(PARTS - back, len(g) - back, PARTS)
        carried = motion.step * BOOLE[back] * (to_end @ g[node])
        inputs += carried[:, :, columns] * regressors[node, None]
        constant += carried
    return LinearModel(motion.time, tuple(effects), transition, inputs, constant, covariance)


def join_models(first: LinearModel, then: LinearModel) -> LinearModel:
    """Join two models with the same effects into one, first one and then the other."""
    gap = then.time[0] - first.time[-1]
    if abs(gap) > 1e-6 or abs(first.step - then.step) > 1e-9 * then.step:
        raise ValueError(
            f"models up to {first.time[-1]} s with steps of {first.step} s and from "
            f"{then.time[0]} s with steps of {then.step} s: expected the same moment and step"
        )
    names = [[effect.name for effect in model.effects] for model in (first, then)]
    if names[0] != names[1]:
        raise ValueError(f"models of the effects {names[0]} and {names[1]}: expected the same")
    return LinearModel(
        np.concatenate([first.time, then.time[1:]]),
        then.effects,
        np.concatenate([first.transition, then.transition]),
        np.concatenate([first.inputs, then.inputs]),
        np.concatenate([first.constant_errors, then.constant_errors]),
        np.concatenate([first.noise_covariance, then.noise_covariance]),
    )


def propagate_covariance(model: LinearModel, initial: Array, sigmas: Array) -> Array:
    """Return the covariance of the errors over time, (n + 1, 10, 10).

    docs/methods/error_model.md, Eq. 9, from the `initial` one (10, 10) and the standard deviations
    `sigmas` (e, 3) of the coefficients, which are the same at all times.
    """
    variance = np.ravel(sigmas) ** 2
    persistence = np.repeat(model.persistence, AXES)
    p, cross = np.array(initial, dtype=float), np.zeros((COUNT, len(variance)))
    inputs = model.inputs.reshape(len(model), COUNT, -1)
    every = [p]
    for k, phi in enumerate(model.transition):
        carried = phi @ cross
        both = carried @ inputs[k].T
        p = phi @ p @ phi.T + both + both.T + (inputs[k] * variance) @ inputs[k].T
        p = p + model.noise_covariance[k]
        cross = (carried + inputs[k] * variance) * persistence
        every.append(p)
    return np.stack(every)


def _signals(effects: Sequence[Effect], motion: Motion) -> tuple[Array, NDArray[np.intp]]:
    """Return regressors (m, e, 3) at the nodes, and the sensor of each (e, 3), 0 to 5."""
    regressors = np.empty((len(motion.mat_nb), len(effects), AXES))
    sensors = np.empty((len(effects), AXES), dtype=np.intp)
    for number, effect in enumerate(effects):
        regressors[:, number] = effect.regressor(motion)
        sensors[number] = np.arange(AXES) + (AXES if effect.sensor == "accelerometer" else 0)
    return regressors, sensors


def _density(g: Array, noise: SensorErrors) -> Array:
    """Return the density (m, 10, 10) of the white noise on the states at the nodes."""
    walks = np.repeat([noise.angle_random_walk, noise.velocity_random_walk], AXES)
    return np.einsum("nij,j,nkj->nik", g, walks**2, g)


def model_alignment(
    still: Motion, effects: Sequence[Effect] = BIASES, noise: SensorErrors | None = None
) -> LinearModel:
    """Model the alignment over a motion at rest.

    The attitude error is 0 at the beginning and that of the alignment at the end. Position and
    velocity errors stay as they are.
    """
    duration = still.step * len(still)
    g = np.zeros((len(still.mat_nb), COUNT, 6))
    gravity = earth.gravity(still.latitude, still.height)
    sensitivity = bias_sensitivity(still.latitude, gravity)
    g[:, ATTITUDE, :3] = sensitivity[..., :3] @ still.mat_nb / duration
    g[:, ATTITUDE, 3:] = sensitivity[..., 3:] @ still.mat_nb / duration
    return assemble_model(still, np.zeros((len(still), COUNT, COUNT)), g, effects, noise)
