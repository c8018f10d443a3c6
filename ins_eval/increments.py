"""What an IMU hands over."""

from pyhrg.imu_records.increments import Increments

__all__ = ["Increments"]
