"""Keys of a device file: each with its unit, its range, and the field that it states."""

import math
from dataclasses import dataclass, fields

from pyhrg.common.units import (
    ARCSEC,
    DEG,
    DEG_PER_H,
    DEG_PER_SQRT_H,
    HOUR,
    HZ,
    MINUTE,
    PPM,
    STANDARD_GRAVITY,
    ZERO_CELSIUS,
)
from pyhrg.device.device import AngleMap


@dataclass(frozen=True)
class Key:
    """A number of the file: SI is value * factor + offset; low and high are in the file's unit."""

    name: str
    field: str
    factor: float
    low: float
    high: float
    offset: float = 0.0

    @property
    def expected(self) -> str:
        """The range, in words."""
        if self.low == self.high:
            return f"{self.low:g}, the only one there is"
        return f"{self.low:g} to {self.high:g}"

    def to_si(self, value: float) -> float:
        """Value of the field."""
        return value * self.factor + self.offset

    def from_si(self, value: float) -> float:
        """The shortest number of the file that gives the value, or the nearest."""
        plain = (value - self.offset) / self.factor
        neighbours = (plain, math.nextafter(plain, -math.inf), math.nextafter(plain, math.inf))
        candidates = (float(f"{plain:.14g}"), *neighbours)
        return min(candidates, key=lambda candidate: abs(self.to_si(candidate) - value))


TURN = 360.0

KEYS = (
    Key("coriolis_factor", "bryan_factor", 1, 0.02, 0.9),
    Key("coriolis_factor_error_ppm", "bryan_factor_error", PPM, -1e5, 1e5),
    Key("decay_time_s", "decay_time", 1, 1, 1e5),
    Key("decay_time_per_K", "decay_time_per_kelvin", 1, -0.1, 0.1),
    Key("decay_time_temperature_coefficient_per_K", "decay_time_per_kelvin", 1, -0.1, 0.1),
    Key("damping_anisotropy_per_s", "damping_anisotropy", 1, 0, 1e-2),
    Key("damping_axis_deg", "damping_axis", DEG, -TURN, TURN),
    Key("damping_anisotropy_per_K", "damping_anisotropy_per_kelvin", 1, -1, 1),
    Key("frequency_Hz", "frequency", HZ, 200, 1e5),
    Key("frequency_temperature_coefficient_per_K", "frequency_per_kelvin", 1, -1e-3, 1e-3),
    Key("frequency_split_Hz", "frequency_split", HZ, 0, 10),
    Key("stiffness_axis_deg", "stiffness_axis", DEG, -TURN, TURN),
    Key("duffing_Hz", "duffing", HZ, -10, 10),
    Key("thermal_lag_s", "thermal_lag", 1, 1, 1e6),
    Key("reference_temperature_degC", "reference_temperature", 1, -150, 200, ZERO_CELSIUS),
    Key("pickoff_gain_mismatch", "pickoff_gain_mismatch", 1, -0.5, 0.5),
    Key("pickoff_gain_per_K", "pickoff_gain_per_kelvin", 1, -0.01, 0.01),
    Key("pickoff_gain_per_g", "pickoff_gain_per_acceleration", 1 / STANDARD_GRAVITY, -0.09, 0.09),
    Key("pickoff_nonorthogonality", "pickoff_nonorthogonality", 1, -0.5, 0.5),
    Key("pickoff_cubic", "pickoff_cubic", 1, -0.1, 0.1),
    Key("phase_error_rad", "phase_error", 1, -1, 1),
    Key("phase_rad_per_K", "phase_per_kelvin", 1, -0.01, 0.01),
    Key("differential_phase_rad", "differential_phase", 1, -1, 1),
    Key("demodulation_offset", "demodulation_offset", 1, -0.1, 0.1),
    Key("feedthrough_s", "feedthrough", 1, -0.01, 0.01),
    Key("drive_gain_mismatch", "drive_gain_mismatch", 1, -0.5, 0.5),
    Key("drive_nonorthogonality", "drive_nonorthogonality", 1, -0.5, 0.5),
    Key("drive_frame_rotation_rad", "drive_frame_rotation", 1, -0.5, 0.5),
    Key("bias_deg_h_per_K_min", "bias_per_temperature_rate", DEG_PER_H * MINUTE, -10, 10),
    Key("bias_deg_h_per_g", "bias_per_acceleration", DEG_PER_H / STANDARD_GRAVITY, -10, 10),
    Key("amplitude", "amplitude", 1, 0.01, 10),
    Key("residual_quadrature", "residual_quadrature", 1, -0.5, 0.5),
    Key("amplitude_loop_rad_s", "amplitude_loop", 1, 0.01, 500),
    Key("quadrature_loop_rad_s", "quadrature_loop", 1, 0.01, 500),
    Key("phase_loop_rad_s", "phase_loop", 1, 0.01, 500),
    Key("control_period_s", "control_period", 1, 1e-3, 1e-3),
    Key("loop_delay_s", "loop_delay", 1, 0, 0.1),
    Key("virtual_rotation_gain_ppm", "virtual_rotation_error", PPM, -1e5, 1e5),
    Key("angle_random_walk_deg_sqrt_h", "angle_random_walk", DEG_PER_SQRT_H, 0, 10),
    Key("rate_random_walk_deg_h_sqrt_h", "rate_random_walk", DEG_PER_H / math.sqrt(HOUR), 0, 1000),
    Key("bias_instability_deg_h", "bias_instability", DEG_PER_H, 0, 1e4),
    Key("angle_white_noise_arcsec", "pickoff_noise", ARCSEC, 0, 1e4),
    Key("quantum_arcsec", "angle_quantum", ARCSEC, 0, 3600),
    Key("misalignment_rad", "misalignment", 1, 0, 0.5),
    Key("misalignment_direction_deg", "misalignment_direction", DEG, -TURN, TURN),
    Key("power_on_angle_deg", "power_on_angle", DEG, -TURN, TURN),
    Key("power_on_scatter_deg", "power_on_scatter", DEG, 0, 45),
)
"""At the top of the file. Where two keys state a field, the first is written."""

SITE_KEYS = (
    Key("latitude_deg", "latitude", DEG, -90, 90),
    Key("gravity_m_s2", "gravity", 1, 9.7, 9.9),
)

MAPS = {
    "bias_map": tuple(Key(f.name, f.name, DEG_PER_H, -1e4, 1e4) for f in fields(AngleMap)),
    "scale_factor_map": tuple(
        Key(f.name, f.name, ARCSEC, -2e4, 2e4) for f in fields(AngleMap) if f.name != "mean"
    ),
}
"""Tables of coefficients over the pattern angle, by the device's field."""
