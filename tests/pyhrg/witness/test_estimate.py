"""Maps that are estimated from flights of drifted gyros, simulated by the FMU at 1 kHz."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.stats import chi2

import pyhrg
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroFmu
from pyhrg.records.log import Log
from pyhrg.witness.design import TERMS
from pyhrg.witness.fit import FittedChanges, Flown, fit_changes
from pyhrg.witness.information import compute_maps_response, compute_normalized_square
from pyhrg.witness.mechanisms import change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import Responses
from tests.pyhrg.witness.flights import (
    GYRO,
    PRIOR,
    RISE,
    burst,
    draw_changes,
    fly,
)

FLIGHTS, DURATION = 4, 600.0
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
    """Two stages leave an error of what `HRG` shows beyond `HRGSlow`, and the forces alone do not
    show it."""
    monkeypatch.setattr("pyhrg.witness.fit.STAGES", 2)
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
