"""Whether the 1-sigma of an HRG triad holds: NEES of its flights in the ready missions.

    python -m benchmarks.nees [mission ...]

Each flight of `typical-hrg` has gyros with axes, turn-on angle and noise of its own, simulated by
their FMU; seed 1, 20 min (a missile's 12, the turning turntable's 1), alignment 300 s; in flight
and on that turntable from the true start. The normalized estimation error squared (Bar-Shalom, Li
and Kirubarajan 2001, section 5.4.2) is that of position (north, east) and of attitude at the end,
by the linear model's covariance, over its degrees of freedom: 1 if it holds. Its interval is
chi-square's at 95 %. The last columns are without the pick-off map. Half an hour for all.
"""

import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.stats import chi2

from ins_eval.common.state import TrackError, track_error
from ins_eval.error_model.dynamics import ATTITUDE
from ins_eval.flights.assumed_errors import AssumedErrors, assume_errors
from ins_eval.flights.flight import Runs, Truth, count_still_increments, fly_runs, sample_truth
from ins_eval.flights.linear import propagate_flight_covariance
from ins_eval.flights.plan import Plan, plan_simulation
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import list_trajectories, load_trajectory

IMU = "typical-hrg"
RUNS = 50
MINUTES = {"missile": 12, "turntable": 1}
"""Length of a flight; 20 min where none is stated."""
FROM_TRUTH = ("weaving", "great-circle", "turntable")
TURNTABLE = """
# Turns to and fro, ten turns each way.
start = { latitude_deg = 48, longitude_deg = 11 }
course = [
  { kind = "turntable", turn_deg = 3600, rate_deg_s = 20 },
  { kind = "turntable", turn_deg = -3600, rate_deg_s = 20 },
]
repeat = true
"""


def sample(name: str, runs: int = RUNS) -> tuple[Plan, Truth]:
    """Plan and truth of a mission's flights."""
    plan = plan_simulation(
        load_imu(IMU).interval,
        hours=MINUTES.get(name, 20) / 60,
        align_s=None if name in FROM_TRUTH else 300.0,
        runs=runs,
    )
    _, zero = count_still_increments(plan.alignment, plan.interval)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "turntable.toml"
        path.write_text(TURNTABLE)
        source = path if name == "turntable" else name
        return plan, sample_truth(
            plan, load_trajectory(source, plan.duration, zero * plan.interval)
        )


def without_pick_off_map(assumed: AssumedErrors) -> AssumedErrors:
    """Assumed errors as they were before."""
    kept = [i for i, e in enumerate(assumed.effects) if not e.family.startswith("pick-off")]
    effects = tuple(assumed.effects[i] for i in kept)
    return replace(assumed, effects=effects, deviations=assumed.deviations[kept])


def compute_nees(plan: Plan, truth: Truth, flown: Runs, assumed: AssumedErrors) -> Iterator[float]:
    """NEES of position and of attitude at the end, over their degrees of freedom."""
    alignment = flown.first.alignment
    covariance = propagate_flight_covariance(plan, truth, assumed, alignment)[-1]
    errors = [track_error(track, truth.track) for track in flown.tracks]
    yield _average(np.array([_level(error) for error in errors]), covariance[:2, :2])
    attitude = np.array([error.attitude[-1] for error in errors])
    yield _average(attitude, covariance[ATTITUDE, ATTITUDE])


def _level(error: TrackError) -> np.ndarray:
    return np.asarray(error.position[-1, :2])


def _average(errors: np.ndarray, covariance: np.ndarray) -> float:
    return float(np.einsum("ri,ij,rj->", errors, np.linalg.inv(covariance), errors) / errors.size)


def main(names: list[str]) -> None:
    """Print a row a mission."""
    low, high = (np.array(chi2.interval(0.95, RUNS * k)) / (RUNS * k) for k in (2, 3))
    print(f"{RUNS} runs of {IMU}; 95 %: position {low.round(2)}, attitude {high.round(2)}")
    print(f"{'':20}{'position':>10}{'attitude':>10}{'without the pick-off map':>30}")
    for name in names:
        plan, truth = sample(name)
        imu = load_imu(IMU)
        flown = fly_runs(plan, truth, imu)
        assumed = assume_errors(imu)
        found = [*compute_nees(plan, truth, flown, assumed)]
        found += compute_nees(plan, truth, flown, without_pick_off_map(assumed))
        print(f"{name:20}" + "".join(f"{value:10.2f}" for value in found), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:] or [*list_trajectories(), "turntable"])
