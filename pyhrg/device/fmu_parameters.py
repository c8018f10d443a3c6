"""From the parameters of a gyro to those of the FMU."""

from pyhrg.device.declarations import read_declarations
from pyhrg.device.parameters.loops_and_bench import LoopAndBenchParameters

FMU_FIELDS = {
    name: field
    for field, declaration in read_declarations(LoopAndBenchParameters).items()
    for name in declaration.fmu
}
"""Fields by the FMU's parameters and inputs that take them as they stand."""

LOOP_FREQUENCIES = frozenset(n for n in FMU_FIELDS if n.endswith("Loop.naturalFrequency"))
"""Parameters of the FMU that a gyro with quasi-steady loops (`HRGSlow`) does not have."""


def compute_fmu_values(parameters: LoopAndBenchParameters) -> dict[str, float]:
    """Values of the FMU's parameters by name, SI: those taken as they stand and those computed."""
    direct = {name: getattr(parameters, field) for name, field in FMU_FIELDS.items()}
    return {**direct, **_compute_derived_values(parameters)}


def _compute_derived_values(p: LoopAndBenchParameters) -> dict[str, float]:
    """Values of the parameters that the FMU defines otherwise.

    A force frame turned by e gives the bias -e/(2 k tau). A noise of n in each displacement turns
    the pattern by n/2 and the output by n/2k; the FMU has it per root of its bandwidth.
    """
    k = p.bryan_factor
    rotation_per_bias = -2 * k * p.decay_time
    displacement_noise = 2 * k * p.angle_white_noise
    return {
        "resonator.material.bryanFactor": k * (1 + p.bryan_factor_error),
        "drive.rotationPerTemperatureRate": rotation_per_bias * p.bias_per_temperature_rate,
        "drive.rotationPerAcceleration[3]": rotation_per_bias * p.bias_per_acceleration,
        "noise.pickOff": displacement_noise * p.control_period**0.5,
    }
