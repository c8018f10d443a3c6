"""Alignment in motion: attitude, velocity and position at the beginning of a drive, from fixes
(docs/methods/aided.md, Eqs. 12 and 13)."""

import numpy as np
from scipy.spatial.transform import Rotation

from ins_eval.aided.fixes import Fixes
from ins_eval.aided.kalman.backward import smooth
from ins_eval.aided.kalman.drive import Drive
from ins_eval.aided.kalman.forward import Start, correct_state, run_filter
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.alignment.inertial_frame import integrate_in_inertial_frame
from ins_eval.common import earth
from ins_eval.common.state import State
from ins_eval.error_model.dynamics import ATTITUDE, COUNT, HEIGHT_INTEGRAL, POSITION, VELOCITY
from ins_eval.navigation.coefficients import derive_coefficients
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

WINDOW = 600.0
"""Time from the beginning over which the alignment looks, s. Chosen: Earth turns by 2.5 deg."""
SPANS = 20
"""Spans of the coarse alignment. Chosen."""
ATTITUDE_SIGMA, VELOCITY_SIGMA, POSITION_SIGMA = 0.2, 10.0, 100.0
"""Standard deviations at the beginning of each component, rad, m/s, m. Chosen: wider than what a
coarse alignment leaves, so that the fixes decide."""
MOST_ROUNDS = 8
SETTLED = 0.1
"""The start has settled when a round moves no error by more than this share of its sigma."""


def align_in_motion(drive: Drive, fixes: Fixes, sensors: SensorStates, lever_arm: Array) -> Start:
    """The start of a drive, by rounds of filter and smoother over `WINDOW` from a coarse alignment.

    Raises:
        HrgError: too few positions in the window; rounds that do not settle.
    """
    window = fixes.between(-np.inf, drive.increments.start + WINDOW)
    state = align_coarsely(drive, window)
    covariance = np.zeros(COUNT)
    covariance[POSITION] = POSITION_SIGMA**2
    covariance[VELOCITY] = VELOCITY_SIGMA**2
    covariance[ATTITUDE] = ATTITUDE_SIGMA**2
    prior = np.diag(covariance)
    last = min(drive.steps, round(WINDOW / drive.step))
    own = slice(0, HEIGHT_INTEGRAL)
    for _ in range(MOST_ROUNDS):
        start = Start(state, prior)
        filtered = run_filter(drive, window, sensors, start, lever_arm, last, gated=False)
        _, adjoint = smooth(filtered, sensors, drive.step)
        errors = -prior @ adjoint.gradient[:COUNT]
        left = prior - prior @ adjoint.information[:COUNT, :COUNT] @ prior
        state = correct_state(state, errors)
        if np.all(np.abs(errors[own]) < SETTLED * np.sqrt(np.abs(np.diag(left)[own]))):
            return Start(state, prior)
    raise HrgError(
        f"{fixes.source}: the alignment over {last * drive.step:g} s does not settle in "
        f"{MOST_ROUNDS} rounds; expected fixes of the log's vehicle in the log's time"
    )


def align_coarsely(drive: Drive, fixes: Fixes) -> State:
    """The state at the beginning by second differences of the positions (Eq. 12), as if the antenna
    were at the IMU.

    Raises:
        HrgError: too few positions.
    """
    part = fixes.select(fixes.has_position)
    begin = drive.increments.start
    span = min(WINDOW, drive.increments.duration, float(part.time[-1]) - begin) / SPANS
    bounds = begin + span * np.arange(SPANS + 1.0)
    if len(part) < 2 * SPANS or np.max(np.diff(part.time)) > span:
        raise HrgError(
            f"{fixes.source}: found {len(part)} positions in the first {SPANS * span:g} s of the "
            f"log; expected at least one in each {span:g} s"
        )
    inertial = to_inertial(part.time - begin, part.position)
    gravitation = find_gravitation(part.time - begin, part.position)
    way, pull = (_interpolate(bounds, part.time, x) for x in (inertial, gravitation))
    pulled = span**2 / 12 * (pull[:-2] + 10 * pull[1:-1] + pull[2:])
    wanted = np.diff(way, n=2, axis=0) - pulled
    moved = _integrate_force(drive, bounds - begin)
    weights = np.linalg.norm(wanted, axis=1)
    turned, _ = Rotation.align_vectors(wanted, np.diff(moved, n=2, axis=0), 1 / weights**2)
    latitude, longitude, height = part.position[0].tolist()
    mat_nb = axes_in_inertial(latitude, longitude).T @ turned.as_matrix()
    few = slice(0, max(2, int(np.searchsorted(part.time, part.time[0] + 2.0))))
    slope = np.polyfit(part.time[few] - begin, part.position[few] - part.position[0], 1)[0]
    radii = np.array(
        [
            earth.meridian_radius(latitude) + height,
            (earth.transverse_radius(latitude) + height) * np.cos(latitude),
            -1.0,
        ]
    )
    return State(latitude, longitude, height, slope * radii, mat_nb)


def to_inertial(time: Array, position: Array) -> Array:
    """(m, 3) places, m, of positions (m, 3) in axes through Earth's centre that are fixed in
    inertial space and Earth's own at time 0 (Groves 2013, Eqs. 2.112, 2.145)."""
    latitude, longitude, height = position.T
    turned = longitude + earth.RATE * time
    radius = earth.transverse_radius(latitude)
    level = (radius + height) * np.cos(latitude)
    along = (radius * (1 - earth.ECCENTRICITY_SQUARED) + height) * np.sin(latitude)
    return np.stack([level * np.cos(turned), level * np.sin(turned), along], axis=-1)


def find_gravitation(time: Array, position: Array) -> Array:
    """(m, 3) attraction of Earth's mass in the axes of `to_inertial`, m/s^2: gravity less the
    centrifugal acceleration."""
    latitude, longitude, height = position.T
    down = earth.gravity(latitude, height)
    north, east = earth.horizontal_gravity(latitude, height, (0.0, 0.0))
    gravity = np.stack([north, east * np.ones_like(north), down], axis=-1)
    axes = np.array(
        [
            axes_in_inertial(a, b)
            for a, b in zip(latitude, longitude + earth.RATE * time, strict=True)
        ]
    )
    outward = to_inertial(time, position) * [1.0, 1.0, 0.0]
    return np.asarray(np.einsum("mij,mj->mi", axes, gravity) - earth.RATE**2 * outward)


def axes_in_inertial(latitude: float, turned: float) -> Array:
    """(3, 3) from north, east, down to the axes of `to_inertial`; turned: longitude plus Earth's
    turn, rad (Groves 2013, Eq. 2.150)."""
    sin, cos, sin_t, cos_t = np.sin(latitude), np.cos(latitude), np.sin(turned), np.cos(turned)
    return np.array(
        [
            [-sin * cos_t, -sin_t, -cos * cos_t],
            [-sin * sin_t, cos_t, -cos * sin_t],
            [cos, 0.0, -sin],
        ]
    )


def _integrate_force(drive: Drive, since: Array) -> Array:
    """(k, 3) double integral of the specific force in the first body axes, m, at times (k,), s."""
    increments = drive.increments
    count = min(len(increments), int(np.ceil(since[-1] / increments.interval / 2 + 1)) * 2)
    steps = count // 2
    gained = np.empty((steps, 3))
    integrate_in_inertial_frame(
        increments.rotation[:count],
        increments.velocity[:count],
        derive_coefficients(2),
        1,
        gained,
    )
    length = 2 * increments.interval
    velocity = np.concatenate([np.zeros((1, 3)), np.cumsum(gained, axis=0)])
    moved = np.cumsum(0.5 * length * (velocity[1:] + velocity[:-1]), axis=0)
    moved = np.concatenate([np.zeros((1, 3)), moved])
    return _interpolate(since, length * np.arange(steps + 1.0), moved)


def _interpolate(at: Array, time: Array, values: Array) -> Array:
    """(k, 3) values at times, linear between those given."""
    return np.stack([np.interp(at, time, column) for column in values.T], axis=-1)
