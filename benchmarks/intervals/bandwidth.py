"""Delay and gain of a gyro without anisotropy: none, and 1 less the pull of held forces."""

from pyhrg.bench.bench import Bench
from pyhrg.bench.dynamic import bandwidth
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRG"


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth and interval of the delay, and of the gain at both ends."""
    bench = Bench(fmu, TYPICAL.without_anisotropy(), seed)
    outcome = bandwidth.evaluate(bench.campaign(bandwidth.record(bench, periods=8)))
    _, delay, low, high = outcome.findings
    gain = 1 + theory.hold_scale_factor_error(bandwidth.INTERVAL, 0.0, TYPICAL.decay_time)
    return {
        "delay": (0.0, delay.si_low, delay.si_high),
        low.name: (gain, low.si_low, low.si_high),
        high.name: (gain, high.si_low, high.si_high),
    }
