"""Units that are not SI, as factors: `value * DEG_PER_H` is SI, `value / DEG_PER_H` leaves SI."""

import math

# Angles, rad
DEG = math.pi / 180
ARCSEC = DEG / 3600

# Times, s; the year is the Julian year of 365.25 days
MINUTE = 60.0
HOUR = 3600.0
YEAR = 8766 * HOUR

# Angular rates, rad/s; angle random walk, rad/sqrt(s)
DEG_PER_H = DEG / HOUR
DEG_PER_SQRT_H = DEG / math.sqrt(HOUR)
HZ = 2 * math.pi

# Lengths, m; accelerations, m/s^2; ratios
NAUTICAL_MILE = 1852.0
STANDARD_GRAVITY = 9.80665
MICRO_G = 9.80665e-6
PPM = 1e-6

# The one offset, not a factor: 0 degrees Celsius in K
ZERO_CELSIUS = 273.15
