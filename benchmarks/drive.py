"""Cost of a tick: bare C loop, FMI door, compiled driver at 100 Hz, FMPy's own loop; one run.

`python benchmarks/drive.py [SECONDS]` simulates that much gyro time (default 200) each way, three
times in turn, and prints the least cost of each and the ratios.
"""

import contextlib
import io
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import fmpy
import numpy as np

from fmu_build import bundle
from fmu_build.platforms import COMPILER, FLAGS
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL

REPEATS = 3
ROOT = ROOTS["HRG"]


def bare_host(folder: Path) -> Path:
    """The C host, compiled with the FMU's own flags."""
    bundle.write_sources(bundle.translate(bundle.modelica_library(), ROOT.model), folder, 2, ROOT)
    source = Path(__file__).with_name("bare.c")
    (folder / "bare.c").write_bytes(source.read_bytes())
    command = [*COMPILER, *FLAGS, "-D_POSIX_C_SOURCE=199309L", "bare.c", "model.c", "core.c"]
    subprocess.run([*command, "-lm", "-o", "bare"], cwd=folder, check=True, capture_output=True)
    return folder / "bare"


def main(seconds: float) -> None:
    """Measure and print."""
    ticks = round(seconds * 1000)
    path = bundle.built_fmu()
    fmu = GyroFmu(path)
    rates = np.zeros(round(seconds * 100))
    table = np.array([(0.0, 0.0), (seconds, 0.0)], dtype=[("time", float), ("angularRate", float)])

    def bare() -> float:
        return float(subprocess.run([host, str(ticks)], capture_output=True, check=True).stdout)

    def timed(work: object) -> float:
        begin = time.perf_counter()
        work()  # type: ignore[operator]
        return (time.perf_counter() - begin) / ticks

    def door() -> float:
        with fmu.power_on(TYPICAL.fmu_parameters(), 1, 0.2) as gyro:
            return timed(lambda: gyro.advance(0.0, seconds))

    def driver() -> float:
        with fmu.power_on(TYPICAL.fmu_parameters(), 1, 0.2) as gyro:
            gyro.drive(rates[:1], 0.01)
            return timed(lambda: gyro.drive(rates[1:], 0.01))

    def importer() -> float:
        with contextlib.redirect_stdout(io.StringIO()):  # it lists the inputs that stay constant
            return timed(
                lambda: fmpy.simulate_fmu(
                    str(fmu.folder),
                    stop_time=seconds,
                    output_interval=0.01,
                    start_values=TYPICAL.fmu_parameters(),
                    input=table,
                    output=["gyroAngle"],
                )
            )

    ways = {
        "bare C loop": bare,
        "FMI door, one step": door,
        "compiled driver, 100 Hz": driver,
        "fmpy.simulate_fmu, 100 Hz": importer,
    }
    with tempfile.TemporaryDirectory() as name:
        host = bare_host(Path(name))
        best = dict.fromkeys(ways, float("inf"))
        for _ in range(REPEATS):
            for way, measure in ways.items():
                best[way] = min(best[way], measure())
    base = best["bare C loop"]
    for way, cost in best.items():
        print(f"{way:<28}{cost * 1e9:8.0f} ns a tick   {cost / base:6.2f} of the bare loop")
    excess = {way: cost - base for way, cost in best.items()}
    ratio = excess["fmpy.simulate_fmu, 100 Hz"] / max(excess["compiled driver, 100 Hz"], 1e-12)
    print(f"what driving costs beyond the ticks: FMPy's loop over the compiled driver {ratio:.0f}")


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 200.0)
