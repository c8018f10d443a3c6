"""A laboratory's records of a gyro whose nominal values say nothing of its errors."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import DEG, HZ, PPM
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs

TRUE = {
    "frequency_split_Hz": 4e-4,
    "pickoff_nonorthogonality": 350 * PPM,
    "damping_anisotropy_per_s": 2.4e-6,
    "amplitude_latency_s": 1e-3,
}
BELIEVED = replace(NOMINAL, frequency_split=0.0, damping_anisotropy=0.0)
GYRO = replace(
    BELIEVED,
    frequency_split=TRUE["frequency_split_Hz"] * HZ,
    stiffness_axis=20 * DEG,
    pickoff_nonorthogonality=TRUE["pickoff_nonorthogonality"],
    damping_anisotropy=TRUE["damping_anisotropy_per_s"],
    damping_axis=62 * DEG,
)


def read_otherwise(log: Log) -> Log:
    """The output angle counts from what table and Earth had turned at the first row, as an import
    lets it, and the amplitude is read a control period later."""
    earth = NOMINAL.site.compute_earth_rate(log.axis_up)[0] * log.interval
    origin = log.gyro_angle[0] - log.table_angle[0] - earth
    change = np.diff(log.amplitude, prepend=log.amplitude[0])
    later = log.amplitude + change * TRUE["amplitude_latency_s"] / log.interval
    return replace(log, gyro_angle=log.gyro_angle - origin, amplitude=later)


def test_large_errors_are_found_from_a_nominal_without_any(simulation: Simulation) -> None:
    """The origin was read as a pick-off without errors, the amplitude as a drive feedthrough."""
    campaign = change_logs(recorded(simulation.sampled, GYRO, BELIEVED), read_otherwise)
    found = diagnose(campaign, simulation=simulation).diagnosis
    assert (found.verdict, found.settled, found.terms) == ("explained", True, ())
    sizes = {name: size for cause in found.causes for name, size in cause.parameters.items()}
    for cause in found.causes:
        for name in TRUE.keys() & cause.parameters.keys():
            low, high = cause.interval_95[name]
            slack = (high - low) / 2  # 3.9 sigma
            assert low - slack < TRUE[name] < high + slack
    assert {cause.effect for cause in found.causes} == {
        "frequency_split",
        "pickoff_nonorthogonality",
        "damping_anisotropy",
        "amplitude_latency",
    }
    assert sizes["frequency_split_Hz"] == pytest.approx(TRUE["frequency_split_Hz"], rel=1e-3)
