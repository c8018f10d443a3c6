"""Error-state Kalman filter: forward through a drive, with feedback to the navigator
(docs/methods/aided.md, Eqs. 1 to 8)."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.stats import chi2

from ins_eval.aided.fixes import Fixes
from ins_eval.aided.kalman.drive import Drive
from ins_eval.aided.kalman.measurements import Measurement, compare_fix
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.common.state import State, Track, displace
from ins_eval.error_model.dynamics import ATTITUDE, COUNT, POSITION, VELOCITY
from ins_eval.error_model.linear_model import linearize
from ins_eval.navigation.height import Free
from pyhrg.common.arrays import Array

SEGMENT = 10.0
"""Time between feedbacks that is aimed at, s. Chosen: an attitude error of 3 deg moves the
navigator by 25 m in it, and its square by 0.6 m."""
ALIGNED_SIGMA = 2e-3
"""Standard deviation of the attitude, rad, below which the filter feeds back. Chosen: feedback of
an estimate that is worse moves the navigator by more than the linear model takes; at 5 m/s^2 the
square of 2e-3 is 1 micro-g."""
LONGEST_UNALIGNED = 120.0
"""Time from the beginning after which the filter feeds back anyway, s. Chosen: gyros of 10 deg/h
turn the navigator by 6e-3 rad in it."""
OUTLIER_PROBABILITY = 1e-6
"""A fix whose innovation is less probable than this is not used. Chosen: one in a million of good
ones."""


GATES = {count: float(chi2.isf(OUTLIER_PROBABILITY, count)) for count in (1, 3)}
"""Largest normalised innovation squared of a fix of so many components."""


@dataclass(frozen=True)
class Start:
    """Where a filter begins. state: of the vehicle; covariance: (10, 10) of its errors."""

    state: State
    covariance: Array


@dataclass(frozen=True)
class Update:
    """One fix, used. gain: (n, m); sensitivity: (m, 10); inverse: (m, m) of the innovation's
    covariance; innovation: (m,)."""

    gain: Array
    sensitivity: Array
    inverse: Array
    innovation: Array

    @property
    def square(self) -> float:
        """Normalised innovation squared."""
        return float(self.innovation @ self.inverse @ self.innovation)


@dataclass(frozen=True)
class Step:
    """Transition (10, 10) and inputs (10, c) of a step, and the updates at its end."""

    transition: Array
    inputs: Array
    updates: list[Update]


@dataclass(frozen=True)
class Segment:
    """Steps between two feedbacks; state: navigated at their end; mean: (n,) and cross: (10, n),
    of the errors after the last update, before the feedback."""

    steps: list[Step]
    time: float
    state: State
    mean: Array
    cross: Array


@dataclass(frozen=True)
class Filtered:
    """Result of a forward pass.

    segments: in their order; coefficients: (c,) mean at the end; covariance: (n, n) at the end;
    state: at the end, after feedback; outliers: number of fixes that were not used.
    """

    segments: list[Segment]
    coefficients: Array
    covariance: Array
    state: State
    outliers: int

    @property
    def updates(self) -> list[Update]:
        return [u for s in self.segments for step in s.steps for u in step.updates]


class Filter:
    """Mean (n,) and covariance (n, n) of the navigator's ten errors and the c coefficients."""

    def __init__(self, sensors: SensorStates, start: Array, step: float) -> None:
        count = COUNT + len(sensors)
        self.mean = np.concatenate([np.zeros(COUNT), sensors.mean])
        self.covariance = np.zeros((count, count))
        self.covariance[:COUNT, :COUNT] = start
        self.covariance[COUNT:, COUNT:] = sensors.covariance
        self._persistence = sensors.list_persistence(step)
        self._product = np.outer(self._persistence, self._persistence)
        self._driving = np.diag(sensors.list_driving_variance(step))

    @property
    def attitude_sigma(self) -> float:
        """Largest standard deviation of the attitude, rad."""
        return float(np.sqrt(np.max(np.diag(self.covariance)[ATTITUDE])))

    def predict(self, transition: Array, inputs: Array, noise: Array) -> None:
        """Go on by a step (Eq. 2)."""
        p, x = self.covariance, self.mean
        x[:COUNT] = transition @ x[:COUNT] + inputs @ x[COUNT:]
        x[COUNT:] *= self._persistence
        top = transition @ p[:COUNT] + inputs @ p[COUNT:]
        own = top[:, :COUNT] @ transition.T + top[:, COUNT:] @ inputs.T + noise
        p[:COUNT, :COUNT] = 0.5 * (own + own.T)
        p[:COUNT, COUNT:] = top[:, COUNT:] * self._persistence
        p[COUNT:, :COUNT] = p[:COUNT, COUNT:].T
        p[COUNT:, COUNT:] = p[COUNT:, COUNT:] * self._product + self._driving

    def update(self, measured: Measurement, gate: float) -> Update | None:
        """Take in a fix (Eq. 7), unless its normalised innovation squared is above `gate`."""
        h = measured.sensitivity
        carried = self.covariance[:, :COUNT] @ h.T
        spread = h @ carried[:COUNT] + np.diag(measured.variance)
        inverse = np.linalg.inv(spread)
        innovation = measured.difference - h @ self.mean[:COUNT]
        update = Update(carried @ inverse, h, 0.5 * (inverse + inverse.T), innovation)
        if update.square > gate:
            return None
        self.mean += update.gain @ innovation
        reduced = self.covariance - update.gain @ carried.T
        self.covariance = 0.5 * (reduced + reduced.T)
        return update


def run_filter(
    drive: Drive,
    fixes: Fixes,
    sensors: SensorStates,
    start: Start,
    lever_arm: Array,
    last: int | None = None,
    gated: bool = True,
) -> Filtered:
    """Filter a drive from its beginning to its step `last`.

    fixes: within the drive; gated: whether fixes that are too improbable are left out.
    """
    last = drive.steps if last is None else min(last, drive.steps)
    length = max(1, round(SEGMENT / drive.step))
    kalman = Filter(sensors, start.covariance, drive.step)
    bounds = np.ceil((fixes.time - drive.increments.start) / drive.step - 1e-6).astype(int)
    bounds = np.maximum(bounds, 1)
    state, segments, outliers = start.state, [], 0
    for first in range(0, last, length):
        end = min(first + length, last)
        rows = np.arange(*np.searchsorted(bounds, [first, end], side="right"))
        track, motion = drive.navigate(state, first, end)
        model = linearize(motion, Free(), sensors.effects)
        noise = list_noise(model.constant_errors, sensors.noise, drive.step)
        steps = []
        for k, transition in enumerate(model.transition):
            inputs = model.inputs[k].reshape(COUNT, -1)
            kalman.predict(transition, inputs, noise[k])
            updates = []
            for row in rows[bounds[rows] == first + k + 1]:
                computed, rate = _interpolate(track, motion.rate, fixes.time[row])
                lag = fixes.time[row] - motion.time[k + 1]
                for measured in compare_fix(fixes, row, computed, rate, lag, lever_arm):
                    gate = GATES[len(measured.variance)] if gated else np.inf
                    update = kalman.update(measured, gate)
                    outliers += update is None
                    updates += [update] if update else []
            steps.append(Step(transition, inputs, updates))
        state = _pick_state(track, len(track) - 1)
        segments.append(
            Segment(
                steps, track.time[-1], state, kalman.mean.copy(), kalman.covariance[:COUNT].copy()
            )
        )
        if kalman.attitude_sigma < ALIGNED_SIGMA or end * drive.step > LONGEST_UNALIGNED:
            state = correct_state(state, kalman.mean[:COUNT])
            kalman.mean[:COUNT] = 0.0
    return Filtered(segments, kalman.mean[COUNT:], kalman.covariance, state, outliers)


def list_noise(constant_errors: Array, noise: Array, step: float) -> Array:
    """(k, 10, 10) covariance that the sensors' white noise adds in each step (Eq. 3)."""
    scaled = constant_errors * noise
    return np.asarray(scaled @ np.swapaxes(scaled, -1, -2) / step)


def _pick_state(track: Track, row: int) -> State:
    latitude, longitude, height = track.position[row].tolist()
    return State(latitude, longitude, height, track.velocity[row], track.mat_nb[row])


def correct_state(state: State, errors: Array) -> State:
    """The state less the errors (10,) that it is believed to have."""
    turned = Rotation.from_rotvec(-errors[ATTITUDE]).as_matrix()
    latitude, longitude, height = displace(state.position, -errors[POSITION]).tolist()
    velocity = state.velocity - errors[VELOCITY]
    return State(latitude, longitude, height, velocity, turned @ state.mat_nb)


def _interpolate(track: Track, rate: Array, time: float) -> tuple[State, Array]:
    """State at a time between the rows of a track, and the rate (3,) there: cubic in position,
    linear in velocity, turned on from the row before."""
    spacing = track.time[1] - track.time[0]
    row = int(np.clip((time - track.time[0]) // spacing, 0, len(track) - 2))
    since = time - track.time[row]
    share = since / spacing
    state, then = _pick_state(track, row), _pick_state(track, row + 1)
    mean = 0.5 * (rate[row] + rate[row + 1])
    turned = Rotation.from_rotvec(since * mean).as_matrix()
    smooth = share * share * (3 - 2 * share)
    across = then.position - state.position
    moved = displace(state.position, spacing * share * (1 - share) ** 2 * state.velocity)
    ahead = displace(state.position, spacing * share**2 * (1 - share) * then.velocity)
    position = moved - (ahead - state.position) + smooth * across
    return (
        replace(
            state,
            latitude=float(position[0]),
            longitude=float(position[1]),
            height=float(position[2]),
            velocity=state.velocity + share * (then.velocity - state.velocity),
            mat_nb=state.mat_nb @ turned,
        ),
        mean,
    )
