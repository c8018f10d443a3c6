"""The gyro in the browser: the bits of the FMU, in node and Chromium; the page works by keys."""

import json
import re
import struct
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave

from fmu_build import build_fmu
from tests.modules import load_file

playwright = pytest.importorskip("playwright")

SITE = Path(__file__).parents[2] / "docs" / "site"
NODE = Path(playwright.__file__).parent / "driver" / "node"
"""The node that comes with playwright."""
STEPS = 3000
STEP_S = 0.1
OUTPUTS = ("gyroAngle", "gyroRate", "patternAngle", "amplitudeForce", "frequencyOffset")
START = {
    "startAngle": 0.3,
    "resonator.material.dampingAnisotropy": 1e-6,
    "resonator.material.frequencySplit": 0.003,
    "pickOff.gainMismatch": 4e-5,
    "noise.angleRandomWalk": 3e-8,
    "noise.pickOff": 1.7e-9,
}
DRIVE = """
(async () => {
  const gyro = new Gyro(await loadLibrary(GYRO));
  for (const [name, value] of Object.entries(START)) gyro.set(name, value);
  gyro.set("seed", 7);
  gyro.start();
  const bits = [];
  for (let i = 0; i < STEPS; i++) {
    gyro.set("angularRate", i % 100 < 50 ? 0.1 : -0.04);
    gyro.advance(STEP_S);
    for (const name of OUTPUTS) {
      const view = new DataView(new ArrayBuffer(8));
      view.setFloat64(0, gyro.get(name));
      bits.push(view.getBigUint64(0).toString());
    }
  }
  return bits;
})()
""".replace("START", json.dumps(START)).replace("STEPS", str(STEPS))
DRIVE = DRIVE.replace("STEP_S", str(STEP_S)).replace("OUTPUTS", json.dumps(OUTPUTS))


@pytest.fixture(scope="module")
def binary(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file: Path = tmp_path_factory.mktemp("gyro") / "binary.js"
    hook = load_file(SITE / "browser_gyro.py")
    file.write_text(f"globalThis.GYRO = {json.dumps(hook.make_binary())};")
    return file


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The bits of the same run by the native library."""
    folder = tmp_path_factory.mktemp("native")
    build_fmu("HRGSlow", out=folder / "gyro.fmu")
    description = fmpy.read_model_description(str(folder / "gyro.fmu"))
    numbers = {v.name: v.valueReference for v in description.modelVariables}
    gyro = FMU2Slave(
        guid=description.guid,
        unzipDirectory=fmpy.extract(str(folder / "gyro.fmu"), str(folder / "open")),
        modelIdentifier="HRGSlow",
    )
    gyro.instantiate()
    gyro.setupExperiment(startTime=0.0)
    gyro.setReal([numbers[name] for name in START], list(START.values()))
    gyro.setInteger([numbers["seed"]], [7])
    gyro.enterInitializationMode()
    gyro.exitInitializationMode()
    bits, time = [], 0.0
    for i in range(STEPS):
        gyro.setReal([numbers["angularRate"]], [0.1 if i % 100 < 50 else -0.04])
        gyro.doStep(time, STEP_S)
        time += STEP_S
        values = gyro.getReal([numbers[name] for name in OUTPUTS])
        bits += [str(struct.unpack(">Q", struct.pack(">d", value))[0]) for value in values]
    gyro.freeInstance()
    return bits


def test_node_gives_the_same_bits(binary: Path, native: list[str]) -> None:
    script = binary.read_text() + (SITE / "gyro" / "gyro.js").read_text()
    script += f"\n{DRIVE.strip()}.then((bits) => console.log(bits.join(' ')));"
    run = subprocess.run([NODE, "-"], input=script, capture_output=True, text=True, check=True)
    assert run.stdout.split() == native
    assert len(set(native)) > STEPS


@pytest.fixture
def page(binary: Path, browser: Any, tmp_path: Path) -> Iterator[Any]:
    """A page that has what the site's page has, without the site around it."""
    text = (SITE.parent / "gyro.md").read_text(encoding="utf-8").partition("<div")[2]
    for name in ("gyro.js", "page.js"):
        text = text.replace(f"site/gyro/{name}", (SITE / "gyro" / name).as_uri())
    file = tmp_path / "gyro.html"
    file.write_text(f"<!DOCTYPE html><div{text}".replace("site/gyro/binary.js", binary.as_uri()))
    opened = browser.new_page(viewport={"width": 390, "height": 800})
    complaints: list[str] = []
    opened.on("console", lambda message: complaints.append(message.text))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.goto(file.as_uri())
    opened.wait_for_function("turning !== null")
    yield opened
    assert complaints == []
    opened.close()


@pytest.mark.needs("chromium")
def test_chromium_gives_the_same_bits(page: Any, native: list[str]) -> None:
    assert page.evaluate(DRIVE.strip()) == native


@pytest.mark.needs("chromium")
def test_a_map_is_worth_its_harmonics(page: Any) -> None:
    """0.1 deg/h of the fourth harmonic, 0.02 of the second, and a mean that is taken out."""
    error, second, fourth = page.evaluate(
        """() => {
          const map = (a) => 0.3 + 0.1 * Math.sin(4 * a) - 0.02 * Math.cos(2 * a);
          const biases = Array.from({ length: 24 }, (_, i) => map((i * Math.PI) / 24));
          return [predictError(biases), GYRO.worth[2], GYRO.worth[4]];
        }"""
    )
    assert error == pytest.approx(np.hypot(0.1 * fourth, 0.02 * second), rel=1e-9)
    assert 20 < fourth < 200, "0.01 deg/h all the time makes about 1 nmi/h"


@pytest.mark.needs("chromium")
def test_both_tests_run_by_keyboard(page: Any) -> None:
    """Uneven damping shows over the circumference and not at a fixed position."""
    slider = page.locator("#mechanisms input").first
    slider.focus()
    slider.press("End")
    page.locator("#run").focus()
    page.keyboard.press("Enter")
    page.wait_for_function("document.getElementById('verdict').textContent")
    figures = re.findall(r"([\d.]+) deg/h[. ,]", page.inner_text("#verdict"))
    assert float(figures[1]) > 100 * float(figures[0])
    page.locator("#rate").focus()
    page.keyboard.press("Home")
    page.wait_for_function("tableAngle < 0")
