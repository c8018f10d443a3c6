"""A gyro with its maker's maps: parked by them, and corrected by them."""

from dataclasses import dataclass, replace

import numpy as np

from ins_eval.imu.gyros import GyroOutput, resolve_force_in_case, simulate_gyro, with_start_up
from ins_eval.parking.angle import find_flattest_extreme, find_flattest_zero
from ins_eval.parking.case import Known, Start
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration import apply_maps, plan_power_ons
from pyhrg.bench.calibration.calibration_maps import fit_maps, make_angle_map
from pyhrg.bench.estimation.harmonics import make_columns
from pyhrg.common.arrays import Array
from pyhrg.device.device import AngleMap, Device
from pyhrg.records.imu.increments import Increments

ANGLES = {Start.ZERO: find_flattest_zero, Start.FLAT: find_flattest_extreme}


@dataclass(frozen=True)
class MappedGyro:
    """A gyro with its maker's maps.

    bench: with the gyro on it; bias_map: as the maker measured it; calibrated: the gyro with the
    measured maps in its electronics.
    """

    bench: Bench
    bias_map: AngleMap
    calibrated: Device

    def bias(self, pattern_angle: Array) -> Array:
        """Bias by the map, rad/s, at pattern angles, rad."""
        columns = make_columns(pattern_angle, pattern_angle, (2, 4, 8), tilt=False)
        return np.asarray(sum(getattr(self.bias_map, name) * c for name, c in columns.items()))

    def compute_known_bias(self, known: Known, pattern_angle: float) -> float:
        """Bias that is taken out of the output, rad/s."""
        if known is Known.MAP:
            return 0.0
        if known is Known.MEAN:
            return self.bias_map.mean
        return float(self.bias(np.array(pattern_angle)))

    def flight(self, truth: Increments, axis: int, start: Start, with_maps: bool) -> GyroOutput:
        """Output from power-on, with the same noise each time.

        axis: of the body, along which the gyro is mounted; start: where the pattern starts, as well
        as power-on angles repeat.
        """
        device = self.calibrated if with_maps else self.bench.device
        if start in ANGLES:
            device = replace(device, power_on_angle=ANGLES[start](self.bias))
        bench = replace(self.bench, device=with_start_up(device))
        force = resolve_force_in_case(truth, np.eye(3)[axis])
        return simulate_gyro(bench, truth.rotation[:, axis], force, truth.interval)


def measure_maps(bench: Bench, plan: Plan | None = None) -> MappedGyro:
    """The maker's calibration, power-ons apart: positions (the 24 of the bench's full-circumference
    test by default), 100 s each, and turns both ways."""
    power_ons = plan_power_ons(bench, plan, runs=1, segments=1)
    found = fit_maps(bench.campaign([bench.log(task) for task in power_ons]))
    return MappedGyro(bench, make_angle_map(found.bias_map), apply_maps(bench.device, found))
