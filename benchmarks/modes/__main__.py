"""What modes of operation buy, on the bench and in metres (docs/modes.md).

    python -m benchmarks.modes [FLIGHTS [ROWS]]

ROWS: words of the rows to compute, all by default.

Triads of two kinds of gyros, each with axes of its own. "Warmed": the device `typical`, whose map
was calibrated exactly while it was cold and is taken out by the electronics; it is used 10 K
warmer, with coefficients from the middle of what is called typical (`tests/agreement/literature`).
"As made": the same device with gain mismatches and non-orthogonalities of 1e-3, not calibrated.
Bench: output at rest without noise from 24 pattern angles, over a whole cycle: mean, and standard
deviation over the circumference, both root mean square over all gyros. Metres: radial error after
an hour of `car` with noise, from the true start, with accelerometers without errors; root mean
square with a 95 % interval (chi-square of two components a flight). Every mode has the same triads.
With two gyros on each axis, `paired_gyros.py` says how they calibrate each other, from 22 min
before the start on; the second gyros are drawn by seed 1001, and the bench shows what is left of
each map after those 22 min. Seed 1; six flights a row by default: an hour of a busy machine.
"""

import math
import sys
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

import numpy as np
from scipy.stats import chi2

from benchmarks.modes.paired_gyros import PairedGyros, calibrate_at_rest, evaluate_map
from fmu_build.bundle import build_fmu
from ins_eval.flights.fly import fly
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.device import AngleMap, Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu

FLIGHTS = 6
SEED, PARTNERS_SEED = 1, 1001
HOURS = 1.0
ANGLES = np.arange(24) * math.pi / 24
WARMER = 10.0
"""Rise of the resonator from calibration to bench and flight, K."""
SETTLE = 30.0
WARMED = replace(
    TYPICAL,
    decay_time_per_kelvin=-0.005,
    damping_anisotropy_per_kelvin=0.005,
    pickoff_gain_per_kelvin=5e-6,
    phase_per_kelvin=5e-5,
    thermal_lag=1.0,
)
AS_MADE = replace(
    TYPICAL,
    pickoff_gain_mismatch=1e-3,
    pickoff_nonorthogonality=1e-3,
    drive_gain_mismatch=1e-3,
    drive_nonorthogonality=1e-3,
)
WARM = {"resonator.environment.selfHeating": WARMER}
HELD = {"model": {"controller.forceToRebalance": 1.0}}
PUMP = {"parametric_share": 1.0}
UNEVEN = {**PUMP, "pump_anisotropy": 1e-4, "pump_axis": 30 * DEG}
DITHER = {"sweep_angle": 90 * DEG, "sweep_time": 65.0}
"""At 5 deg/s of input rate."""
SLOW_DITHER = {"sweep_angle": 90 * DEG, "sweep_time": 325.0}
REVERSAL = {**HELD, "sweep_angle": 45 * DEG, "sweep_time": 6.5, "sweep_rest": 58.5}
"""At 25 deg/s of input rate, a tenth of the time."""
ROWS: dict[tuple[str, str], dict[str, Any]] = {
    ("warmed", "whole-angle"): {},
    ("warmed", "parametric drive"): PUMP,
    ("warmed", "dither, 90 deg in 65 s"): DITHER,
    ("warmed", "dither, 90 deg in 325 s"): SLOW_DITHER,
    ("warmed", "dither in 65 s and parametric drive"): {**DITHER, **PUMP},
    ("warmed", "force to rebalance"): HELD,
    ("warmed", "mode reversal every 65 s"): REVERSAL,
    ("warmed", "two gyros an axis"): {},
    ("as made", "whole-angle"): {},
    ("as made", "parametric drive"): PUMP,
    ("as made", "parametric drive, uneven by 1e-4"): UNEVEN,
    ("as made", "dither in 65 s"): DITHER,
    ("as made", "dither in 65 s and parametric drive"): {**DITHER, **PUMP},
    ("as made", "two gyros an axis"): {},
    ("as made", "two gyros an axis and parametric drive"): PUMP,
}
PAIRED = "two gyros an axis"
"""Modes that begin so have a second gyro on each axis."""


def simulate_bias(device: Device) -> Array:
    """(24,) output at rest without noise over a cycle of the sweep, after another, rad/s."""
    quiet = device.without_noise()
    cycle = 2 * (quiet.sweep_time + quiet.sweep_rest) if quiet.sweep_angle else SETTLE
    gyro_fmu, rates, still = GyroFmu(build_fmu("HRGSlow")), [], {"angularRate": np.zeros((2, 1))}
    for angle in ANGLES:
        parameters = quiet.fmu_parameters()
        with gyro_fmu.power_on(parameters, seed=0, start_angle=float(angle)) as gyro:
            ends, _ = gyro.record(still, {}, cycle, ["gyroAngle"])
        rates.append((ends[1, 0] - ends[0, 0]) / cycle)
    return np.array(rates)


def calibrate(device: Device) -> Device:
    """The gyro, warm, with electronics that take out the map that it has while it is cold and its
    pattern is left alone."""
    bias = simulate_bias(replace(device, sweep_angle=0.0, model={}))
    terms = {"mean": float(np.mean(bias))}
    for order in (4, 8):
        terms[f"cos{order}"] = 2 * float(np.mean(bias * np.cos(order * ANGLES)))
        terms[f"sin{order}"] = 2 * float(np.mean(bias * np.sin(order * ANGLES)))
    model = {**TYPICAL.model, **device.model, **WARM}
    return replace(device, bias_map=AngleMap(**terms), model=model)


def draw_triads(
    kind: str, changes: Mapping[str, Any], count: int, seed: int = SEED
) -> list[list[Device]]:
    """Gyros of a kind; the same ones in every mode."""
    generator = np.random.default_rng(seed)
    device = WARMED if kind == "warmed" else AS_MADE
    drawn = [[device.another(generator) for _ in "xyz"] for _ in range(count)]
    changed = [[replace(gyro, **changes) for gyro in triad] for triad in drawn]
    if kind == "as made":
        return changed
    return [[calibrate(gyro) for gyro in triad] for triad in changed]


def find_remainders(triad: list[Device], partners: list[Device], seed: int) -> list[Array]:
    """(24,) bias less what each pair knows of it after a rest, rad/s, of each of the six gyros."""
    gyro_fmu, remainders = GyroFmu(build_fmu()), []
    for pair in zip(triad, partners, strict=True):
        known = calibrate_at_rest(gyro_fmu, pair, seed)
        remainders += [
            simulate_bias(gyro) - evaluate_map(coefficients, ANGLES)
            for gyro, coefficients in zip(pair, known, strict=True)
        ]
    return remainders


def fly_triad(triad: list[Device], partners: list[Device], seed: int) -> float:
    """Radial position error at the end, m; partners: none, or the second gyros."""
    names = [f.name for f in fields(Device)]
    own = tuple({name: getattr(gyro, name) for name in names} for gyro in triad)
    stated: dict[str, Any] = {"own_axes": False, "differences": own, "calibrated": False}
    gyros = FmuGyros(triad[0], **stated)
    if partners:
        gyros = PairedGyros(triad[0], **stated, partners=tuple(partners))
    flight = fly("car", Imu(gyros), hours=HOURS, align_s=None, seed=seed)
    return float(flight.dataset["radial_error"].isel(time=-1, run=0))


def find_rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def main(flights: int, rows: str) -> None:
    """Print a row as each is done."""
    print("| gyros | mode | mean, deg/h | over the circumference, deg/h | after an hour, m |")
    print("|---|---|---|---|---|")
    for (kind, mode), changes in ROWS.items():
        if rows not in f"{kind} {mode}":
            continue
        triads, partners = draw_triads(kind, changes, flights), [[] for _ in range(flights)]
        biases = [simulate_bias(g) for triad in triads for g in triad]
        if mode.startswith(PAIRED):
            partners = draw_triads(kind, changes, flights, PARTNERS_SEED)
            paired = enumerate(zip(triads, partners, strict=True))
            biases = [b for i, pair in paired for b in find_remainders(*pair, SEED + i)]
        bias = np.array(biases) / DEG_PER_H
        flown = enumerate(zip(triads, partners, strict=True))
        errors = np.array([fly_triad(*each, SEED + i) for i, each in flown])
        degrees = 2 * flights
        low, high = find_rms(errors) * np.sqrt(degrees / chi2.ppf([0.975, 0.025], degrees))
        means, spreads = find_rms(np.mean(bias, axis=1)), find_rms(np.std(bias, axis=1))
        print(
            f"| {kind} | {mode} | {means:.4f} | {spreads:.4f} "
            f"| {find_rms(errors):.0f} ({low:.0f} to {high:.0f}) |",
            flush=True,
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else FLIGHTS, " ".join(sys.argv[2:]))
