"""What is known of a gyro before a mission: its maps by the bench, with their uncertainty, its
noise, and where its pattern starts."""

from dataclasses import dataclass

import numpy as np

from ins_eval.mission_model.bench_map import BenchMap, make_bench_map
from ins_eval.mission_model.gyro_map import NAMES, TERMS, evaluate_terms, fit_coefficients
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration import calibrate_once
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import Device

PICK_OFF_TERMS = ("cos4", "sin4")
"""Terms of the scale factor that gain mismatch and nonorthogonality of pick-offs make."""
SETTLING_ROWS = 10
"""Rows of 1 s before the first reading of a pattern that is turned. Chosen."""


@dataclass(frozen=True)
class KnownGyro:
    """A gyro as its maker knows it.

    Attributes:
        values: (3 TERMS,) terms of its bias, rad/s, of its scale-factor error, and of its error per
            virtual rotation, over the pattern angle.
        variances: (3 TERMS,) variances of their errors; 0 where nothing was measured.
        random_walk: angle random walk, rad/sqrt(s).
        rotation_noise: angle random walk per virtual rotation, sqrt(s).
        start: pattern angle at power-on, rad; None where it is not known.
        scatter: standard deviation of the angles at which the pattern starts about the commanded
            one, rad.
    """

    values: Array
    variances: Array
    random_walk: float
    rotation_noise: float
    start: float | None
    scatter: float

    def evaluate_bias(self, angle: Array) -> Array:
        """Bias by the bench's map at pattern angles, rad/s."""
        return np.asarray(evaluate_terms(angle) @ self.values[:TERMS])


def describe_gyro(
    device: Device, measured: BenchMap, rotation: BenchMap | None = None, start: float | None = None
) -> KnownGyro:
    """A gyro by its bench's maps, with the noise that the device states.

    rotation: (TERMS,) error per virtual rotation; by default that by the pick-offs alone
    (docs/schedules.md, Eq. 5).
    """
    if rotation is None:
        share = np.where(np.isin(NAMES, PICK_OFF_TERMS), -0.5, -1.0)
        scale = slice(TERMS, 2 * TERMS)
        rotation = BenchMap(share * measured.values[scale], share**2 * measured.variances[scale])
    variances = np.concatenate([measured.variances, rotation.variances])
    return KnownGyro(
        values=np.concatenate([measured.values, rotation.values]),
        variances=np.where(np.isfinite(variances), variances, 0.0),
        random_walk=device.angle_random_walk,
        rotation_noise=device.model.get("noise.virtualRotation", 0.0),
        start=start,
        scatter=device.power_on_scatter,
    )


def bench_gyro(bench: Bench, plan: Plan | None = None) -> KnownGyro:
    """A simulated gyro as its maker knows it: positions and turns both ways as in the bench's test
    `calibration`, in one power-on each, and a turn of the pattern both ways by virtual rotation."""
    measured = make_bench_map(calibrate_once(bench, plan).findings)
    rotation = measure_rotation_map(bench)
    return describe_gyro(bench.device, measured, rotation, bench.device.power_on_angle)


def measure_rotation_map(bench: Bench, rate: float = 1 * DEG) -> BenchMap:
    """(TERMS,) error of a gyro at rest per virtual rotation, by half a turn of the pattern each
    way at a rate, rad/s."""
    duration = float(np.ceil(np.pi / (bench.device.bryan_factor * rate))) + SETTLING_ROWS
    signs, power_ons = {"pos": 1.0, "neg": -1.0}, []
    for way, sign in signs.items():
        course = bench.programme().command(virtual_rotation=sign * rate).rest(duration)
        power_ons.append(PowerOn(f"rotation_{way}", "virtual_rotation", course))
    rows, errors = [], []
    for test, sign in zip(bench.log_all(power_ons), signs.values(), strict=True):
        log = test.log
        pattern = log.wave_angle[SETTLING_ROWS:]
        at = evaluate_terms(0.5 * (pattern[1:] + pattern[:-1]))
        errors.append(np.diff(log.gyro_angle[SETTLING_ROWS:]) / log.interval)
        rows.append(np.hstack([at, sign * at]))
    columns, values = np.vstack(rows), np.concatenate(errors)
    fitted = fit_coefficients(columns, values)
    residual = float(np.square(values - columns @ fitted).sum()) / (len(values) - len(fitted))
    variances = residual * np.diag(np.linalg.inv(columns.T @ columns))
    return BenchMap(fitted[TERMS:] / rate, variances[TERMS:] / rate**2)
