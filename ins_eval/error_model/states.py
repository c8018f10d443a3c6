"""States of the linear error model, by name and place.

Ten of them: those of `TrackError` (computed less true; position in metres at the true place;
attitude as the rotation vector that turns the true axes into the computed ones), and the integral
of a baro-damped height loop. What the sensors do wrong comes in as inputs (`effects`).
"""

NAMES = (
    "position north",
    "position east",
    "position down",
    "velocity north",
    "velocity east",
    "velocity down",
    "attitude north",
    "attitude east",
    "attitude down",
    "height integral",
)
UNITS = ("m",) * 3 + ("m/s",) * 3 + ("rad",) * 3 + ("m s",)
POSITION, VELOCITY, ATTITUDE = slice(0, 3), slice(3, 6), slice(6, 9)
HEIGHT_INTEGRAL = 9
COUNT = len(NAMES)
