"""Signals that a gyro's map follows in flight (docs/methods/mission_model.md, Eqs. 3 and 4).

The map in flight is a sum of maps, one for each signal, times the signal. A harmonic of the scale
factor is the error of the detected pattern angle, as a rate. When the harmonic changes, the
detected angle moves, even at rest: 3 ppm/K of an electrode's gain make a bias of 0.02 deg/h while
the gyro warms by 2 K in a minute. Maps change with warmth w as a w + b w^2, because a calibrated
gyro has the small difference of large terms, and each of these has its own curve.

After power-on the case approaches its final temperature with the time constant `CASE_WARM_UP`. The
resonator follows the case with `WARM_UP`. Both begin at the temperature of the calibration. Warmth
is the share, 0 to 1, of the final rise of temperature. Times are seconds since the alignment.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.error_model.effects import (
    ANGULAR_GAIN,
    Effect,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    pattern_angle,
    pick_off_map,
)
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.imu.gyros import case_axes
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.missions import CASE_WARM_UP, STILL, WARM_UP
from pyhrg.common.arrays import Array


def compute_case_warmth(time: Array) -> Array:
    return np.asarray(1 - np.exp(-(time + STILL) / CASE_WARM_UP))


def compute_case_warming_rate(time: Array) -> Array:
    """Rate of the case's warmth, 1/s."""
    return np.asarray(np.exp(-(time + STILL) / CASE_WARM_UP) / CASE_WARM_UP)


def compute_resonator_warmth(time: Array) -> Array:
    resonator, case = _compute_lags(time)
    return np.asarray(1 - (WARM_UP * resonator - CASE_WARM_UP * case) / (WARM_UP - CASE_WARM_UP))


def compute_resonator_warming_rate(time: Array) -> Array:
    """Rate of the resonator's warmth, 1/s."""
    resonator, case = _compute_lags(time)
    return np.asarray((resonator - case) / (WARM_UP - CASE_WARM_UP))


def _compute_lags(time: Array) -> tuple[Array, Array]:
    since = time + STILL
    return np.exp(-since / WARM_UP), np.exp(-since / CASE_WARM_UP)


Regressor = Callable[[Motion], Array]

AXES = 3
CROSS_AXES = np.stack([case_axes(axis)[0] for axis in np.eye(AXES)])
"""(3, 3) direction of the x electrodes of the gyros along forward, right, down; a row each, in body
axes."""


@dataclass(frozen=True)
class Signal:
    """A signal along a motion.

    name; value: (m, 1 or 3) values for each gyro at a motion's nodes; rate: their derivative by
    time, 1/s.
    """

    name: str
    value: Regressor
    rate: Regressor


def _make_time_signal(
    name: str, value: Callable[[Array], Array], rate: Callable[[Array], Array]
) -> Signal:
    return Signal(
        name,
        lambda m: value(_list_node_times(m))[:, None],
        lambda m: rate(_list_node_times(m))[:, None],
    )


def _make_motion_signal(name: str, value: Regressor) -> Signal:
    return Signal(name, value, lambda m: np.gradient(value(m), m.step / PARTS, axis=0))


def _list_node_times(motion: Motion) -> Array:
    return np.asarray(motion.start + motion.step / PARTS * np.arange(len(motion.rate)))


SIGNALS = (
    _make_time_signal("power-on", np.ones_like, np.zeros_like),
    _make_time_signal("warmth", compute_resonator_warmth, compute_resonator_warming_rate),
    _make_time_signal(
        "warmth squared",
        lambda t: compute_resonator_warmth(t) ** 2,
        lambda t: 2 * compute_resonator_warmth(t) * compute_resonator_warming_rate(t),
    ),
    _make_time_signal(
        "heating", compute_case_warming_rate, lambda t: -compute_case_warming_rate(t) / CASE_WARM_UP
    ),
    _make_motion_signal(
        "specific force along x electrodes, m/s^2", lambda m: m.force @ CROSS_AXES.T
    ),
    _make_motion_signal("specific force along input axis, m/s^2", lambda m: m.force),
    _make_motion_signal("rate squared, (rad/s)^2", lambda m: m.rate**2),
)
STEADY, WARMING, ENVIRONMENT = slice(0, 1), slice(1, 3), slice(3, 7)
"""Groups of `SIGNALS`: constant, by warmth, by the environment."""
COUNT = len(SIGNALS) * 2 * TERMS
"""Number of coefficients in flight: those of a map for each signal in turn."""


def slice_coefficients(signals: slice) -> slice:
    """The coefficients, among `COUNT`, of a group of signals."""
    return slice(signals.start * 2 * TERMS, signals.stop * 2 * TERMS)


def list_signal_effects() -> list[Effect]:
    """`COUNT` effects of patterns that start at angle 0, in the order of the coefficients."""
    zero = np.zeros(AXES)
    bias = [gyro_bias(), *(e for h in HARMONICS for e in bias_map(h, zero))]
    scale = [gyro_scale_factor(), *(e for h in HARMONICS for e in pick_off_map(h, zero))]
    errors = [*[None] * (TERMS + 1), *list_angle_errors(zero)]
    return [
        follow_signal(effect, signal, error)
        for signal in SIGNALS
        for effect, error in zip((*bias, *scale), errors, strict=True)
    ]


def follow_signal(effect: Effect, signal: Signal, angle_error: Regressor | None = None) -> Effect:
    """The effect whose coefficient follows a signal (Eq. 4).

    angle_error: (m, 3) error of the detected angle, rad per unit of the coefficient, where the
    effect is the rate of such an error.
    """

    def regressor(motion: Motion) -> Array:
        rate_error = effect.regressor(motion) * signal.value(motion)
        if angle_error is None:
            return np.asarray(rate_error)
        return np.asarray(rate_error + angle_error(motion) * signal.rate(motion))

    return replace(effect, name=f"{effect.name}, {signal.name}", regressor=regressor)


def list_angle_errors(first_angle: Array) -> list[Regressor]:
    """Errors of the detected angle whose rates are the harmonics of the scale factor, cosine and
    sine in turn (Eq. 4); `first_angle` (3,) is in rad."""

    def error(harmonic: int, sign: float, wave: Callable[[Array], Array]) -> Regressor:
        factor = sign / (harmonic * ANGULAR_GAIN)
        return lambda motion: factor * wave(harmonic * pattern_angle(motion, first_angle))

    waves = ((-1.0, np.sin), (1.0, np.cos))
    return [error(h, sign, wave) for h in HARMONICS for sign, wave in waves]
