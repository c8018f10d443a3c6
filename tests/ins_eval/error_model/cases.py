"""Flights that the linear model is held to."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.spatial.transform import Rotation

from ins_eval.common import earth
from ins_eval.common.state import State, track_error
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.error_budget import Weights
from ins_eval.error_model.linear_model import LinearModel
from ins_eval.navigation.height import Clamped, Height
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.records.imu.log import Increments

EVERY = 60.0
"""Time between rows that are compared, s."""


def propagate(model: LinearModel, initial: np.ndarray, coefficients: np.ndarray) -> np.ndarray:
    """Return the errors (n + 1, 10) that constant coefficients (e, 3) and initial errors (10,)
    cause."""
    drive = np.tensordot(model.inputs, coefficients, axes=2)
    x = np.empty((len(model) + 1, COUNT))
    x[0] = initial
    for k, phi in enumerate(model.transition):
        x[k + 1] = phi @ x[k] + drive[k]
    return x


def sum_coefficient_weights(weights: Weights) -> np.ndarray:
    """Weights (2, e, 3) of constant coefficients of each effect and axis in the final position."""
    return np.einsum("nij,njea->iea", weights.states[1:], weights.model.inputs)


def weave(latitude_deg: float, duration: float, roll_every: float = 1e9) -> Trajectory:
    """An aircraft at 250 m/s, heading 20 deg x sin(2 pi t / 60 s), banked; if asked for, with a
    full roll, 10 s long, once in a while."""
    t = np.arange(-10.0, duration + 30.0, 0.25)
    phase = 2 * np.pi * t / 60
    heading = np.deg2rad(20) * np.sin(phase)
    bank = np.arctan(250 / 9.81 * np.deg2rad(20) * 2 * np.pi / 60 * np.cos(phase))
    latitude = np.deg2rad(latitude_deg)
    latitude = latitude + cumulative_trapezoid(250 * np.cos(heading), t, initial=0) / 6.37e6
    east = 250 * np.sin(heading) / np.cos(latitude)
    longitude = cumulative_trapezoid(east, t, initial=0) / 6.38e6
    roll = np.zeros_like(t)
    for start in np.arange(0.5 * roll_every, duration, roll_every):
        s = np.clip((t - start) / 10, 0, 1)
        roll += 2 * np.pi * s**3 * (10 - 15 * s + 6 * s**2)
    pitch = np.full_like(t, 0.03)
    height = 5000 + 500 * np.sin(2 * np.pi * t / 900)
    channels = [latitude, longitude, height, bank + roll, pitch, heading]
    return Trajectory("weave", t, np.stack(channels, axis=-1))


@dataclass(frozen=True)
class Flight:
    """A trajectory, and the navigator on it with errors."""

    trajectory: Trajectory
    truth: Increments

    @classmethod
    def of(cls, trajectory: Trajectory, duration: float, interval: float = 0.02) -> "Flight":
        count = round(duration / interval)
        return cls(trajectory, trajectory.increments(0.0, interval, count))

    @property
    def heights(self) -> np.ndarray:
        return self.trajectory.position(self.truth.bounds)[:, 2]

    def flown(self, height: Height, start: np.ndarray, sensors: np.ndarray) -> np.ndarray:
        """(m, 9) errors of the navigator, its own included.

        Args:
            height: what holds the height; start: (9,) initial errors; sensors: (n or 1, 6) errors
                of gyros, rad/s, and accelerometers, m/s^2.
        """
        interval = self.truth.interval
        measured = replace(
            self.truth,
            rotation=self.truth.rotation + sensors[:, :3] * interval,
            velocity=self.truth.velocity + sensors[:, 3:] * interval,
        )
        state = _displaced(self.trajectory.state(0.0), start)
        track = navigate(state, measured, height, round(EVERY / interval))
        error = track_error(track, self.trajectory.track(track.time))
        return np.concatenate([error.position, error.velocity, error.attitude], axis=1)

    def errors(self, height: Height, start: np.ndarray, sensors: np.ndarray) -> np.ndarray:
        """`flown` less the navigator's own; a clamped height without error."""
        own = replace(height, heights=self.heights) if isinstance(height, Clamped) else height
        return self.flown(height, start, sensors) - self.flown(own, np.zeros(9), np.zeros((1, 6)))


def _displaced(state: State, error: np.ndarray) -> State:
    north = earth.meridian_radius(state.latitude) + state.height
    east = earth.transverse_radius(state.latitude) + state.height
    return State(
        state.latitude + error[0] / north,
        state.longitude + error[1] / east / np.cos(state.latitude),
        state.height - error[2],
        state.velocity + error[3:6],
        Rotation.from_rotvec(error[6:9]).as_matrix() @ state.mat_nb,
    )
