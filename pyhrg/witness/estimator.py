"""Parameters of the estimator in a gyro's electronics, `HRG.Controls.MapEstimator`
(docs/methods/witness.md, Eqs. 12 and 13)."""

from collections.abc import Iterable

import numpy as np

from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import TERMS
from pyhrg.witness.information import compute_maps_response, factor_covariance
from pyhrg.witness.mechanisms import ALONG, STEADY, TEMPERATURE_RATE
from pyhrg.witness.prior import Prior
from pyhrg.witness.responses import Responses, measure_channels, measure_responses

STATES = 9
"""Number of the estimator's states."""
ROW = 5.0
"""Length of the estimator's rows, s."""
PLACES = np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 0, 3), (0, 0, 4), (1, 0, 3), (1, 0, 4),
                   (0, 1, 3), (0, 1, 4), (0, 1, 7), (0, 1, 8), (0, 3, 0), (0, 3, 3), (0, 3, 4),
                   (0, 3, 7), (0, 3, 8)]).T  # fmt: skip
"""(3, 16) places of the estimator's first terms among powers of the temperature, motions, and terms
over the pattern angle. The states change their coefficients."""
VIRTUAL = (0, 3, 0)
"""Place of the virtual rotation, whose product with the rate of the temperature is the next term;
the states change its coefficient as well."""
SECOND_ORDER = np.array([(0, 4, 0), (1, 1, 3), (1, 1, 4), (1, 3, 0), (1, 3, 3), (1, 3, 4)]).T
"""(3, 6) places of the other terms."""
CORRECTED = [0, 3, 4]
"""Places of the map's mean and fourth harmonic among the terms over the pattern angle."""
WARMTH, RATE, HEATING = 10.0, 2 * DEG, 0.03
"""Temperature above the reference, K, rate, rad/s, and rate of the temperature, K/s, at which
directions of the prior are ranked by the force that they make. Chosen."""


def prepare_estimator(device: Device, prior: Prior) -> dict[str, float]:
    """Prepare the estimator in a gyro's electronics: parameters of the FMU `HRGSelfCorrecting`.

    They belong into `Device.model`. The estimator knows no specific force: what acts by that along
    the input axis is taken as that of 1 g, what acts by that across it is left out.

    Args:
        device: the gyro as it was calibrated.
        prior: distribution of the changes since then (`make_drift_prior`).

    Returns:
        Values by the FMU's names, SI.

    Raises:
        HrgError: the device has no angle random walk, by which forces are weighed.
    """
    if not device.angle_random_walk:
        raise HrgError(
            "angle_random_walk: found 0, expected the gyro's own, which weighs its forces"
        )
    fmu = GyroFmu(build_fmu("HRGSlow"))
    (channels,) = measure_channels(fmu, [device])
    return arrange_parameters(device, prior, channels[0], measure_responses(fmu, device))


def arrange_parameters(
    device: Device, prior: Prior, force: Array, responses: Responses
) -> dict[str, float]:
    """The parameters, from coefficients of the calibrated gyro's amplitude force (POWERS, MOTIONS,
    TERMS) and the sensitivities."""
    acting = np.where(STEADY, 1.0, np.where(ALONG, STANDARD_GRAVITY, 0.0))
    steady = acting * responses.forces[:, 0][:, *PLACES].T
    heated = np.where(TEMPERATURE_RATE, responses.forces[:, 0][:, *VIRTUAL], 0.0)
    sensitivity = np.vstack([steady, heated])
    response = compute_maps_response(responses, 0.0)[:TERMS][CORRECTED]
    directions = rank_directions(sensitivity @ factor_covariance(prior.covariance))
    states = factor_covariance(prior.covariance) @ directions[:STATES].T
    per_kelvin = device.frequency * device.frequency_per_kelvin
    expected = np.concatenate([force[*PLACES], [0.0], force[*SECOND_ORDER]])
    expected[: len(sensitivity)] += sensitivity @ prior.mean
    values: dict[str, Iterable[float]] = {
        "expected": expected,
        "sensitivity": (sensitivity @ states).ravel(),
        "ageing": response @ prior.mean,
        "map": (response @ states).ravel(),
        "splitWarmth": _find_split_warmth(device, per_kelvin),
    }
    parameters = {
        "noise": responses.noise[0] / np.sqrt(ROW),
        "temperaturePerFrequency": 1 / per_kelvin if per_kelvin else 0.0,
        "thermalLag": device.thermal_lag,
    }
    for name, vector in values.items():
        parameters |= {f"{name}[{place}]": value for place, value in enumerate(vector, 1)}
    return {f"controller.estimator.{name}": float(value) for name, value in parameters.items()}


def rank_directions(coefficients: Array) -> Array:
    """(COUNT, COUNT) orthonormal directions among standard normal variables, in rows: those that
    make most of the force first.

    coefficients: (terms, COUNT) of the force per unit of each variable.
    """
    sizes = WARMTH ** PLACES[0] * np.where(PLACES[1] > 0, RATE, 1.0)
    sizes = np.append(sizes, RATE * HEATING)
    return np.linalg.svd(sizes[:, None] * coefficients)[2]


def _find_split_warmth(device: Device, per_kelvin: float) -> Array:
    """(2,) cosine and sine of four pattern angles in the temperature that is read off the loop
    frequency, K: the frequency follows the split, -(dw/2) cos 4 (th - th_w)."""
    axis = 4 * device.stiffness_axis
    split = -device.frequency_split / 2 * np.array([np.cos(axis), np.sin(axis)])
    return split / per_kelvin if per_kelvin else np.zeros(2)
