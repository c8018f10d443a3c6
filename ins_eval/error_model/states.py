"""The ten states of the linear error model: names, units and places in the state vector.

Nine are the errors of `TrackError`: computed less true, position in metres at the true place,
attitude as the rotation vector that turns the true axes into the computed ones. The tenth is the
integral of the baro-damped height loop. Sensor errors are inputs (`effects`).
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
POSITION, VELOCITY, ATTITUDE = slice(0, 3), slice(3, 6), slice(6, 9)
HEIGHT_INTEGRAL = 9
COUNT = len(NAMES)
