"""The front door of flights: an IMU along a trajectory, or a recorded log."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import xarray as xr

from ins_eval.flights.assumed_errors import assume_errors, describe_assumption
from ins_eval.flights.flight import count_still_increments, fly_runs, sample_truth
from ins_eval.flights.linear import compute_error_budget, propagate_flight_covariance
from ins_eval.flights.log_flight import LOG_TRAJECTORY, navigate_log
from ins_eval.flights.plan import HeightMode, Plan, plan_log, plan_simulation
from ins_eval.flights.report import DOCUMENT, Flight, describe_flight
from ins_eval.flights.sources import (
    NO_TRUTH,
    find_reference,
    load_imu_at_rate,
    read_placed_record,
)
from ins_eval.imu.imu import Imu
from ins_eval.results import flights
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import MovingStartError
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder
from pyhrg.common.made_by import check_identity, digest_value
from pyhrg.common.reading.files import read_unpacked


def fly(
    trajectory: str = "car",
    imu: Imu | str = "simple",
    *,
    fmu: Path | str | None = None,
    hours: float = 1.0,
    rate_hz: int | None = None,
    samples: int = 2,
    height: HeightMode = "clamped",
    align_s: float | None = 300.0,
    seed: int = 1,
    runs: int = 1,
    progress: Callable[[int, int], None] | None = None,
    out: Path | str | None = None,
    force: bool = False,
) -> Flight:
    """Fly a simulated IMU, and return errors, the linear model's one-sigma and an error budget.

    Args:
        trajectory: ready mission, mission file (TOML) or recorded drive.
        imu: an IMU, a ready one's name or its file.
        fmu: FMU of a class of one's own (`hrg build --class`) that simulates the gyros with the
            parameters of the IMU's device; None simulates them by `HRG`.
        hours: duration of a flight, in whole minutes, up to 24.
        rate_hz: rate of the increments, 10 to 2000; the IMU's own if None.
        samples: increments a navigation step, 2 to 4.
        height: what holds the height: "clamped" (the true height), "free" (nothing), or "baro" (a
            third-order loop).
        align_s: time from power-on to time 0, which contains the alignment; None starts from the
            truth.
        seed: seed of all random numbers.
        runs: number of flights, each with an IMU of its own.
        progress: function that is called with the number of flights done and the number of all.
        out: folder that the flight is written to, see `Flight.write`; None writes nothing.
        force: whether another flight in `out` may be replaced.

    Raises:
        HrgError: an argument out of range, a file that can't be used, another flight in `out`, or a
            failed alignment.
        OSError: `out` can't be written.
    """
    loaded = load_imu_at_rate(imu, rate_hz, fmu)
    plan = plan_simulation(
        loaded.interval,
        hours=hours,
        samples=samples,
        height=height,
        align_s=align_s,
        seed=seed,
        runs=runs,
    )
    _, zero = count_still_increments(plan.alignment, plan.interval)
    try:
        path = catalogue.load_trajectory(trajectory, plan.duration, zero * plan.interval)
    except MovingStartError as error:
        raise HrgError(f"{error}; or start from the truth") from error
    asked = describe_flight(plan, path.name, _name_imu(loaded), digest_value(loaded))
    _check_folder(out, force, asked)
    return _write(fly_plan(plan, path, loaded, progress), out)


def fly_plan(
    plan: Plan,
    trajectory: Trajectory,
    imu: Imu,
    progress: Callable[[int, int], None] | None = None,
) -> Flight:
    """Flights by a plan; as `fly`.

    imu: its increments have the plan's interval; progress: as in `fly`.
    """
    truth = sample_truth(plan, trajectory)
    flown = fly_runs(plan, truth, imu, progress)
    sigma = propagate_flight_covariance(plan, truth, assume_errors(imu), flown.first.alignment)
    dataset = xr.merge(
        [
            flights.compare_with_truth(flown.tracks, truth.track),
            flights.tabulate_sigmas(truth.track.time, sigma),
            flights.tabulate_own_error(flown.own, truth.track),
        ]
    )
    budget = compute_error_budget(plan, truth, imu, flown.first)
    return Flight(
        *(plan, trajectory.name, _name_imu(imu), truth.position, flown.alignments, dataset, budget),
        imu_digest=digest_value(imu),
        remark="\n".join(filter(None, (trajectory.remark, describe_assumption(imu)))),
    )


def fly_log(
    log: Path | str,
    *,
    truth: str = NO_TRUTH,
    errors_of: Imu | str = "simple",
    hours: float | None = None,
    samples: int = 2,
    height: HeightMode = "clamped",
    align_s: float = 300.0,
    latitude_deg: float | None = None,
    longitude_deg: float = 0.0,
    height_m: float = 0.0,
    out: Path | str | None = None,
    force: bool = False,
) -> Flight:
    """Navigate a recorded log by dead reckoning: align on its beginning, navigate to its end.

    Args:
        log: recorded log of an IMU; it stands until the alignment ends.
        truth: "none", "rest" (the vehicle stood), or a recorded drive that begins with the log.
        errors_of: IMU whose errors the alignment and the one-sigma assume.
        hours: duration in whole minutes; all that follows the alignment if None.
        samples, height: as in `fly`.
        align_s: duration of the alignment.
        latitude_deg, longitude_deg, height_m: place, where the log does not say it.
        out, force: as in `fly`.

    Raises:
        HrgError, OSError: as in `fly`.
    """
    path = Path(log)
    record, position = read_placed_record(path, latitude_deg, longitude_deg, height_m)
    plan = plan_log(
        path.name, record.increments, hours=hours, samples=samples, height=height, align_s=align_s
    )
    reference = find_reference(truth, position, -(plan.alignment or 0.0), plan.duration)
    imu = load_imu_at_rate(errors_of, None)
    digest = digest_value((read_unpacked(path), imu))
    _check_folder(out, force, describe_flight(plan, LOG_TRAJECTORY, path.name, digest))
    flight = navigate_log(plan, path.name, record.increments, position, imu, reference)
    return _write(replace(flight, imu_digest=digest), out)


def _name_imu(imu: Imu) -> str:
    return f"{imu.name} IMU"


def _check_folder(out: Path | str | None, force: bool, asked: Mapping[str, Any]) -> None:
    """Refuse, before the work, a folder that can't be written or has another flight."""
    if out is not None:
        check_output_folder(Path(out))
        if not force:
            check_identity(Path(out) / DOCUMENT, asked)


def _write(flight: Flight, out: Path | str | None) -> Flight:
    if out is not None:
        flight.write(out)
    return flight
