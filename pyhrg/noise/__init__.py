"""Noise of a gyro: its coefficients, their likelihood, the Allan deviation.

The vocabulary of the whole project, after IEEE Std 952, annex C; `NoiseCoefficients` has fields of
these names:

| name                | symbol   | unit          | density of the rate | Allan deviation |
|---------------------|----------|---------------|---------------------|-----------------|
| `angle_white_noise` | s        | rad           | (2 pi f)^2 s^2 T    | sqrt(3) s/t     |
| `quantization_step` | 12^0.5 Q | rad           | (2 pi f)^2 Q^2 T    | sqrt(3) Q/t     |
| `angle_random_walk` | N        | rad/sqrt(s)   | N^2                 | N/sqrt(t)       |
| `bias_instability`  | B        | rad/s         | B^2/(2 pi f)        | 0.664 B         |
| `rate_random_walk`  | K        | rad/s/sqrt(s) | K^2/(2 pi f)^2      | K sqrt(t/3)     |
| `rate_ramp`         | R        | rad/s^2       | no noise            | R t/sqrt(2)     |

Densities are two-sided. Here s is the standard deviation of one angle reading, T the sampling
interval and t the cluster time. A quantization step of sqrt(12) Q looks like white noise of the
angle of standard deviation Q. The noise of an accelerometer has the same coefficients, with
`velocity` instead of `angle` and `acceleration` instead of `rate`; a class that serves both sensors
has a `random_walk`. In a noise model of another channel, the channel's unit stands for rad. Flicker
noise is the noise that the bias instability is the coefficient of. The strength of a noise is its
variance per sample, rad^2.
"""
