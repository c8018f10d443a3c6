"""How a maker calibrates a gyro, from noisy tests of one power-on."""

from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import HARMONICS, NAMES, GyroMap
from ins_eval.study.gyros.bench_maps import bias_maps, scale_maps
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan, campaign
from pyhrg.bench.calibration.calibration_maps import calibrated
from pyhrg.device.device import AngleMap, Device
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

Method = Literal["mean", "map"]
METHODS: tuple[Method, ...] = get_args(Method)
"""Mean bias and scale factor only; or the whole maps of both."""


def calibrated_gyro(
    fmu: GyroFmu, device: Device, method: Method, seed: int, plan: BenchPlan = CALIBRATION
) -> Device:
    """The gyro with what the maker found in its electronics.

    Args:
        fmu: `HRGSlow`.
        device: as it is built.
        method: one of `METHODS`.
        seed: of the tests' noise, from 0.
        plan: of the tests.
    """
    tests = campaign(fmu, device, plan, seed, fixed=False)
    scale = scale_maps(tests).mean(axis=0)
    found = GyroMap(bias_maps(tests, scale).mean(axis=0), scale)
    return corrected(device, found, method)


def corrected(device: Device, found: GyroMap, method: Method) -> Device:
    """The gyro whose electronics take out a map, or its means only."""
    scale_factor = float(found.scale[0])
    if method == "mean":
        return calibrated(device, AngleMap(mean=float(found.bias[0])), AngleMap(), scale_factor)
    angle = _angle_errors(found.scale)
    return calibrated(device, _angle_map(found.bias), _angle_map(angle), scale_factor)


def _angle_errors(scale: Array) -> Array:
    """Of the detected pattern angle, rad, that make a scale factor's harmonics (paper, Eqs. 2
    and 3): c cos h th + s sin h th of it are (c sin h th - s cos h th)/h of the angle."""
    errors = np.zeros_like(scale)
    orders = np.array(HARMONICS, dtype=float)
    errors[1::2], errors[2::2] = -scale[2::2] / orders, scale[1::2] / orders
    return errors


def _angle_map(coefficients: Array) -> AngleMap:
    """What the electronics can hold of a map: the sixth harmonic stays in flight."""
    named = dict(zip(NAMES, coefficients.tolist(), strict=True))
    return AngleMap(**{name: named[name] for name in vars(AngleMap())})
