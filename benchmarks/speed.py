"""What a tick costs, each way of running it, in one run.

`python benchmarks/speed.py [SECONDS]` (default 7200: two hours of gyro time) prints what a tick and
gyro costs of a core, and the ratios that matter: kernel over a hand-written tick, FMI door over the
kernel, three driven gyros over a bare C host, gyros together over one by one, FMPy's own loop, and
HRGSlow over HRG. Each figure is the least of several runs in turn; times are the processor's, which
other programs disturb less than the clock's.
"""

import contextlib
import io
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import fmpy
import numpy as np

from fmu_build.binaries.platforms import COMPILER, FLAGS, PLATFORMS, find_host_platform
from fmu_build.bundle import build_fmu, find_modelica_library, write_sources
from fmu_build.equations.translate import translate
from fmu_build.roots import ROOTS
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu, record_together
from pyhrg.fmu.gyro import Gyro

HERE = Path(__file__).parent
REPEATS = 5
STEP = 0.01
START = 0.6
TICKS = 400_000
"""Of the plain loops."""


def compiled(folder: Path, source: str, *others: str) -> Path:
    """A program of this folder's, for the FMU's target and with its flags."""
    (folder / source).write_bytes((HERE / source).read_bytes())
    program = folder / source.removesuffix(".c")
    target = PLATFORMS[find_host_platform()].target
    command = [
        *COMPILER,
        "-target",
        target,
        *FLAGS,
        "-D_POSIX_C_SOURCE=199309L",
        source,
        *others,
        "-lm",
    ]
    subprocess.run([*command, "-o", program.name], cwd=folder, check=True, capture_output=True)
    return program


def seconds_per_tick(*command: object) -> float:
    """What a program prints first."""
    run = subprocess.run([str(x) for x in command], capture_output=True, check=True, text=True)
    return float(run.stdout.split()[0])


def turn(gyro: Gyro, rates: np.ndarray, step: float) -> np.ndarray:
    """The gyro's angle, rad, at the end of steps of a rate each, rad/s."""
    ends, _ = gyro.record({"angularRate": rates[:, None]}, {}, step, ["gyroAngle"])
    return ends[:, 0]


def check_yardstick(hand: Path, fmu: GyroFmu) -> None:
    """The hand-written tick is a yardstick only while it computes what the FMU does: same bits."""
    anisotropy, walk, ticks = 1e-6, 1e-6, 10_000
    command = [str(x) for x in (hand, ticks, anisotropy, walk)]
    run = subprocess.run(command, capture_output=True, check=True, text=True)
    parameters = {
        "resonator.material.dampingAnisotropy": anisotropy,
        "noise.angleRandomWalk": walk,
    }
    with fmu.power_on(parameters, 1, START) as gyro:
        assert float(run.stdout.split()[1]) == turn(gyro, np.zeros(1), ticks / 1000)[0]


class Speed:
    """One model, its kernel in C and its FMU."""

    def __init__(self, folder: Path, identifier: str, seconds: float) -> None:
        root = ROOTS[identifier]
        folder.mkdir()
        self.folder = folder
        write_sources(translate(find_modelica_library(), root.model), folder, 2, root)
        self.bare = compiled(folder, "bare.c", "model.c", "core.c")
        self.host = compiled(folder, "host.c", "model.c", "core.c")
        self.fmu = GyroFmu(build_fmu(root.identifier))
        self.angles: dict[int, np.ndarray] = {}
        self.rates = 0.3 * np.sin(np.arange(round(seconds / STEP)) * 1e-3)
        self.parameters = [
            {**TYPICAL.fmu_parameters(), "seed": seed, "startAngle": START} for seed in range(3)
        ]

    def kernel(self) -> float:
        """The generated step and tick in a plain loop, with the typical gyro's parameters."""
        return seconds_per_tick(self.bare, TICKS, *self._settings(self.parameters[0]))

    def door(self) -> float:
        """One FMI step of TICKS ticks."""
        with self.fmu.power_on(TYPICAL.fmu_parameters(), 0, START) as gyro:
            period = gyro.read("samplePeriod")
            begin = time.process_time()
            gyro.instance.slave.doStep(0.0, TICKS * period)
            return (time.process_time() - begin) / TICKS

    def hosted(self) -> float:
        """Three gyros at 100 Hz, in C; leaves their angles in `out`."""
        rate, angle = (self.fmu.references[x] for x in ("angularRate", "gyroAngle"))
        lines = [f"{rate} {angle}"]
        for gyro, parameters in enumerate(self.parameters):
            pairs = self._settings(parameters)
            lines += [f"{gyro} {pairs[i]} {pairs[i + 1]}" for i in range(0, len(pairs), 2)]
        (self.folder / "settings").write_text("\n".join(lines) + "\n")
        self.rates.tofile(self.folder / "rates")
        files = (self.folder / x for x in ("settings", "rates"))
        return seconds_per_tick(self.host, *files, STEP, self.folder / "out")

    def driven(self) -> float:
        """The same through `pyhrg.fmu`; its angles must be those of the host, bit by bit."""
        angles = []
        elapsed = 0.0
        for seed in range(3):
            with self.fmu.power_on(TYPICAL.fmu_parameters(), seed, START) as gyro:
                begin = time.process_time()
                angles.append(turn(gyro, self.rates, STEP))
                elapsed += time.process_time() - begin
        assert np.array_equal(np.concatenate(angles), np.fromfile(self.folder / "out"))
        return elapsed / (3 * len(self.rates) * STEP * 1000)

    def together(self, count: int, *, one_by_one: bool = False) -> float:
        """Gyros at 100 Hz as an IMU has them, recorded together; the same bits as one by one."""
        moving = {"angularRate": self.rates[: len(self.rates) // 3, None]}
        with contextlib.ExitStack() as stack:
            gyros = [
                stack.enter_context(self.fmu.power_on(TYPICAL.fmu_parameters(), seed, START + seed))
                for seed in range(count)
            ]
            begin = time.process_time()
            if one_by_one:
                recorded = [gyro.record(moving, {}, STEP, ["gyroAngle"]) for gyro in gyros]
            else:
                recorded = record_together(
                    gyros, [moving] * count, [{}] * count, STEP, ["gyroAngle"]
                )
            elapsed = time.process_time() - begin
        angles = np.array([angle for angle, _ in recorded])
        expected = self.angles.setdefault(count, angles)
        assert np.array_equal(angles, expected)
        return elapsed / (angles.size * STEP * 1000)

    def importer(self) -> float:
        """`fmpy.simulate_fmu` on a hundredth of the record of one gyro."""
        count = max(len(self.rates) // 100, 100)
        table = np.zeros(count, dtype=[("time", float), ("angularRate", float)])
        table["time"], table["angularRate"] = np.arange(count) * STEP, self.rates[:count]
        begin = time.process_time()
        with contextlib.redirect_stdout(io.StringIO()):  # it lists the inputs that stay constant
            fmpy.simulate_fmu(
                str(self.fmu.folder),
                stop_time=count * STEP,
                output_interval=STEP,
                start_values={**TYPICAL.fmu_parameters(), "startAngle": START},
                input=table,
                output=["gyroAngle"],
            )
        return (time.process_time() - begin) / (count * STEP * 1000)

    def _settings(self, parameters: dict[str, float]) -> list[str]:
        return [
            text
            for name, value in parameters.items()
            for text in (str(self.fmu.references[name]), repr(float(value)))
        ]


def main(seconds: float) -> None:
    """Measure and print."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        gyro, slow = (Speed(folder / x, x, seconds) for x in ("HRG", "HRGSlow"))
        for header in ("arithmetic.h", "real.h"):
            (folder / header).write_bytes((gyro.folder / header).read_bytes())
        hand = compiled(folder, "handwritten.c")
        check_yardstick(hand, gyro.fmu)
        ways: dict[str, Callable[[], float]] = {
            "hand-written tick": lambda: seconds_per_tick(hand, TICKS),
            "generated kernel": gyro.kernel,
            "FMI door": gyro.door,
            "bare C host, 3 gyros at 100 Hz": gyro.hosted,
            "pyhrg.fmu, the same": gyro.driven,
            "3 gyros one by one": partial(gyro.together, 3, one_by_one=True),
            "3 gyros together": partial(gyro.together, 3),
            "4 gyros together": partial(gyro.together, 4),
            "6 gyros together": partial(gyro.together, 6),
            "8 gyros together": partial(gyro.together, 8),
            "fmpy.simulate_fmu": gyro.importer,
            "HRGSlow, a step of 0.1 s": slow.door,
        }
        best = dict.fromkeys(ways, float("inf"))
        for _ in range(REPEATS):
            for way, measure in ways.items():
                best[way] = min(best[way], measure())
    for way, cost in best.items():
        print(f"{way:<32}{cost * 1e9:9.1f} ns a tick and gyro")
    hand_cost, kernel, door, host, driven, single, *many, importer, slow_step = best.values()
    beyond = max(driven - host, 0.01 * host)
    print(f"kernel over hand-written tick      {kernel / hand_cost:6.2f}  (at most 1.3)")
    print(f"FMI door over kernel               {door / kernel:6.2f}  (at most 1.2)")
    print(f"driven over bare C host            {driven / host:6.2f}  (at most 1.2; same bits)")
    ratios = ", ".join(f"{each / single:.2f}" for each in many)
    print(f"together over one by one           {ratios}  (3, 4, 6, 8 gyros; same bits)")
    print(f"a triad for 2 h                    {many[0] * 3 * 7.2e6:6.2f}  s of a core")
    print(f"beyond the ticks: FMPy over driver {(importer - host) / beyond:6.0f}  (at least 50)")
    print(f"HRG over HRGSlow, for 0.1 s        {100 * door / slow_step:6.1f}  (at least 60)")


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 7200.0)
