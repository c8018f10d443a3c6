"""A system of FMUs flies as `ins_eval.fly` does: largest difference of the position.

python -m benchmarks.system [HOURS] [RATE_HZ]
"""

import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import ins_eval
from ins_eval.common.state import position_error
from tests.ins_eval.system.masters import run_ssp

IMU = """\
[gyros]
device = "typical"
[gyros.mounting]
error_sigma_arcsec = 20
[accelerometers]
bias_sigma_micro_g = 5
scale_factor_sigma_ppm = 20
misalignment_sigma_arcsec = 5
"""
"""The accelerometers have no noise: that of their FMU is another one than that of `fly`."""
MISSION = "weaving"


def compare(hours: float, rate_hz: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        imu, path = Path(folder) / "imu.toml", Path(folder) / "system.ssp"
        imu.write_text(IMU)
        given = {"hours": hours, "rate_hz": rate_hz, "seed": 1}
        flight = ins_eval.fly(MISSION, str(imu), align_s=None, **given).dataset.isel(time=-1, run=0)
        ins_eval.write_system(path, MISSION, imu, **given)
        print(f"{MISSION}, {hours:g} h, {rate_hz} Hz, {path.stat().st_size / 1e6:.1f} MB")
        print(f"error of the flight {float(flight.radial_error):.6g} m")
        flown = [np.deg2rad(flight.latitude), np.deg2rad(flight.longitude), flight.height]
        for importer in ("libcosimpy", "ecos"):
            begin = time.perf_counter()
            found = run_ssp(importer, path, 1 / rate_hz, round(float(flight.time) * rate_hz) + 1)
            place = np.array([found["latitude"], found["longitude"], found["height"]])
            apart = np.abs(position_error(place, np.array(flown, dtype=float)))
            print(
                f"{importer}: {1e3 * np.max(apart):.3g} mm apart at {found['navigationTime']:g} s, "
                f"valid {found['valid']:g}, {time.perf_counter() - begin:.0f} s",
                flush=True,
            )


if __name__ == "__main__":
    hours = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0
    compare(hours, int(sys.argv[2]) if len(sys.argv) > 2 else 100)
