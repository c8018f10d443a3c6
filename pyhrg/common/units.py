"""Units that are not SI, as factors: `value * DEG_PER_H` is SI, `value / DEG_PER_H` leaves SI."""

import math

DEG = math.pi / 180
ARCSEC = DEG / 3600
MINUTE = 60.0
HOUR = 3600.0
YEAR = 8766 * HOUR
DEG_PER_H = DEG / HOUR
DEG_PER_SQRT_H = DEG / math.sqrt(HOUR)
HZ = 2 * math.pi
PPM = 1e-6
ZERO_CELSIUS = 273.15
NAUTICAL_MILE = 1852.0
STANDARD_GRAVITY = 9.80665
MICRO_G = 9.80665e-6
