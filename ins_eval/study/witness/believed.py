"""A gyro as a study's bench knows it: measured with an error, and with zero for what no bench
measures."""

from dataclasses import dataclass

import numpy as np

from ins_eval.study.gyros.drawn_triad import TriadDistribution
from ins_eval.study.gyros.witness_prior import (
    compute_bench_covariance,
    forget_unmeasured,
    make_study_prior,
)
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.information import factor_covariance
from pyhrg.witness.mechanisms import COUNT, change_device
from pyhrg.witness.prior import Prior
from pyhrg.witness.responses import Responses, measure_responses


@dataclass(frozen=True)
class BelievedGyro:
    """Knowledge of a gyro before its flight.

    Attributes:
        device: the gyro that the bench measured.
        responses: responses of that device.
        prior: prior of the changes from that device to the gyro in flight.
    """

    device: Device
    responses: Responses
    prior: Prior


def believe_gyro(
    fmu: GyroFmu, device: Device, distribution: TriadDistribution, generator: np.random.Generator
) -> BelievedGyro:
    """A calibrated gyro and an error of the bench, which is drawn.

    The error is normal, with the covariance that the bench's records leave (Eq. 3).

    fmu: `HRGSlow`.
    """
    population, plan = distribution.population, distribution.bench
    left = compute_bench_covariance(measure_responses(fmu, device), device, population, plan)
    error = factor_covariance(left) @ generator.standard_normal(COUNT)
    believed = change_device(forget_unmeasured(device), error)
    responses = measure_responses(fmu, believed)
    prior = make_study_prior(responses, believed, population, plan, distribution.drift)
    return BelievedGyro(believed, responses, prior)
