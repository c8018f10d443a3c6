"""An IMU as linear models see it: standard deviations and densities of its errors."""

from dataclasses import dataclass


@dataclass(frozen=True)
class SensorErrors:
    """The same for each of three axes; SI. Terms of IEEE Std 528.

    gyro_bias: rad/s; angle_random_walk: rad/sqrt(s); gyro_bias_instability: rad/s;
    accelerometer_bias: m/s^2; velocity_random_walk: m/s/sqrt(s);
    accelerometer_bias_instability: m/s^2; angle_quantum: rad; velocity_quantum: m/s, one count of
    the increments.
    """

    gyro_bias: float = 0.0
    angle_random_walk: float = 0.0
    gyro_bias_instability: float = 0.0
    accelerometer_bias: float = 0.0
    velocity_random_walk: float = 0.0
    accelerometer_bias_instability: float = 0.0
    angle_quantum: float = 0.0
    velocity_quantum: float = 0.0
