"""The nominal device of a campaign, drawn about the values of the recorded campaigns."""

import numpy as np

from pyhrg.common.site import Site
from pyhrg.common.units import DEG

TYPICAL_VALUES = {
    "decay_time_s": (450.0, 0.15),
    "frequency_Hz": (7000.0, 0.05),
    "damping_anisotropy_per_s": (1e-6, 0.5),
    "frequency_split_Hz": (5e-4, 0.3),
    "angle_random_walk_deg_sqrt_h": (3e-4, 0.2),
    "angle_white_noise_arcsec": (0.036, 0.2),
    "frequency_temperature_coefficient_per_K": (8.5e-5, 0.03),
    "decay_time_temperature_coefficient_per_K": (-3e-3, 0.2),
    "thermal_lag_s": (600.0, 0.15),
    "amplitude_loop_rad_s": (6.0, 0.25),
    "quadrature_loop_rad_s": (6.0, 0.25),
    "phase_loop_rad_s": (200.0, 0.25),
}
"""Middle and relative half width of the range that a value is drawn from (chosen)."""
EXACT = {
    "coriolis_factor": 0.277,
    "control_period_s": 1e-3,
    "amplitude": 1.0,
    "reference_temperature_degC": 25.0,
}
AXES = ("damping_axis_deg", "stiffness_axis_deg")
DIGITS = 3
"""Significant digits of a nominal value."""


def draw_nominal(generator: np.random.Generator) -> dict[str, float]:
    """A campaign's `nominal`, by the campaign format's keys."""
    drawn = {
        key: float(f"{middle * (1 + spread * generator.uniform(-1, 1)):.{DIGITS}g}")
        for key, (middle, spread) in TYPICAL_VALUES.items()
    }
    axes = {key: round(generator.uniform(0, 90), 1) for key in AXES}
    return {**drawn, **axes, **EXACT}


def draw_site(generator: np.random.Generator) -> Site:
    """A laboratory at middle latitudes."""
    return Site(latitude=round(generator.uniform(30, 50), 2) * DEG)
