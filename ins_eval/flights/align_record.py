"""The front door of alignment: a standing vehicle's attitude from a log or a simulated IMU."""

from pathlib import Path

from ins_eval.alignment.align import MIN_DURATION
from ins_eval.alignment.align import align as align_increments
from ins_eval.alignment.measured_noise import measure_noise
from ins_eval.flights.align_report import AlignedRecord, StandingRecord
from ins_eval.flights.flight import spawn_seeds
from ins_eval.flights.plan import LONGEST_ALIGNMENT
from ins_eval.flights.sources import load_imu_at_rate, read_placed_record
from ins_eval.imu.imu import Imu
from ins_eval.mission_model.missions import SETTLING
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.arguments import check_number, check_seed
from pyhrg.common.errors import HrgError


def align(
    log: Path | str | None = None,
    *,
    imu: Imu | str = "simple",
    trajectory: str = "car",
    from_s: float = 0.0,
    seconds: float = 300.0,
    seed: int = 1,
    latitude_deg: float | None = None,
    longitude_deg: float = 0.0,
    height_m: float = 0.0,
) -> AlignedRecord:
    """Find the attitude of a standing vehicle, with its one-sigma.

    Args:
        log: recorded log of a standing vehicle; None simulates an IMU on one.
        imu: the IMU that is simulated. For a log, its biases are assumed, and its random walks are
            the prior of those that are estimated from the record.
        trajectory: mission before whose start the simulated vehicle stands.
        from_s: time in the log at which the record begins, s.
        seconds: duration of the record, s.
        seed: seed of all random numbers of a simulation.
        latitude_deg, longitude_deg, height_m: place of a log that does not say it.

    Raises:
        HrgError: an argument out of range, a file that can't be used, or a failed alignment.
    """
    check_number("seconds", seconds, MIN_DURATION, LONGEST_ALIGNMENT)
    loaded = load_imu_at_rate(imu, None)
    if log is None:
        record = simulate_record(loaded, trajectory, seconds, check_seed(seed))
    else:
        place = latitude_deg, longitude_deg, height_m
        record = read_standing_record(Path(log), place, from_s, seconds)
    alignment = align_increments(record.increments, record.position, loaded.errors)
    if log is None:
        return AlignedRecord(record, alignment, loaded.errors, loaded.name)
    noise = measure_noise(record.increments, record.position, loaded.errors)
    alignment = align_increments(record.increments, record.position, noise.errors)
    return AlignedRecord(record, alignment, noise.errors, loaded.name, noise)


def read_standing_record(
    path: Path, place: tuple[float | None, float, float], from_s: float, seconds: float
) -> StandingRecord:
    """A stretch of a log, from a time since its beginning on."""
    check_number("from_s", from_s, 0, 1e6)
    log, position = read_placed_record(path, *place)
    increments = log.increments
    begin, count = (round(time / increments.interval) for time in (from_s, seconds))
    if begin + count > len(increments):
        raise HrgError(
            f"{path}: found {increments.duration:g} s, expected {from_s + seconds:g} s at least"
        )
    return StandingRecord(path.name, increments.between(begin, begin + count), position)


def simulate_record(imu: Imu, trajectory: str, seconds: float, seed: int) -> StandingRecord:
    """What a warm IMU measures before a trajectory sets off; the true attitude is known."""
    interval = imu.interval
    warm_up, count = round(SETTLING / interval), round(seconds / interval)
    still = (warm_up + count) * interval
    truth = load_trajectory(trajectory, 60.0, still)
    increments = truth.increments(-still, interval, warm_up + count)
    (run_seed,) = spawn_seeds(seed, 1)
    measured = imu.measure(increments, run_seed).increments
    start = truth.state(0.0)
    name = f"{imu.name} IMU, {truth.name}"
    return StandingRecord(
        name, measured.between(warm_up, warm_up + count), start.position, start.mat_nb
    )
