"""Table 1 over temperature: what its rows are over the circumference, and with turn-on scatter."""

from dataclasses import replace

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.thermal import full_temperature
from pyhrg.bench.bias.thermal_programme import make_programme
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TABLE2, TYPICAL
from tests.agreement.paper.gyros import load_fmu

SEED = 1
FINDINGS = {
    "scale": "scale factor stability over temperature",
    "scale_mean": "scale factor over temperature",
    "stability": "bias stability over temperature",
    "repeatability": "bias repeatability over temperature",
}
"""Findings of the temperature test, -40 to 60 degC, by name of their figures."""


def figures() -> dict[str, float]:
    """The typical gyro as it is, and with the turn-on scatter of Table 2's."""
    scattered = replace(TYPICAL, turn_on_scatter=TABLE2.turn_on_scatter)
    return _measure("steady", TYPICAL) | _measure("scattered", scattered)


def _measure(name: str, device: Device) -> dict[str, float]:
    bench = Bench(load_fmu("HRGSlow"), device, seed=SEED, step=1.0)
    course = make_programme(bench)
    tests = bench.run([PowerOn(f"thermal_{n}", full_temperature.KIND, course) for n in (1, 2)])
    outcome = full_temperature.evaluate(bench.campaign(tests))
    findings = {key: outcome.finding(finding) for key, finding in FINDINGS.items()}
    circumference = full_circumference.PROCEDURE
    room = circumference.evaluate(bench.campaign(circumference.record(bench)))
    findings["room_repeatability"] = room.finding("bias repeatability")
    found = {}
    for key, finding in findings.items():
        low, high = finding.interval
        found[f"{name}_{key}"] = finding.value
        if key.endswith("repeatability"):
            found |= {f"{name}_{key}_low": low, f"{name}_{key}_high": high}
    return found
