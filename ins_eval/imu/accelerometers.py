"""Accelerometers that studies use unless told otherwise."""

from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel
from pyhrg.common.units import MICRO_G

TYPICAL_ACCELEROMETERS = SensorErrorModel(
    bias=AxisConstants(deviation=5 * MICRO_G), white=5 * MICRO_G
)
"""Bias 5 micro-g, noise 5 micro-g/sqrt(Hz). Chosen so that a gyro bias of 0.001 deg/h still shows
in the position error."""
