"""Gyros whose electronics estimate the change of their map, simulated by the FMU at 1 kHz."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.stats import chi2

import pyhrg
from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import TERMS
from pyhrg.witness.estimator import CORRECTED
from pyhrg.witness.filter import compute_whiteness
from pyhrg.witness.information import compute_maps_response
from pyhrg.witness.mechanisms import COUNT, change_device
from pyhrg.witness.responses import Responses
from tests.pyhrg.witness.flights import (
    GYRO,
    INTERVAL,
    PRIOR,
    RISE,
    compute_rms,
    draw_changes,
    fly,
    record_flight,
)

FLIGHTS, DURATION = 4, 600.0
CHANGES = [draw_changes(PRIOR, np.random.default_rng(seed)) for seed in range(FLIGHTS)]
CHANGE = [f"controller.estimator.change[{place}]" for place in (1, 2, 3)]
STATES = ["controller.estimator.correction", *CHANGE, "mapFollowed"]
INNOVATION = "controller.estimator.estimate[91]"
WHITENESS = ["controller.estimator.whiteness[4]", "controller.estimator.whiteness[5]"]


@dataclass(frozen=True)
class Corrected:
    """A flight whose electronics correct the map: (n, 7) angles of gyro and pattern, correction and
    change of the map, and whether it is followed, at the rows' ends; (n, 3) forces."""

    rows: Array
    forces: Array

    def list_map(self) -> Array:
        """(TERMS,) change of the bias map that is taken out at the end, rad/s."""
        found = np.zeros(TERMS)
        found[CORRECTED] = self.rows[-1, 3:6]
        return found


@pytest.fixture(scope="module")
def correcting() -> GyroFmu:
    return GyroFmu(build_fmu("HRGSelfCorrecting"))


@pytest.fixture(scope="module")
def parameters() -> dict[str, float]:
    return pyhrg.prepare_estimator(GYRO, PRIOR)


def correct(fmu: GyroFmu, changes: Array, seed: int, parameters: dict[str, float]) -> Corrected:
    """A flight with a self-test of two minutes."""
    device = replace(change_device(GYRO, changes), model=parameters)
    time = np.arange(0.0, DURATION, INTERVAL)
    rows, forces, _ = record_flight(fmu, device, time, seed, STATES, self_test=True)
    return Corrected(rows, forces)


@pytest.fixture(scope="module")
def corrected(correcting: GyroFmu, parameters: dict[str, float]) -> list[Corrected]:
    return [correct(correcting, each, seed, parameters) for seed, each in enumerate(CHANGES)]


def test_electronics_correct_the_map(corrected: list[Corrected], responses: Responses) -> None:
    """Less than a third of the change since the calibration is left. The correction of another gyro
    does harm."""
    true = np.array(CHANGES) @ compute_maps_response(responses, RISE)[:TERMS].T
    found = np.array([each.list_map() for each in corrected])
    moved = compute_rms(true)
    assert compute_rms(found - true) < 0.3 * moved
    assert compute_rms(np.roll(found, -1, axis=0) - true) > moved
    assert all(each.rows[-1, 6] == 1 for each in corrected)


def test_electronics_test_their_innovations(
    correcting: GyroFmu, parameters: dict[str, float]
) -> None:
    """The sums are those of the log's test. Where forces hold what no state makes, the change is
    the expected one, and an output says so."""
    device = replace(change_device(GYRO, CHANGES[0]), model=parameters)
    turned = replace(device, drive_frame_rotation=device.drive_frame_rotation + 3e-4)
    time, names = np.arange(0.0, 200.0, INTERVAL), [*CHANGE, "mapFollowed", INNOVATION, *WHITENESS]
    for each, is_followed in ((device, True), (turned, False)):
        rows, _, _ = record_flight(correcting, each, time, 0, names, self_test=True)
        ends = rows[round(5 / INTERVAL) :: round(5 / INTERVAL)]
        innovations = ends[4:, 6, None]
        assert chi2.sf(*ends[-1, 7:9]) == pytest.approx(compute_whiteness(innovations))
        assert ends[-1, 5] == is_followed
        expected = [parameters[f"controller.estimator.ageing[{n}]"] for n in (1, 2, 3)]
        assert np.array_equal(ends[-1, 2:5], expected) != is_followed


def test_a_gyro_that_corrects_itself_is_simulated(parameters: dict[str, float]) -> None:
    gyro = replace(GYRO, model=parameters, pickoff_gain_mismatch=0.0)
    own, plain = (
        pyhrg.simulate(each, duration_s=60, model=model, virtual_rotation_deg_per_s=5.0)
        for each, model in ((gyro, "HRGSelfCorrecting"), (replace(gyro, model={}), "HRG"))
    )
    assert np.array_equal(own.pattern_angle, plain.pattern_angle)
    assert np.any(own.gyro_angle != plain.gyro_angle)
    assert set(own) - set(plain) == {"map_followed"}


def test_an_unchanged_gyro_is_not_harmed(
    correcting: GyroFmu, parameters: dict[str, float], responses: Responses
) -> None:
    """Where nothing changed, the correction is below a fifth of what a drift changes."""
    drifts = np.array(CHANGES) @ compute_maps_response(responses, RISE)[:TERMS].T
    found = correct(correcting, np.zeros(COUNT), 0, parameters).list_map()
    assert compute_rms(found) < 0.2 * compute_rms(drifts)


def test_electronics_correct_the_output_alone(
    fmu: GyroFmu, correcting: GyroFmu, corrected: list[Corrected]
) -> None:
    """Forces and pattern have the bits of the plain gyro. So has the output with the estimator's
    default parameters; with others it differs by the integral of the change."""
    log = fly(fmu, change_device(GYRO, CHANGES[0]), DURATION, 0, self_test=True)
    plain = correct(correcting, CHANGES[0], 0, {})
    for each in (plain, corrected[0]):
        assert np.array_equal(each.rows[:, 1], log.wave_angle)
        assert np.array_equal(each.forces[:, 0], log.amplitude_force)
    assert np.array_equal(plain.rows[:, 0], log.gyro_angle)
    difference = log.gyro_angle - corrected[0].rows[:, 0]
    assert difference == pytest.approx(corrected[0].rows[:, 2], abs=1e-12)


def test_an_estimator_without_noise_is_refused() -> None:
    with pytest.raises(HrgError, match="angle_random_walk: found 0"):
        pyhrg.prepare_estimator(GYRO.without_noise(), PRIOR)
