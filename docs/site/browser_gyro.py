"""A hook of the documentation site: the gyro's FMU as WebAssembly, for the page that runs it."""

import base64
import json
import subprocess
import tempfile
import zipfile
from pathlib import Path
from typing import Any

import fmpy
import numpy as np

from fmu_build import BuildError, build_fmu
from fmu_build.binaries.platforms import COMPILER, PORTABLE_FLAGS
from ins_eval.mission_model.gyro_map import HARMONICS
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from pyhrg import load_device
from pyhrg.common.units import DEG_PER_H, NAUTICAL_MILE

MODEL = "HRGSlow"
DEVICE = "typical"
"""Gyro that the page starts with."""
MISSION, HOURS = "car", 2.0
"""Mission whose position error the page predicts."""
FUNCTIONS = (
    *("Instantiate", "FreeInstance", "SetupExperiment", "EnterInitializationMode"),
    *("ExitInitializationMode", "SetReal", "SetInteger", "GetReal", "DoStep"),
)
"""Functions of FMI 2 that the page calls."""
WASM_FLAGS = ["-target", "wasm32-wasi", "-mexec-model=reactor", "-std=c99", "-s"]


def on_post_build(config: Any, **_: object) -> None:
    """Write the gyro into the site, as a script: a page that is read from a file may load no other
    kind of data."""
    target = Path(config.site_dir) / "site" / "gyro" / "binary.js"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(f"globalThis.GYRO = {json.dumps(make_binary())};\n", encoding="utf-8")


def make_binary() -> dict[str, object]:
    """Give the compiled FMU, the numbers of its variables, and a gyro's parameters."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        build_fmu(MODEL, out=folder / "gyro.fmu")
        description = fmpy.read_model_description(str(folder / "gyro.fmu"))
        with zipfile.ZipFile(folder / "gyro.fmu") as archive:
            archive.extractall(folder)
        wasm = compile_wasm(folder / "sources")
    variables = {v.name: v.valueReference for v in description.modelVariables}
    values = load_device(DEVICE).fmu_values()
    return {
        "wasm": base64.b64encode(wasm).decode(),
        "guid": description.guid,
        "variables": variables,
        "integers": [v.name for v in description.modelVariables if v.type == "Integer"],
        "parameters": {name: value for name, value in values.items() if name in variables},
        "worth": compute_harmonic_worth(),
    }


def compute_harmonic_worth() -> dict[int, float]:
    """Give the position error of three gyros at the mission's end, by the linear mission model.

    It is in nmi per deg/h amplitude of each harmonic of the bias maps: the rms over pattern angles
    at power-on that are independent and uniform.
    """
    weights = load_mission_weights(plan_mission(MISSION, HOURS)).gyros[-1]
    pairs = {h: weights[:, 1 + 2 * i : 3 + 2 * i] for i, h in enumerate(HARMONICS)}
    unit = DEG_PER_H / NAUTICAL_MILE
    return {h: float(np.sqrt(np.sum(pair**2) / 2)) * unit for h, pair in pairs.items()}


def compile_wasm(sources: Path) -> bytes:
    """Compile an FMU's sources to WebAssembly, by the compiler of its other binaries."""
    library = sources / "gyro.wasm"
    exports = ["-Wl,--export=malloc", *(f"-Wl,--export=fmi2{name}" for name in FUNCTIONS)]
    headers = Path(fmpy.__file__).with_name("c-code")
    command = [*COMPILER, *WASM_FLAGS, *PORTABLE_FLAGS, "-fno-sanitize=all", f"-I{headers}"]
    command += ["-o", str(library), *map(str, sorted(sources.glob("*.c"))), *exports]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise BuildError(f"the C compiler failed for WebAssembly:\n{run.stderr}")
    return library.read_bytes()
