"""Virtual rotation: dead zone (section 2.4), self-calibration and noise (sections 2.5, 3.2)."""

import math

import numpy as np
from scipy import stats

from pyhrg.common.units import DEG, DEG_PER_H, HOUR
from tests.agreement.paper.gyros import DAMPING, TAU, K, load_fmu, simulate_output_rate

D = 4e-3
LIMIT = D / (4 * K)
"""Half width of the dead zone of the gyro that is locked, rad/s."""
V = 0.1
"""Virtual rotation, as an input rate, rad/s."""
SELF_CALIBRATION = 1 * DEG
"""Virtual rotation of the gyro whose bias is averaged, rad/s."""
FRAME, GAIN = "drive.frameRotation", "controller.readout.virtualRotationError"
WHITE, ROTATION_NOISE = "noise.angleRandomWalk", "noise.virtualRotation"
MEANS = 2000


def figures() -> dict[str, float]:
    """Moved dead zone, what is averaged and what is not, random walk."""
    return {**_dead_zone(), **_self_calibration(), **_random_walk()}


def _dead_zone() -> dict[str, float]:
    """Output over input at two rates, with and without rotation: 0.6 W_L, and V + 0.6 W_L."""
    gyro = {DAMPING: D}
    slow, fast = 0.6 * LIMIT, V + 0.6 * LIMIT

    def gain(rate: float, rotation: float) -> float:
        free = math.sqrt(max((rotation - rate) ** 2 - LIMIT**2, 0.0)) or LIMIT
        periods = round(50 * 2 * math.pi / (4 * K * free), 1)
        output = simulate_output_rate(
            gyro, 0.0, rate, 5000.0, periods, "HRGSlow", virtualRotation=rotation
        )
        return output / rate

    adler = V - math.sqrt((V - slow) ** 2 - LIMIT**2)
    return {
        "at_rest_without_rotation": gain(slow, 0.0),
        "at_rest_with_rotation": gain(slow, V),
        "at_rest_with_rotation_adler": adler / slow,
        "at_v_without_rotation": gain(fast, 0.0),
        "at_v_with_rotation": gain(fast, V),
        "v_over_input": V / fast,
    }


def _self_calibration() -> dict[str, float]:
    """Bias with rotation on, averaged over whole periods of the map, deg/h."""
    period = math.pi / 2 / (K * SELF_CALIBRATION)
    bias = 1 * DEG_PER_H

    def mean(parameters: dict[str, float], rotation: float) -> float:
        whole = 4 * period
        output = simulate_output_rate(
            parameters, 22.5 / 4 * DEG, 0.0, 20.0, whole, virtualRotation=rotation
        )
        return output / DEG_PER_H

    def added(parameters: dict[str, float], rotation: float = SELF_CALIBRATION) -> float:
        return mean(parameters, rotation) - mean({}, rotation)

    return {
        "anisotropy_at_rest_deg_h": added({DAMPING: 4 * K * bias}, 0.0),
        "anisotropy_rotated_deg_h": added({DAMPING: 4 * K * bias}),
        "frame_rotated_deg_h": added({FRAME: -2 * K * TAU * bias}),
        "gain_error_rotated_deg_h": added({GAIN: 1e-4}),
    }


def _random_walk() -> dict[str, float]:
    """Random walk with rotation over without, N^2 + V^2 s^2 over N^2, on the FMU and its interval.

    s is what makes it ten times as large: the drive's relative noise that the paper's figure takes.
    """
    white = 1e-4 * DEG / math.sqrt(HOUR)
    noise = math.sqrt(99) * white / SELF_CALIBRATION
    deviations = [_deviation({WHITE: white, ROTATION_NOISE: noise}, v) for v in (0.0, 1.0)]
    ratio = deviations[1] / deviations[0]
    low, high = stats.f.ppf([0.025, 0.975], MEANS - 1, MEANS - 1)
    return {
        "relative_noise_ppm_sqrt_s": noise * 1e6,
        "random_walk_ratio": ratio,
        "random_walk_ratio_low": ratio / math.sqrt(high),
        "random_walk_ratio_high": ratio / math.sqrt(low),
        "random_walk_means": MEANS,
    }


def _deviation(parameters: dict[str, float], rotating: float) -> float:
    """Standard deviation of 1 s means of the rate, rad/s."""
    commands = {"virtualRotation": np.full(MEANS + 20, rotating * SELF_CALIBRATION)}
    moving = {"angularRate": np.zeros((MEANS + 20, 10))}
    with load_fmu("HRGSlow").power_on(parameters, seed=1, start_angle=0.0) as gyro:
        ends, _ = gyro.record(moving, commands, 0.1, ["gyroAngle"])
    return float(np.std(np.diff(ends[20:, 0]), ddof=1))
