"""Where an effect of the catalogue shows, for when the catalogue has it no more."""

WAVE = frozenset({"wave_angle"})
RATE = frozenset({"rate"})
TEMPERATURE = frozenset({"temperature", "wave_angle"})
ACCELERATION = frozenset({"acceleration"})
NOISE = frozenset({"noise"})

COORDINATES = {
    "damping_anisotropy": WAVE,
    "frequency_split": WAVE,
    "pickoff_gain_mismatch": WAVE,
    "pickoff_nonorthogonality": WAVE,
    "drive_gain_mismatch": WAVE,
    "drive_nonorthogonality": WAVE,
    "drive_frame_rotation": frozenset({"time"}),
    "demodulation_phase_error": WAVE | RATE,
    "differential_phase_error": WAVE,
    "residual_quadrature": WAVE,
    "demodulation_offset": WAVE,
    "pickoff_cubic_nonlinearity": WAVE | {"amplitude"},
    "duffing_stiffness": frozenset({"amplitude"}),
    "drive_feedthrough": WAVE | {"amplitude"},
    "loop_delay": RATE,
    "coriolis_factor_error": RATE,
    "virtual_rotation_gain": RATE,
    "damping_anisotropy_temperature": TEMPERATURE,
    "decay_time_temperature": TEMPERATURE,
    "phase_temperature": TEMPERATURE,
    "pickoff_gain_temperature": TEMPERATURE,
    "temperature_rate_bias": frozenset({"temperature_rate"}),
    "g_sensitive_bias": ACCELERATION,
    "g_sensitive_gain": ACCELERATION,
    "input_axis_misalignment": frozenset({"table_angle"}),
    "angle_random_walk": NOISE,
    "rate_random_walk": NOISE | {"time"},
    "bias_instability": NOISE | {"time"},
    "angle_white_noise": NOISE,
    "angle_quantisation": NOISE,
}
"""Coordinates in which the greatest share of its gap may lie, as the campaign format calls them."""
