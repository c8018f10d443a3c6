"""What the envelope, an average over a carrier period, leaves out of a gyro that turns fast."""

from dataclasses import replace

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.common.units import ARCSEC, DEG, HZ
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.driving import advance

RATE = 100 * DEG
SETTLING, INSTANTS, STEP = 5.0, 60, 0.05
GYRO = replace(Device(), frequency=6870 * HZ, frequency_split=1e-3 * HZ, stiffness_axis=0.5)
SIGNALS = {
    "quadrature_force": "quadratureForce",
    "amplitude_force": "amplitudeForce",
    "frequency_offset": "frequencyOffset",
}


def turned(model: str, rate: float) -> dict[str, np.ndarray]:
    """(n,) by field of a log, at instants while the gyro turns."""
    fmu = GyroFmu(build_fmu(model))
    rows = []
    with fmu.power_on(GYRO.fmu_parameters(), seed=0, start_angle=0.3) as gyro:
        advance(gyro, rate, SETTLING)
        for _ in range(INSTANTS):
            angle = advance(gyro, rate, STEP)
            rows.append(
                [angle, gyro.read("patternAngle"), *(gyro.read(n) for n in SIGNALS.values())]
            )
    return dict(zip(("gyro_angle", "wave_angle", *SIGNALS), np.array(rows).T, strict=True))


@pytest.mark.parametrize("rate", [RATE, -RATE / 2])
def test_the_carrier_shows_the_next_order(rate: float) -> None:
    """Forces and frequency, to 5 %; the split by way of the amplitude loop."""
    envelope, carrier = turned("HRG", rate), turned("HRGCarrier", rate)
    expected = theory.beyond_the_average(GYRO, np.full(INSTANTS, rate), envelope["wave_angle"])
    for name in SIGNALS:
        beyond = carrier[name] - envelope[name]
        scale = np.max(np.abs(expected[name]))
        assert scale > 0
        assert np.max(np.abs(beyond - expected[name])) < 0.05 * scale, name


def test_the_output_is_the_same_while_the_gyro_turns_fast() -> None:
    """0.1 arcsec after 500 deg: what is demodulated is neither old nor does it ripple."""
    envelope, carrier = turned("HRG", RATE), turned("HRGCarrier", RATE)
    apart = carrier["gyro_angle"] - envelope["gyro_angle"]
    assert np.max(np.abs(apart)) < 0.1 * ARCSEC
    assert np.ptp(apart) < 0.05 * ARCSEC
