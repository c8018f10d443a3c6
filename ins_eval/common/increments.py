"""What an IMU hands over."""

from pyhrg.records.imu.increments import Increments

__all__ = ["Increments"]
