"""Noise terms of gyros and of accelerometers (IEEE Std 952): names and units."""

from collections.abc import Mapping
from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR, MICRO_G

UNITS = {
    **{"arcsec": "arcsec", "deg_sqrt_h": "deg/sqrt(h)", "deg_h": "deg/h", "m_s": "m/s"},
    **{"deg_h_sqrt_h": "deg/h/sqrt(h)", "deg_h_h": "deg/h/h", "m_s_sqrt_h": "m/s/sqrt(h)"},
    **{"micro_g": "micro-g", "micro_g_sqrt_h": "micro-g/sqrt(h)", "micro_g_h": "micro-g/h"},
}
"""Units of noise terms by the ends of their keys."""


@dataclass(frozen=True)
class Term:
    """A noise term. Files state its level under the key `parameter`; times `factor` it is in SI."""

    effect: str
    parameter: str
    factor: float

    @property
    def unit(self) -> str:
        """Unit of the parameter, which ends the key."""
        return UNITS[self.parameter.removeprefix(f"{self.effect}_")]


@dataclass(frozen=True)
class Kind:
    """A kind of sensor.

    name: start of its channels' names.
    table: its table in a file of beliefs.
    terms: white noise, random walk, flicker and random walk of the rate, as they appear in the
        integrated readings; in the order of `pyhrg.noise.likelihood.POWERS`.
    ramp: constant change of the bias with time.
    temperature_term: change of the bias with temperature.
    quantization: step of the integrated readings.
    rate_unit, rate_scale: unit of the readings as rates, and its value in SI.
    """

    name: str
    table: str
    terms: tuple[Term, Term, Term, Term]
    ramp: Term
    temperature_term: Term
    quantization: Term
    rate_unit: str
    rate_scale: float

    @property
    def by_parameter(self) -> Mapping[str, Term]:
        """Terms that a file of beliefs may state, by key."""
        return {term.parameter: term for term in (*self.terms, self.ramp, self.quantization)}


GYRO = Kind(
    name="gyro",
    table="gyros",
    terms=(
        Term("angle_white_noise", "angle_white_noise_arcsec", ARCSEC),
        Term("angle_random_walk", "angle_random_walk_deg_sqrt_h", DEG_PER_SQRT_H),
        Term("bias_instability", "bias_instability_deg_h", DEG_PER_H),
        Term("rate_random_walk", "rate_random_walk_deg_h_sqrt_h", DEG_PER_H / HOUR**0.5),
    ),
    ramp=Term("rate_ramp", "rate_ramp_deg_h_h", DEG_PER_H / HOUR),
    temperature_term=Term("bias_temperature", "bias_deg_h_per_K", DEG_PER_H),
    quantization=Term("angle_quantisation", "quantum_arcsec", ARCSEC),
    rate_unit="deg/h",
    rate_scale=DEG_PER_H,
)
ACCELEROMETER = Kind(
    name="accelerometer",
    table="accelerometers",
    terms=(
        Term("velocity_white_noise", "velocity_white_noise_m_s", 1.0),
        Term("velocity_random_walk", "velocity_random_walk_m_s_sqrt_h", HOUR**-0.5),
        Term("bias_instability", "bias_instability_micro_g", MICRO_G),
        Term(
            *("acceleration_random_walk", "acceleration_random_walk_micro_g_sqrt_h"),
            MICRO_G / HOUR**0.5,
        ),
    ),
    ramp=Term("acceleration_ramp", "acceleration_ramp_micro_g_h", MICRO_G / HOUR),
    temperature_term=Term("bias_temperature", "bias_micro_g_per_K", MICRO_G),
    quantization=Term("velocity_quantisation", "quantum_m_s", 1.0),
    rate_unit="micro-g",
    rate_scale=MICRO_G,
)
KINDS = (GYRO, ACCELEROMETER)
