"""The maker's calibration of a gyro, from noisy tests in one power-on."""

from typing import Literal, get_args

import numpy as np

from ins_eval.mission_model.gyro_map import HARMONICS, NAMES
from ins_eval.study.gyros.bench_maps import fit_bias_maps, fit_scale_maps
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan, record_campaign
from pyhrg.bench.calibration.calibration_maps import add_maps
from pyhrg.common.arrays import Array
from pyhrg.device.device import AngleMap, Device
from pyhrg.fmu import GyroFmu

Method = Literal["mean", "map"]
METHODS: tuple[Method, ...] = get_args(Method)
"""What is calibrated: the means of bias and scale factor, or their whole maps."""


def calibrate_gyro(
    fmu: GyroFmu, device: Device, method: Method, seed: int, plan: BenchPlan = CALIBRATION
) -> Device:
    """The gyro whose electronics correct what the maker's tests measured.

    Args:
        fmu: `HRGSlow`.
        seed: seed of the tests' noise, from 0.
    """
    tests = record_campaign(fmu, device, plan, seed, fixed=False)
    scale = fit_scale_maps(tests).mean(axis=0)
    bias = fit_bias_maps(tests, scale).mean(axis=0)
    scale_factor = float(scale[0])
    if method == "mean":
        return add_maps(device, AngleMap(mean=float(bias[0])), AngleMap(), scale_factor)
    angle = _convert_to_angle_errors(scale)
    return add_maps(device, _make_angle_map(bias), _make_angle_map(angle), scale_factor)


def _convert_to_angle_errors(scale: Array) -> Array:
    """(TERMS,) errors of the detected pattern angle, rad, that make a scale factor's harmonics
    (paper, Eqs. 2 and 3): c cos h th + s sin h th of the scale factor come from
    (c sin h th - s cos h th)/h of the angle."""
    errors = np.zeros_like(scale)
    orders = np.array(HARMONICS, dtype=float)
    errors[1::2], errors[2::2] = -scale[2::2] / orders, scale[1::2] / orders
    return errors


def _make_angle_map(coefficients: Array) -> AngleMap:
    """The part of a map that the electronics can correct: all but the sixth harmonic."""
    named = dict(zip(NAMES, coefficients.tolist(), strict=True))
    return AngleMap(**{name: named[name] for name in vars(AngleMap())})
