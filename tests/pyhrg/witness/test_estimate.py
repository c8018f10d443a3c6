"""Maps that are estimated from flights of drifted gyros, simulated by the FMU at 1 kHz."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.stats import chi2

import pyhrg
from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroFmu
from pyhrg.records.log import Log
from pyhrg.witness.design import TERMS
from pyhrg.witness.estimator import CORRECTED
from pyhrg.witness.filter import compute_whiteness
from pyhrg.witness.fit import FittedChanges, Flown, fit_changes
from pyhrg.witness.information import compute_maps_response, compute_normalized_square
from pyhrg.witness.mechanisms import COUNT, change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import Responses
from tests.pyhrg.witness.flights import (
    GYRO,
    INTERVAL,
    PRIOR,
    RISE,
    burst,
    compute_rms,
    draw_changes,
    fly,
    record_flight,
)

FLIGHTS, DURATION = 6, 600.0
DRIFTS = np.diag(PRIOR.covariance) > 0


@dataclass(frozen=True)
class Flight:
    """A flight: what truly changed, its log, what the log tells."""

    changes: Array
    log: Log
    fitted: FittedChanges


@pytest.fixture(scope="module")
def flights(fmu: GyroFmu, slow_fmu: GyroFmu, responses: Responses) -> list[Flight]:
    """Flights with a self-test of two minutes."""
    changes = [draw_changes(PRIOR, np.random.default_rng(seed)) for seed in range(FLIGHTS)]
    logs = [
        fly(fmu, change_device(GYRO, each), DURATION, seed, self_test=True)
        for seed, each in enumerate(changes)
    ]
    found = fit(fmu, slow_fmu, logs, responses)
    return [Flight(*each) for each in zip(changes, logs, found, strict=True)]


def fit(
    fmu: GyroFmu, slow_fmu: GyroFmu, logs: list[Log], responses: Responses
) -> list[FittedChanges]:
    gyros = [Flown(GYRO, read_witnesses(log, GYRO), PRIOR, responses) for log in logs]
    return fit_changes(fmu, slow_fmu, gyros)


def test_nees_is_in_its_band(flights: list[Flight]) -> None:
    """99 % band of chi-square for the changes of all flights together."""
    squares, degrees = zip(
        *(
            compute_normalized_square(each.fitted.changes - each.changes, each.fitted.covariance)
            for each in flights
        ),
        strict=True,
    )
    assert chi2.ppf(0.005, sum(degrees)) < sum(squares) < chi2.ppf(0.995, sum(degrees))


def compute_map_rms(responses: Responses, changes: list[Array]) -> float:
    """Rms over the circumference and over gyros of the bias that changes make, rad/s."""
    maps = np.array(changes) @ compute_maps_response(responses, RISE)[:TERMS].T
    return float(np.sqrt(np.mean(maps[:, 0] ** 2 + np.sum(maps[:, 1:] ** 2, axis=1) / 2)))


def test_the_map_is_told(flights: list[Flight], responses: Responses) -> None:
    """A fifth of the drift is left, and what each gyro's own channels tell of another one is worse
    than nothing."""
    drift = compute_map_rms(responses, [each.changes - PRIOR.mean for each in flights])
    left = compute_map_rms(responses, [e.fitted.changes - e.changes for e in flights])
    others = [flights[i - 1].fitted.changes - flights[i].changes for i in range(FLIGHTS)]
    assert left < 0.2 * drift
    assert compute_map_rms(responses, others) > drift
    assert min(each.fitted.p_value for each in flights) > 1e-3


def test_an_estimate_does_not_depend_on_the_others(
    fmu: GyroFmu, slow_fmu: GyroFmu, flights: list[Flight], responses: Responses
) -> None:
    """Gyros are replayed side by side until each has settled: the same bits as one by one."""
    (alone,) = fit(fmu, slow_fmu, [flights[1].log], responses)
    assert np.array_equal(alone.changes, flights[1].fitted.changes)
    assert np.array_equal(alone.covariance, flights[1].fitted.covariance)


def test_bursts_do_no_harm(
    fmu: GyroFmu, slow_fmu: GyroFmu, flights: list[Flight], responses: Responses
) -> None:
    spoilt = burst(flights[0].log, np.random.default_rng(1), 250.0, 290.0)
    (found,) = fit(fmu, slow_fmu, [spoilt], responses)
    assert found.burst_share > flights[0].fitted.burst_share
    sigma = np.sqrt(np.diag(found.covariance))[DRIFTS]
    assert np.all(np.abs(found.changes - flights[0].changes)[DRIFTS] < 4 * sigma)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda log: log.amplitude_force + 3e-7 * np.sin(2 * np.pi * log.time / 200),
        lambda log: 60 * log.amplitude_force,
        lambda log: np.minimum(log.amplitude_force, np.median(log.amplitude_force)),
    ],
    ids=["what no mechanism makes", "another unit", "saturated"],
)
def test_what_the_states_do_not_make_is_not_followed(
    flights: list[Flight], spoil: Callable[[Log], Array]
) -> None:
    """The estimate stays at the prior, and says so."""
    log = flights[0].log
    found = pyhrg.estimate_map(replace(log, amplitude_force=spoil(log)), GYRO, PRIOR)
    assert not found.is_explained
    assert np.array_equal(found.changes, PRIOR.mean)
    assert np.array_equal(found.maps_covariance, found.maps_prior)
    assert "is not followed" in found.summary


def test_an_amplitude_force_that_is_late_is_put_right(flights: list[Flight]) -> None:
    """The delay is told, and the changes are as true as they say. Who knows that there is none is
    told a map that the delay has moved."""
    log, changes = flights[0].log, flights[0].changes
    late = replace(log, amplitude_force=np.interp(log.time - 0.03, log.time, log.amplitude_force))
    found, trusting = (
        pyhrg.estimate_map(late, GYRO, PRIOR, **known) for known in ({}, {"delay_sigma": 0.0})
    )
    assert abs(found.delay - 0.03) < 3 * found.delay_sigma < 0.006
    squares = [
        compute_normalized_square(each.changes - changes, each.covariance)[0]
        for each in (found, trusting)
    ]
    assert squares[0] < chi2.ppf(0.995, DRIFTS.sum()) < squares[1]
    assert "amplitude force 0.03" in found.summary


def test_what_has_not_settled_is_not_followed(
    flights: list[Flight], monkeypatch: pytest.MonkeyPatch
) -> None:
    """One stage leaves an error of its own relative size, and the forces alone do not show it."""
    monkeypatch.setattr("pyhrg.witness.fit.STAGES", 1)
    found = pyhrg.estimate_map(flights[0].log, GYRO, PRIOR)
    assert np.array_equal(found.changes, PRIOR.mean)
    assert "has not settled: the log is not followed" in found.summary


def test_one_force_may_be_missing(
    fmu: GyroFmu, slow_fmu: GyroFmu, flights: list[Flight], responses: Responses
) -> None:
    """Without the quadrature force the changes are as true as they say, and less is known."""
    log = replace(flights[0].log, quadrature_force=np.full_like(flights[0].log.time, np.nan))
    (found,) = fit(fmu, slow_fmu, [log], responses)
    sigma, both = (np.sqrt(np.diag(x.covariance))[DRIFTS] for x in (found, flights[0].fitted))
    assert found.is_explained
    assert np.all(np.abs(found.changes - flights[0].changes)[DRIFTS] < 4 * sigma)
    assert np.all(sigma > (1 - 1e-6) * both)
    assert np.any(sigma > 1.0001 * both)


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
    """A flight as of `flights`, with the estimator in the electronics."""
    device = replace(change_device(GYRO, changes), model=parameters)
    time = np.arange(0.0, DURATION, INTERVAL)
    rows, forces, _ = record_flight(fmu, device, time, seed, STATES, self_test=True)
    return Corrected(rows, forces)


@pytest.fixture(scope="module")
def corrected(
    correcting: GyroFmu, flights: list[Flight], parameters: dict[str, float]
) -> list[Corrected]:
    return [
        correct(correcting, flight.changes, seed, parameters) for seed, flight in enumerate(flights)
    ]


def test_electronics_correct_the_map(
    flights: list[Flight], corrected: list[Corrected], responses: Responses
) -> None:
    """Less than a third of the change since the calibration is left, and it is corrected as the
    log's estimate would, within a third of it. The correction of another gyro does harm."""
    response = compute_maps_response(responses, RISE)[:TERMS]
    true = np.array([response @ flight.changes for flight in flights])
    by_log = np.array([response @ flight.fitted.changes for flight in flights])
    found = np.array([each.list_map() for each in corrected])
    moved = compute_rms(true)
    assert compute_rms(found - true) < 0.3 * moved
    assert compute_rms(found - by_log) < 0.3 * moved
    assert compute_rms(np.roll(found, -1, axis=0) - true) > moved
    assert all(each.rows[-1, 6] == 1 for each in corrected)


def test_electronics_test_their_innovations(
    correcting: GyroFmu, flights: list[Flight], parameters: dict[str, float]
) -> None:
    """The sums are those of the log's test. Where forces hold what no state makes, the change is
    the expected one, and an output says so."""
    device = replace(change_device(GYRO, flights[0].changes), model=parameters)
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
    correcting: GyroFmu, flights: list[Flight], parameters: dict[str, float], responses: Responses
) -> None:
    """Where nothing changed, the correction is below three standard deviations of the log's
    estimate."""
    response = compute_maps_response(responses, RISE)[:TERMS]
    sigma = np.sqrt(np.diag(response @ flights[0].fitted.covariance @ response.T))
    found = correct(correcting, np.zeros(COUNT), 0, parameters).list_map()
    assert compute_rms(found) < 3 * compute_rms(sigma)


def test_electronics_correct_the_output_alone(
    correcting: GyroFmu, flights: list[Flight], corrected: list[Corrected]
) -> None:
    """Forces and pattern have the bits of the plain gyro. So has the output with the estimator's
    default parameters; with others it differs by the integral of the change."""
    log = flights[0].log
    plain = correct(correcting, flights[0].changes, 0, {})
    for each in (plain, corrected[0]):
        assert np.array_equal(each.rows[:, 1], log.wave_angle)
        assert np.array_equal(each.forces[:, 0], log.amplitude_force)
    assert np.array_equal(plain.rows[:, 0], log.gyro_angle)
    difference = log.gyro_angle - corrected[0].rows[:, 0]
    assert difference == pytest.approx(corrected[0].rows[:, 2], abs=1e-12)


def test_an_estimator_without_noise_is_refused() -> None:
    with pytest.raises(HrgError, match="angle_random_walk: found 0"):
        pyhrg.prepare_estimator(GYRO.without_noise(), PRIOR)


@pytest.mark.parametrize(
    "missing",
    [("amplitude_force", "quadrature_force"), ("frequency_offset",), ("wave_angle",)],
    ids=lambda missing: missing[0],
)
def test_a_log_without_a_channel_is_refused(
    flights: list[Flight], missing: tuple[str, ...]
) -> None:
    log = flights[0].log
    without = replace(log, **{name: np.full_like(log.time, np.nan) for name in missing})
    with pytest.raises(HrgError, match=missing[-1]):
        pyhrg.estimate_map(without, GYRO, PRIOR)


def test_a_short_log_is_refused(flights: list[Flight]) -> None:
    fields = {n: v[:300] for n, v in vars(flights[0].log).items() if isinstance(v, np.ndarray)}
    with pytest.raises(HrgError, match="expected 40 s or more"):
        pyhrg.estimate_map(replace(flights[0].log, **fields), GYRO, PRIOR)


def test_a_log_with_the_drive_off_is_refused(flights: list[Flight]) -> None:
    log = flights[0].log
    off = replace(log, drive_on=np.where(log.time > 300, 0.0, 1.0))
    with pytest.raises(HrgError, match="drive_on: found 0, expected 1"):
        pyhrg.estimate_map(off, GYRO, PRIOR)
