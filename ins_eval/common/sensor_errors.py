"""Sensor errors of an IMU as standard deviations and noise coefficients, for linear models."""

from dataclasses import dataclass


@dataclass(frozen=True)
class SensorErrors:
    """Errors of each axis, the same for all three; SI units, terms of IEEE Std 528.

    Attributes:
        gyro_bias, accelerometer_bias: standard deviation of the constant bias, rad/s and m/s^2.
        angle_random_walk, velocity_random_walk: coefficient N, rad/sqrt(s) and m/s/sqrt(s).
        gyro_bias_instability, accelerometer_bias_instability: coefficient B, rad/s and m/s^2.
        angle_quantization_step, velocity_quantization_step: one count of the increments, rad and
            m/s.
        gyro_rate_random_walk: coefficient K, rad/s/sqrt(s).
    """

    gyro_bias: float = 0.0
    angle_random_walk: float = 0.0
    gyro_bias_instability: float = 0.0
    accelerometer_bias: float = 0.0
    velocity_random_walk: float = 0.0
    accelerometer_bias_instability: float = 0.0
    angle_quantization_step: float = 0.0
    velocity_quantization_step: float = 0.0
    gyro_rate_random_walk: float = 0.0
