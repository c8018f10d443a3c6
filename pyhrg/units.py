"""Units that are not SI, as factors: `value * DEG_PER_H` is SI, `value / DEG_PER_H` leaves SI."""

import math

DEG = math.pi / 180
ARCSEC = DEG / 3600
HOUR = 3600.0
DEG_PER_H = DEG / HOUR
DEG_PER_SQRT_H = DEG / math.sqrt(HOUR)
NAUTICAL_MILE = 1852.0
MICRO_G = 9.80665e-6
EARTH_RATE = 7.292115e-5
"""Earth's rotation rate, rad/s (WGS-84)."""
