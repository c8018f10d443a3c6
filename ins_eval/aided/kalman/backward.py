"""Smoother: backward through what a filter has kept (docs/methods/aided.md, Eqs. 9 to 11).

It is that of Bryson and Frazier in Bierman's form, which inverts no covariance: constants known to
1e-6 of their prior make those of the Rauch-Tung-Striebel form singular.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.aided.kalman.forward import Filtered, Step, correct_state
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.common.state import Track
from ins_eval.error_model.dynamics import COUNT
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class Smoothed:
    """track: at the ends of the segments; covariance: (m, 10, 10) of its errors."""

    track: Track
    covariance: Array


class Adjoint:
    """Gradient (n,) and information (n, n) of all later fixes."""

    def __init__(self, count: int, persistence: Array) -> None:
        self.gradient = np.zeros(count)
        self.information = np.zeros((count, count))
        self._persistence = persistence
        self._product = np.outer(persistence, persistence)

    def go_back(self, step: Step) -> None:
        """From after the updates at the end of a step to its beginning."""
        for update in reversed(step.updates):
            h, gain, own = update.sensitivity, update.gain, self.information
            weighted = update.inverse @ update.innovation
            self.gradient[:COUNT] -= h.T @ (weighted + gain.T @ self.gradient)
            crossed = own @ gain
            own[:, :COUNT] -= crossed @ h
            own[:COUNT] -= h.T @ crossed.T
            own[:COUNT, :COUNT] += h.T @ (gain.T @ crossed + update.inverse) @ h
        phi, inputs, rho = step.transition, step.inputs, self._persistence
        g, own = self.gradient, self.information
        g[COUNT:] = inputs.T @ g[:COUNT] + rho * g[COUNT:]
        g[:COUNT] = phi.T @ g[:COUNT]
        state, cross = own[:COUNT, :COUNT], own[:COUNT, COUNT:] * rho
        mixed = inputs.T @ cross
        later = own[COUNT:, COUNT:] * self._product + mixed + mixed.T
        own[COUNT:, COUNT:] = later + inputs.T @ state @ inputs
        own[:COUNT, COUNT:] = phi.T @ (state @ inputs + cross)
        own[COUNT:, :COUNT] = own[:COUNT, COUNT:].T
        carried = phi.T @ state @ phi
        own[:COUNT, :COUNT] = 0.5 * (carried + carried.T)


def smooth(filtered: Filtered, sensors: SensorStates, step: float) -> tuple[Smoothed, Adjoint]:
    """Smoothed states at the ends of the segments, and the adjoint at the beginning."""
    adjoint = Adjoint(COUNT + len(sensors), sensors.list_persistence(step))
    states, covariances = [], []
    for segment in reversed(filtered.segments):
        errors = segment.mean[:COUNT] - segment.cross @ adjoint.gradient
        own = segment.cross[:, :COUNT] - segment.cross @ adjoint.information @ segment.cross.T
        states.append(correct_state(segment.state, errors))
        covariances.append(own)
        for each in reversed(segment.steps):
            adjoint.go_back(each)
    states.reverse()
    track = Track(
        np.array([segment.time for segment in filtered.segments]),
        np.array([state.position for state in states]),
        np.array([state.velocity for state in states]),
        np.array([state.mat_nb for state in states]),
    )
    return Smoothed(track, np.array(covariances[::-1])), adjoint
