"""Closed forms that tests compare the simulation with and predictions use; nothing is simulated.

Angles are physical pattern angles. `k` is the Bryan factor, `tau` the mean decay time. Sources:
D. D. Lynch, Vibratory gyro analysis by the method of averaging (1995), in the form checked in
Senkal and Shkel, Whole-Angle MEMS Gyroscopes (2020); each docstring says what is derived from it.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.device.device import Device


def static_bias_phasor(device: Device) -> complex:
    """Fourth harmonic H of the output bias at rest, B(th) = mean + Re(H exp(-4i th)), rad/s.

    First order in every imperfection, loops closed: damping anisotropy gives
    -(D/4k) sin 4(th - th_tau); a gain mismatch g of pick-offs or drives +(g/4k tau) sin 4th (the
    force that sustains the amplitude is misaimed); a non-orthogonality d -(d/4k tau)(1 + cos 4th);
    a frequency split with phase error p -(dw p/4k) sin 4(th - th_w). The share s of the amplitude
    force that parametric drive gives is not misaimed; its anisotropy n gives
    +(s n/2k tau) sin 4(th - th_n).
    """
    gain, skew = _misaimed_force(device)
    growth = device.damping_anisotropy * np.exp(4j * device.damping_axis) - _pump(device) - gain
    split = device.frequency_split * device.phase_error * np.exp(4j * device.stiffness_axis)
    return complex((-1j * (growth + split) - skew) / (4 * device.bryan_factor))


def _misaimed_force(device: Device) -> tuple[float, float]:
    """Gain mismatch and non-orthogonality of pick-offs and drives, over the decay time, 1/s, for
    the share of the amplitude force that electrodes give along the detected axes."""
    driven = (1 - device.parametric_share) / device.decay_time
    gain = device.pickoff_gain_mismatch + device.drive_gain_mismatch
    skew = device.pickoff_nonorthogonality + device.drive_nonorthogonality
    return driven * gain, driven * skew


def _pump(device: Device) -> complex:
    """Anisotropy of damping that an anisotropy of parametric drive is the opposite of, 1/s."""
    growth = 2 * device.parametric_share / device.decay_time * device.pump_anisotropy
    return complex(growth * np.exp(4j * device.pump_axis))


def amplitude_force_phasor(device: Device) -> complex:
    """Fourth harmonic H of the amplitude force at rest, G(th) = mean + Re(H exp(-4i th)), 1/s.

    First order, loops closed: (D/2) cos 4(th - th_tau) of damping anisotropy, -(g/2 tau) cos 4th of
    gain mismatches, -(d/2 tau) sin 4th of non-orthogonalities; of parametric drive's share s their
    part is missing, and its anisotropy n gives -(s n/tau) cos 4(th - th_n). But for a split with
    phase error it is 2ik times `static_bias_phasor`: the bias is the slope of the amplitude force
    over 8k.
    """
    gain, skew = _misaimed_force(device)
    damping = device.damping_anisotropy * np.exp(4j * device.damping_axis)
    return complex((damping - _pump(device) - gain - 1j * skew) / 2)


def turning_amplitude_force_phasor(device: Device) -> complex:
    """What `amplitude_force_phasor` gains per rad/s of the case: 2k (d - i g).

    Pick-off errors let the true amplitude vary along the pattern angle by -(g/2) cos 4th
    - (d/2) sin 4th while the detected one is held. A turning pattern takes a force for that.
    """
    k = device.bryan_factor
    return 2 * k * complex(device.pickoff_nonorthogonality, -device.pickoff_gain_mismatch)


def rotated_amplitude_force_phasor(device: Device) -> complex:
    """What `amplitude_force_phasor` gains per rad/s of virtual rotation: k (ig + i gd - d - nd).

    The pattern turns by +k as the case's rate turns it by -k, and drive errors aim a share of the
    force that turns it along the pattern.
    """
    gain = device.pickoff_gain_mismatch + device.drive_gain_mismatch
    skew = device.pickoff_nonorthogonality + device.drive_nonorthogonality
    return device.bryan_factor * complex(-skew, gain)


def static_bias(device: Device, pattern_angle: ArrayLike) -> NDArray[np.float64]:
    """Output bias at rest, rad/s, at each pattern angle (rad); see `static_bias_phasor`."""
    harmonic = static_bias_phasor(device) * np.exp(-4j * np.asarray(pattern_angle))
    return np.asarray(mean_bias(device) + harmonic.real)


def mean_bias(device: Device) -> float:
    """Output bias at rest averaged over the circumference, rad/s: -(1 - s)(d + nd + 2e)/(4 k tau).

    The non-orthogonalities d of the pick-offs and nd of the drives, and the rotation e of the drive
    frame, aim the force that sustains the amplitude across the pattern, but for the share s of
    parametric drive.
    """
    skew = device.pickoff_nonorthogonality + device.drive_nonorthogonality
    skew += 2 * device.drive_frame_rotation
    driven = (1 - device.parametric_share) / device.decay_time
    return -skew * driven / (4 * device.bryan_factor)


def circumferential_bias_stability(device: Device) -> float:
    """Standard deviation of the bias over the circumference, rad/s: amplitude over sqrt 2."""
    return abs(static_bias_phasor(device)) / math.sqrt(2)


def hold_scale_factor_error(control_period: float, delay: float, decay_time: float) -> float:
    """Scale-factor error of a gyro whose forces lag the pattern: -(Ts/2 + delay)/tau.

    Forces are computed for the angle at the sample and held: on average they point at where the
    pattern was Ts/2 + delay ago, and the amplitude force 1/tau pulls it back. The delay is that of
    the loop and of the demodulation's filter.
    """
    return -(control_period / 2 + delay) / decay_time


def find_largest_filter_delay(natural_frequency: float) -> float:
    """Delay of the demodulation's filter, s, at which a loop is at its limit of stability: 2/w.

    Of s^2 (1 + s delay) + 2 w s + w^2 = 0 by the Routh-Hurwitz criterion; the sampled loop has the
    same limit, with a pole on the unit circle.
    """
    return 2 / natural_frequency


def time_division_bias(device: Device, pattern_angle: ArrayLike) -> NDArray[np.float64]:
    """Output bias at rest by drive and sense in alternate control periods, rad/s.

    A split takes the quadrature force (dw/2) sin 4(th - th_w). It acts twice as large in every
    second period, so that quadrature is Ts/2 times it in the mean while its reading is zero:
    B = -(dw^2 Ts/16k) sin 8(th - th_w).
    """
    size = device.frequency_split**2 * device.control_period / (16 * device.bryan_factor)
    angle = np.asarray(pattern_angle) - device.stiffness_axis
    return np.asarray(-device.time_division * size * np.sin(8 * angle))


def late_ripple(loop: complex, lag: float, bryan_factor: float, rate: float) -> complex:
    """The change z of a pick-off error's scale-factor map by the amplitude ripple that it causes.

    A gain mismatch g makes the amplitude loop drive the true amplitude by -(g/2) cos 4th; while
    the pattern turns this takes a force, aimed at where the pattern was Ts/2 + delay ago (`lag`).
    The map's harmonic (cosine c, sine s) of order h turns into

        c (1 + Im z) and s (1 + Im z), and a bias of W Re z (s, -c),  z = 2 k W lag H(i h k |W|)

    with the amplitude loop's response H (`loop`) to its set point; the offset's second and the
    cubic's eighth harmonic alike.
    """
    return 2 * bryan_factor * abs(rate) * lag * loop


def misaimed_ripple_scale_factor(
    gain_mismatch: float, nonorthogonality: float, loop: complex
) -> float:
    """Scale-factor error of second order of a gyro whose pick-off errors ripple its amplitude.

    The force that makes the ripple (`late_ripple`) is misaimed by the same errors, e.g.
    -(g/4) sin 4th: -(g^2/2) W sin^2 4th of the output rate, -(g^2 + d^2)/4 Re H of it on average.
    """
    return -(gain_mismatch**2 + nonorthogonality**2) / 4 * loop.real


def beyond_the_average(
    device: Device, rate: ArrayLike, pattern_angle: ArrayLike
) -> dict[str, NDArray[np.float64]]:
    """Corrections of a turning gyro's loop signals, by field of a log: the next order beyond the
    average over a carrier period.

    With c = 2 k W, the coupling of the modes, the velocity in the turning case has c/w of the
    displacement across the pattern. Damping of it takes a quadrature force -c/(w tau), rad/s. Under
    a split it does work, which takes -(dw/2)(c/w) Im H exp(4i (th - th_w)) of the amplitude force,
    1/s, with H = (1 + 2z)/(1 + z)^2 of a critically damped loop, z = -4i k W over its natural
    frequency. The mean modal frequency is c^2/2w higher, rad/s. Where forces are held for a whole
    number of half carrier periods, these two forces are others by a half. The case's rate, rad/s,
    and the pattern angle, rad, are of one shape.
    """
    coupling = 2 * device.bryan_factor * np.asarray(rate)
    share = coupling / device.frequency
    z = -2j * coupling / device.amplitude_loop
    fourth = np.exp(4j * (np.asarray(pattern_angle) - device.stiffness_axis))
    work = np.imag((1 + 2 * z) / (1 + z) ** 2 * fourth)
    return {
        "quadrature_force": -share / device.decay_time,
        "amplitude_force": -device.frequency_split / 2 * share * work,
        "frequency_offset": coupling * share / 2,
    }


def lock_rate(device: Device) -> float:
    """Input rate below which a free pattern locks in, rad/s: amplitude of the bias map.

    With damping anisotropy alone W_L = D/(4k). (R. Adler, A study of locking phenomena in
    oscillators, 1946: th' = -k (W - mean bias) + (D/4) sin 4(th - th_tau) is his equation.)
    """
    return abs(static_bias_phasor(device))


def adler_mean_rate(rate: ArrayLike, lock: float) -> NDArray[np.float64]:
    """Mean output rate at an input rate, rad/s: 0 within +-lock, else sqrt(W^2 - W_L^2)."""
    given = np.asarray(rate, dtype=float)
    return np.asarray(np.sign(given) * np.sqrt(np.maximum(given**2 - lock**2, 0.0)))


def adler_lock_angle(rate: float, lock: float, damping_axis: float) -> float:
    """Pattern angle at which it locks, rad, one every 90 deg: sin 4(th_L - th_tau) = W/W_L.

    Of the two angles the one with cos 4(th_L - th_tau) < 0 is stable.
    """
    return damping_axis + (math.pi - math.asin(rate / lock)) / 4
