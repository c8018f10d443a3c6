"""A gyro with its maker's maps: parked by them, and corrected by them."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.imu.gyros import GyroFlight, case_force, flown, starting_up
from ins_eval.parking.angle import flattest, least_bias
from ins_eval.parking.case import Known, Start
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration import applied, measurements
from pyhrg.bench.calibration.calibration_maps import angle_map, calibration
from pyhrg.bench.estimation.harmonics import design
from pyhrg.device.device import AngleMap, Device

Array = NDArray[np.float64]

ANGLES = {Start.ZERO: least_bias, Start.FLAT: flattest}


@dataclass(frozen=True)
class MappedGyro:
    """A gyro on the bench, the map that its maker measured, and the same gyro with all that he
    measured in its electronics."""

    bench: Bench
    bias_map: AngleMap
    calibrated: Device

    def bias(self, pattern_angle: Array) -> Array:
        """Of the map, rad/s, at pattern angles, rad."""
        columns = design(pattern_angle, pattern_angle, (2, 4, 8), tilt=False)
        return np.asarray(sum(getattr(self.bias_map, name) * c for name, c in columns.items()))

    def known_bias(self, known: Known, pattern_angle: float) -> float:
        """What is to be taken out of the output, rad/s."""
        if known is Known.MAP:
            return 0.0
        if known is Known.MEAN:
            return self.bias_map.mean
        return float(self.bias(np.array(pattern_angle)))

    def flight(self, truth: Increments, axis: int, start: Start, with_maps: bool) -> GyroFlight:
        """From power-on; the same noise each time.

        Args:
            truth: true increments.
            axis: of the body, along which the gyro is mounted.
            start: where the pattern starts, as well as power-on angles repeat.
            with_maps: whether the electronics have the maps.
        """
        device = self.calibrated if with_maps else self.bench.device
        if start in ANGLES:
            device = replace(device, power_on_angle=ANGLES[start](self.bias))
        bench = replace(self.bench, device=starting_up(device))
        force = case_force(truth, np.eye(3)[axis])
        return flown(bench, truth.rotation[:, axis], force, truth.interval)


def mapped(bench: Bench, plan: Plan | None = None) -> MappedGyro:
    """The maker's calibration, power-ons apart: positions, 100 s each, and turns both ways.

    Args:
        bench: with the gyro on it.
        plan: of the positions; the 24 of the bench's full-circumference test, if None.
    """
    power_ons = measurements(bench, plan, runs=1, segments=1)
    found = calibration(bench.campaign([bench.log(task) for task in power_ons]))
    return MappedGyro(bench, angle_map(found.bias_map), applied(bench.device, found))
