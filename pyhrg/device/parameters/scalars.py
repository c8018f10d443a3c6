"""All parameters of a gyro that are one number each."""

from dataclasses import dataclass

from pyhrg.device.parameters.electrodes import DriveParameters, PickoffParameters
from pyhrg.device.parameters.electronics import ElectronicsParameters
from pyhrg.device.parameters.installation import InstallationParameters
from pyhrg.device.parameters.laboratory import LaboratoryParameters
from pyhrg.device.parameters.noise import NoiseParameters
from pyhrg.device.parameters.resonator import ResonatorParameters


@dataclass(frozen=True)
class ScalarParameters(
    LaboratoryParameters,
    InstallationParameters,
    NoiseParameters,
    ElectronicsParameters,
    DriveParameters,
    PickoffParameters,
    ResonatorParameters,
):
    """The parts together. A dataclass takes the fields of its last base first: the resonator's."""
