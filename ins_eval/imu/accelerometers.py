"""Three accelerometers."""

from ins_eval.imu.triad import Constant, Triad
from pyhrg.common.units import MICRO_G

TYPICAL_ACCELEROMETERS = Triad(bias=Constant(deviation=5 * MICRO_G), white=5 * MICRO_G)
"""Good enough that a gyro bias of 0.001 deg/h can still be seen in the position error."""
