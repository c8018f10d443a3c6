"""A gyro with its maker's maps: parked by them, and corrected by them, in the cases that are
compared.

A pattern is parked at an angle where a bias map leaves least error while the pattern creeps. A
level gyro's pattern creeps by the rotation that the gyro measures: Earth's rate, the vehicle's
curvature, pitch and roll. The heading is not known at power-on, so the map counts within that reach
to both sides.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from ins_eval.imu.gyros import GyroOutput, resolve_force_in_case, simulate_together, with_start_up
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration import apply_maps, calibrate_once
from pyhrg.bench.calibration.calibration_maps import make_angle_map
from pyhrg.bench.estimation.harmonics import make_columns
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import AngleMap, Device
from pyhrg.records.imu.log import Increments


class Start(Enum):
    """Pattern angle of the level gyros at power-on."""

    AS_IT_COMES = "each gyro's own angle, of any value"
    ZERO = "parked where the map crosses its mean"
    FLAT = "parked where the map is flattest"


class Known(Enum):
    """Part of the error map that is known and taken out of the output."""

    MEAN = "the map's mean"
    AT_START = "of level gyros the map's value where the pattern stands when alignment begins"
    MAP = "bias and scale-factor maps of all gyros, by their electronics"


@dataclass(frozen=True)
class Case:
    """What is compared: where the level gyros' patterns start, and what is taken out of the
    outputs. The vertical gyro starts at its own angle in all cases.

    Attributes:
        name: name in files.
        label: name in reports.
        start: start angle of the level gyros' patterns.
        known: what is taken out of the output.
    """

    name: str
    label: str
    start: Start
    known: Known


TODAY = Case("random_mean", "any angle, mean bias taken out", Start.AS_IT_COMES, Known.MEAN)
LIMIT = Case("map", "any angle, whole maps taken out", Start.AS_IT_COMES, Known.MAP)
CASES = (
    TODAY,
    Case(
        "random_at_start",
        "any angle, bias there taken out",
        Start.AS_IT_COMES,
        Known.AT_START,
    ),
    Case("zero_mean", "parked at a zero, mean bias taken out", Start.ZERO, Known.MEAN),
    Case("flat_at_start", "parked at an extreme, bias there taken out", Start.FLAT, Known.AT_START),
    LIMIT,
)
"""All cases; the others are compared with the first."""


BiasMap = Callable[[Array], Array]
"""Bias, rad/s, at pattern angles (...), rad; of period pi."""

REACH = 6.0 * DEG
"""Half width of the pattern angles about the parked one that count, rad. Chosen: Earth's level rate
turns the pattern by up to 6.4 deg in 2 h at latitude 40 deg, and 2 deg of pitch by 0.6 deg. Turns
with roll add to that, always one way."""
_CANDIDATES = np.arange(0.0, 180.0, 0.1) * DEG
_WITHIN = np.linspace(-REACH, REACH, 25)


def find_flattest_zero(bias: BiasMap) -> float:
    """Angle, rad, about which the bias differs least from its mean, for a gyro whose mean bias is
    calibrated: the map's flattest zero."""
    mean = float(np.mean(bias(_CANDIDATES)))
    return _find_least(bias(_within_reach()) - mean)


def find_flattest_extreme(bias: BiasMap) -> float:
    """Angle, rad, about which the bias varies least from its own value, for a gyro whose bias there
    is calibrated: the map's flattest extreme."""
    return _find_least(bias(_within_reach()) - bias(_CANDIDATES)[:, None])


def _within_reach() -> Array:
    return np.asarray(_CANDIDATES[:, None] + _WITHIN)


def _find_least(residual: Array) -> float:
    return float(_CANDIDATES[np.argmin(np.mean(residual**2, axis=1))])


ANGLES = {Start.ZERO: find_flattest_zero, Start.FLAT: find_flattest_extreme}


@dataclass(frozen=True)
class MappedGyro:
    """A gyro with its maker's maps.

    Attributes:
        bench: the bench that the gyro is on.
        bias_map: bias map that the maker measured.
        calibrated: the gyro with the measured maps in its electronics.
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

    def set_up(self, start: float | None, with_maps: bool) -> Bench:
        """The gyro as it is flown, with the same noise each time.

        start: angle at which the pattern starts as well as power-on angles repeat, rad; None is the
        gyro's own.
        """
        device = self.calibrated if with_maps else self.bench.device
        if start is not None:
            device = replace(device, power_on_angle=start)
        return replace(self.bench, device=with_start_up(device))


def fly_together(
    benches: Sequence[Bench], axes: Sequence[int], truth: Increments
) -> list[GyroOutput]:
    """Outputs from power-on of gyros that are mounted along these axes of the body."""
    forces = [resolve_force_in_case(truth, np.eye(3)[axis]) for axis in axes]
    return simulate_together(benches, truth.rotation[:, axes], forces, truth.interval)


def measure_maps(bench: Bench, plan: Plan | None = None) -> MappedGyro:
    """The maker's calibration, power-ons apart: positions (the 24 of the bench's full-circumference
    test by default), 100 s each, and turns both ways."""
    calibration = calibrate_once(bench, plan)
    return MappedGyro(
        bench, make_angle_map(calibration.bias_map), apply_maps(bench.device, calibration)
    )
